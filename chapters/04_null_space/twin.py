"""Chapter 04 in NumPy: a shaft that turns in an eccentric bushing full of oil.

The operator of the enclosing wall is singular; the term N_0 of one column and one row repairs it
(section "One column and one row"). The loads have a closed form (04.10). Usage: twin.py [FIGURE]
"""
import sys

import matplotlib.pyplot as plt
import numpy as np

N, R, e, mu, omega = 192, 2.0, 0.5, 1.0, 1.0  # shaft: radius 1, about 0; bushing: R, about i e
circle = np.exp(2j * np.pi * np.arange(N) / N)
x, dx = np.append(circle, 1j * e + R * circle), 1j * np.append(circle, R * circle)
s, kappa = np.repeat([-1, 1], N), np.repeat([1, 1 / R], N)  # side of the fluid (01.3), curvature
w, n, shaft = 2 * np.pi / N * abs(dx), -1j * s * dx / abs(dx), s < 0


def real(v):  # all components 1 of plane vectors, then all components 2
    return np.concatenate([v.real, v.imag])


def layer(z, on_curve=False):
    """The matrix of D (02.6) at targets z; in complex form D eta = A eta + B conj(eta)."""
    r = z[:, None] - x + (np.eye(2 * N) if on_curve else 0)
    A, turn = w * (r.conj() * n).real / (2 * np.pi * abs(r) ** 2), r / r.conj()
    if on_curve:  # the limit (02.9)
        np.fill_diagonal(A, -s * kappa * w / (4 * np.pi))
        np.fill_diagonal(turn, dx / dx.conj())
    B = A * turn
    return np.block([[A + B.real, B.imag], [B.imag, A - B.real]])


def loads(r, F, L):
    """Stokeslet and rotlet of (03.4), with the gauge length exp(1/2) of a held circle."""
    log = np.log(abs(r)) - 0.5
    return (r * ((r.conj() * F).real + 1j * L) / abs(r) ** 2 - log * F) / (4 * np.pi * mu)


modes = np.column_stack([real(v * shaft) for v in (1 + 0 * x, 1j + 0 * x, 1j * x)])
weighted = modes.T * np.tile(w, 2)
means = np.linalg.solve(weighted @ modes, weighted)  # U_1, U_2 and omega of the shaft's density
rest = np.eye(4 * N) - modes @ means
singular = np.column_stack([real(loads(x, *load)) for load in ((1, 0), (1j, 0), (0, 1))])
held = -4 * np.pi * mu * means  # the loads F = -4 pi mu U, L = -4 pi mu omega of (04.9)
N_0 = -np.outer(real(n * ~shaft), real(n * w * ~shaft)) / (2 * np.pi * R)  # (04.6)
matrix = (layer(x, on_curve=True) - 0.5 * np.eye(4 * N)) @ rest + singular @ held
eta = np.linalg.solve(matrix + N_0, real(1j * omega * x * shaft))
F_1, F_2, L = held @ eta
print("load_of_shaft", F_1, F_2, L)
print("condition", np.linalg.cond(matrix + N_0))
z = np.linspace(-2, 2, 80) + 1j * np.linspace(-1.5, 2.5, 80)[:, None]
u = (np.array([1, 1j]) @ (layer(z.ravel()) @ rest @ eta).reshape(2, -1)
     + loads(z.ravel(), F_1 + 1j * F_2, L)).reshape(z.shape)
u[(abs(z) < 1.1) | (abs(z - 1j * e) > R - 0.2)] = np.nan  # far enough for the plain sum
plt.streamplot(z[0].real, z[:, 0].imag, u.real, u.imag, color="steelblue", density=1.5)
plt.plot(*np.split(real(x), 2), "k.", markersize=3)
plt.gca().set(aspect="equal", title="streamlines between the shaft and the bushing")
figure = (sys.argv + ["twin_04.png"])[1]
plt.savefig(figure)
print("figure", figure)
