"""Chapter 07 in NumPy: the stress on a free ellipse in a straining flow, and its stresslet.

Pressure and vorticity on the surface are one Cauchy integral (section "The limit by Cauchy
integrals"); the moment of the traction equals that of the density (07.14). Usage: twin.py [FIGURE]
"""
import sys

import matplotlib.pyplot as plt
import numpy as np

N, a, b, theta, mu = 128, 1.0, 0.5, 0.5, 1.3
t = 2 * np.pi * np.arange(N) / N
x = np.exp(1j * theta) * (a * np.cos(t) + 1j * b * np.sin(t))
dx = np.exp(1j * theta) * (-a * np.sin(t) + 1j * b * np.cos(t))
w, n, tau = 2 * np.pi / N * abs(dx), 1j * dx / abs(dx), -dx / abs(dx)  # fluid on the left of tau


def real(v):  # all components 1 of plane vectors, then all components 2
    return np.concatenate([v.real, v.imag])


def along_curve(f):  # the derivative df/dx, by Fourier's method
    k = np.fft.fftfreq(N, 1 / N)
    return np.fft.ifft(np.where(k == -N / 2, 0, 1j * k) * np.fft.fft(f)) / dx


def limit_of_cauchy(f):
    """The limit of C[f] (07.7) from the fluid outside a body (06.11)."""
    quotient = (f[:, None] - f) / r
    np.fill_diagonal(quotient, along_curve(f))
    return -quotient @ dx / (1j * N)


r = x[:, None] - x + np.eye(N)
A, turn = w * (r.conj() * n).real / (2 * np.pi * abs(r) ** 2), r / r.conj()  # (02.6)
np.fill_diagonal(A, (dx.conj() * -x).imag / abs(dx) ** 3 * w / (4 * np.pi))  # (02.9), s = -1
np.fill_diagonal(turn, dx / dx.conj())
B = A * turn
modes = np.column_stack([real(v) for v in (1 + 0 * x, 1j + 0 * x, 1j * x)])  # rigid motions
weighted = modes.T * np.tile(w, 2)
means = np.linalg.solve(weighted @ modes, weighted)  # U_1, U_2, omega of a density (03.9)
layer = np.block([[A + B.real, B.imag], [B.imag, A - B.real]]) - 0.5 * np.eye(2 * N)
eta = np.linalg.solve(layer - modes @ means, -real(x.conj()))  # the flow u = (x_1, -x_2)
omega = (means @ eta)[2]
eta = np.array([1, 1j]) @ (eta - modes @ means @ eta).reshape(2, -1)
S = -mu * np.sum(w * n * eta)  # S_11 + i S_12 (07.14)
d_phi = -0.5 * limit_of_cauchy(along_curve(eta))  # (07.7); the straining flow has no phi
pressure, vorticity = -4 * mu * d_phi.real, 4 * d_phi.imag  # (07.4)
traction = -pressure * n + mu * (vorticity - 2 * omega) * tau  # after (07.8)
print("stresslets", *real(np.array([S, -0.5 * np.sum(w * traction * x)])))
print("intrinsic_viscosity", (2 * S).real / (4 * mu * np.pi * a * b))  # (07.17) with q = 2
print("pressures", *pressure[:5])
print("tractions", *traction[:5].view(float))
plt.fill(x.real, x.imag, color="lightgray")
plt.quiver(*np.split(real(x), 2), *np.split(real(traction), 2), pressure, cmap="coolwarm")
plt.colorbar(label="pressure")
plt.gca().set(aspect="equal", title="traction: force of the ellipse on the fluid")
figure = (sys.argv + ["twin_07.png"])[1]
plt.savefig(figure)
print("figure", figure)
