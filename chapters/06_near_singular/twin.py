"""Chapter 06 in NumPy: the velocity of a double layer at any distance from its curve.

Goursat's functions on the curve, and division by the right sum (sections "Goursat's functions" and
"Division by the right sum"), compared with the plain sum. Usage: twin.py [FIGURE]
"""
import sys

import matplotlib.pyplot as plt
import numpy as np


def body(N):
    """Nodes of an ellipse 2:1, x', weights (01.2), normals (01.3) with s = -1, and a density."""
    t = 2 * np.pi * np.arange(N) / N
    x, dx = 2 * np.cos(t) + 1j * np.sin(t), -2 * np.sin(t) + 1j * np.cos(t)
    eta = np.exp(0.5 * np.sin(t)) + 1j * np.cos(2 * t)
    return x, dx, 2 * np.pi / N * abs(dx), 1j * dx / abs(dx), eta


def plain_sum(z, N):  # the trapezoid rule for (02.6) at a target
    x, dx, w, n, eta = body(N)
    r = z - x
    return np.sum(w * (r.conj() * n).real * (r.conj() * eta).real * r / abs(r) ** 4) / np.pi


def along_curve(f, dx):  # the derivative df/dx, by Fourier's method
    k = np.fft.fftfreq(len(f), 1 / len(f))
    return np.fft.ifft(np.where(k == -len(f) / 2, 0, 1j * k) * np.fft.fft(f)) / dx


def cauchy(z, N):
    """Velocity, and pressure over the viscosity, at a target, at any distance."""
    x, dx, w, n, eta = body(N)
    r = x[:, None] - x + np.eye(N)
    quotient = (eta[:, None] - eta) / r  # of (06.11)
    np.fill_diagonal(quotient, along_curve(eta, dx))
    phi = 0.5 / (1j * N) * quotient @ dx  # (06.10) and (06.11), s = -1
    A = w * (r.conj() * n).real / (2 * np.pi * abs(r) ** 2)  # (02.6) in complex form
    np.fill_diagonal(A, (dx.conj() * -x).imag / abs(dx) ** 3 * w / (4 * np.pi))  # (02.9)
    np.fill_diagonal(r, dx)  # so that r / conj(r) is the square of the tangent there
    U = -0.5 * eta + A @ eta + (A * r / r.conj()) @ eta.conj()  # the limit (02.8)
    d_phi, chi = along_curve(phi, dx), (phi - U).conj()  # (06.12)
    W = -dx / (1j * N * (x - z))
    weights = W / (1 + np.sum(W))  # (06.14)
    u = weights @ phi - np.conj(weights @ (chi + np.conj(z - x) * d_phi))  # (06.13)
    return u, -4 * (weights @ d_phi).real


foot, normal = 2 * np.cos(0.7) + 1j * np.sin(0.7), np.cos(0.7) + 2j * np.sin(0.7)
for distance in (1.0, 1e-2, 1e-6):
    print(f"flow_at_{distance}", *np.array(cauchy(foot + distance * normal, 96)).view(float)[:3])
distances = 10.0 ** -np.arange(0, 3.6, 0.25)
exact = [plain_sum(foot + d * normal, 400000) for d in distances]
for name, flow in (("plain sum", plain_sum), ("Cauchy scheme", lambda z, N: cauchy(z, N)[0])):
    errors = np.abs([flow(foot + d * normal, 96) for d in distances] - np.array(exact))
    plt.loglog(distances * abs(normal), errors, "o-", label=f"{name}, 96 nodes")
plt.legend(loc="center left", title="error of the velocity over the distance from the curve")
figure = (sys.argv + ["twin_06.png"])[1]
plt.savefig(figure)
print("figure", figure)
