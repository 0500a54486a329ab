"""Chapter 02 in NumPy: the flow about an ellipse that pushes and turns the fluid.

Boundary values become a density (sections "An equation of the second kind" and "What a double layer
cannot do"), and the density a flow, accurate except near the curve. Usage: twin.py [FIGURE]
"""
import sys

import matplotlib.pyplot as plt
import numpy as np

N, a, b, mu = 64, 1.0, 0.5, 1.3
source, F, L = 0.3 + 0.1j, 1.0 - 2.0j, 0.7  # the exact flow: a force and a torque at this point
t = 2 * np.pi * np.arange(N) / N
x, dx = a * np.cos(t) + 1j * b * np.sin(t), -a * np.sin(t) + 1j * b * np.cos(t)
w, n = 2 * np.pi / N * abs(dx), 1j * dx / abs(dx)  # (01.2), and (01.3) with s = -1
kappa = (dx.conj() * -x).imag / abs(dx) ** 3  # (01.4); on an ellipse x'' = -x


def real(v):  # all components 1 of plane vectors, then all components 2
    return np.concatenate([v.real, v.imag])


def point_flow(r, F, L):
    """A Stokeslet with the gauge length 1 (02.2) plus a rotlet (02.12)."""
    return (r * ((r.conj() * F).real + 1j * L) / abs(r) ** 2 - np.log(abs(r)) * F) / 4 / np.pi / mu


def layer(z, on_curve=False):
    """The matrix of D (02.6) at targets z; in complex form D eta = A eta + B conj(eta)."""
    r = z[:, None] - x + (np.eye(N) if on_curve else 0)
    A, turn = w * (r.conj() * n).real / (2 * np.pi * abs(r) ** 2), r / r.conj()
    if on_curve:  # the limit (02.9), s = -1
        np.fill_diagonal(A, kappa * w / (4 * np.pi))
        np.fill_diagonal(turn, dx / dx.conj())
    B = A * turn
    return np.block([[A + B.real, B.imag], [B.imag, A - B.real]])


def velocity(z, eta):
    """The completed double layer (02.13), with its singularities at the centre of the ellipse."""
    return np.array([1, 1j]) @ (layer(z) @ eta).reshape(2, -1) + point_flow(z, F, L_centre)


L_centre = L + (source.conjugate() * F).imag  # the torque of the same force about the centre
modes = np.column_stack([real(v) for v in (1 + 0 * x, 1j + 0 * x, 1j * x)])  # rigid motions
weighted = modes.T * np.tile(w, 2)
P = modes @ np.linalg.solve(weighted @ modes, weighted)  # the mean rigid motion of a density
matrix = -0.5 * np.eye(2 * N) + layer(x, on_curve=True) - P
eta = np.linalg.solve(matrix, real(point_flow(x - source, F, L) - point_flow(x, F, L_centre)))
print("condition", np.linalg.cond(matrix))
print("velocities", *real(velocity(1j * (b + np.array([1.0, 0.2, 0.06])), eta)))
fine = np.linspace(0, 2 * np.pi, 10 * N)
z = np.linspace(1.01, 2.2, 120)[:, None] * (a * np.cos(fine) + 1j * b * np.sin(fine))
error = abs(velocity(z.ravel(), eta) - point_flow(z.ravel() - source, F, L)).reshape(z.shape)
plt.pcolormesh(z.real, z.imag, np.log10(error + 1e-16), vmin=-15, vmax=0, shading="gouraud")
plt.colorbar(label="power of ten of the error", orientation="horizontal")
plt.plot(x.real, x.imag, "k.", markersize=3)
figure = (sys.argv + ["twin_02.png"])[1]
plt.savefig(figure)
print("figure", figure)
