"""Chapter 01 in NumPy: how many nodes the perimeter of an ellipse needs.

Equal weights at equal parameters (section "A closed curve as nodes") have an error that falls at
the rate artanh(b/a) (section "Where the singularities of a curve are"). Usage: twin.py [FIGURE]
"""
import sys

import matplotlib.pyplot as plt
import numpy as np


def ellipse(a, b, N):
    """The nodes x(t_j) (01.1) and the derivatives x', x'' of the ellipse a cos t + i b sin t."""
    t = 2 * np.pi * np.arange(N) / N
    return (a * np.cos(t) + 1j * b * np.sin(t), -a * np.sin(t) + 1j * b * np.cos(t),
            -a * np.cos(t) - 1j * b * np.sin(t))


def perimeter(a, b, N):
    """The sum of the weights w_j = |x'(t_j)| 2 pi / N of the trapezoid rule (01.2)."""
    x, dx, ddx = ellipse(a, b, N)
    return np.sum(np.abs(dx)) * 2 * np.pi / N


def area(a, b, N):
    """Half of the integral of x cross dx; the cross product of u and v is Im(conj(u) v)."""
    x, dx, ddx = ellipse(a, b, N)
    return 0.5 * np.sum((np.conj(x) * dx).imag) * 2 * np.pi / N


def curvature(a, b, N):
    """The curvatures at all nodes (01.4)."""
    x, dx, ddx = ellipse(a, b, N)
    return (np.conj(dx) * ddx).imag / np.abs(dx) ** 3


def differentiate(f):
    """Multiplies the mode k of the interpolant by i k, and drops the mode -N/2."""
    k = np.fft.fftfreq(len(f), 1 / len(f))
    return np.fft.ifft(np.where(k == -len(f) / 2, 0, 1j * k) * np.fft.fft(f))


if __name__ == "__main__":
    print("perimeters", *[perimeter(2.0, 0.4, N) for N in (8, 16, 32, 64, 128)])
    print("area", area(2.0, 0.4, 32))
    print("curvature_at_tip", curvature(2.0, 0.4, 32)[0])
    t = 2 * np.pi * np.arange(24) / 24
    print("derivative", differentiate(1 / (np.cosh(0.5) - np.cos(t)))[3].real)  # of (01.7)
    for ratio in (2, 5, 20):
        N = np.arange(6, 260, 6)
        exact, d = perimeter(ratio, 1.0, 4000), np.arctanh(1 / ratio)
        line, = plt.semilogy(N, [abs(perimeter(ratio, 1.0, n) / exact - 1) for n in N],
                             "o", label=f"ellipse {ratio}:1")
        plt.semilogy(N, 0.4 * N ** -1.5 * np.exp(-d * N), "--", color=line.get_color())  # (01.8)
    plt.gca().set(ylim=(1e-16, 1), xlabel="nodes N", ylabel="relative error of the perimeter")
    plt.legend(title="dashed: $N^{-3/2}\\,e^{-dN}$")
    figure = (sys.argv + ["twin_01.png"])[1]
    plt.savefig(figure)
    print("figure", figure)
