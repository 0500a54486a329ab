"""Chapter 03 in NumPy: an ellipse that a force pulls straight down slides sideways.

The mean rigid motion of the density is the motion of the body, so that the density is the only
unknown (section "The reduced form"). Usage: twin.py [FIGURE]
"""
import sys

import matplotlib.pyplot as plt
import numpy as np

N, a, b, theta, mu, gauge = 128, 1.0, 0.4, 0.6, 1.3, 20.0
t = 2 * np.pi * np.arange(N) / N
x = np.exp(1j * theta) * (a * np.cos(t) + 1j * b * np.sin(t))
dx = np.exp(1j * theta) * (-a * np.sin(t) + 1j * b * np.cos(t))
w, n = 2 * np.pi / N * abs(dx), 1j * dx / abs(dx)  # (01.2), and (01.3) with s = -1
kappa = (dx.conj() * -x).imag / abs(dx) ** 3  # (01.4); on an ellipse x'' = -x


def real(v):  # all components 1 of plane vectors, then all components 2
    return np.concatenate([v.real, v.imag])


def layer(z, on_curve=False):
    """The matrix of D (02.6) at targets z; in complex form D eta = A eta + B conj(eta)."""
    r = z[:, None] - x + (np.eye(N) if on_curve else 0)
    A, turn = w * (r.conj() * n).real / (2 * np.pi * abs(r) ** 2), r / r.conj()
    if on_curve:  # the limit (02.9), s = -1
        np.fill_diagonal(A, kappa * w / (4 * np.pi))
        np.fill_diagonal(turn, dx / dx.conj())
    B = A * turn
    return np.block([[A + B.real, B.imag], [B.imag, A - B.real]])


def loads(r, F, L):
    """Stokeslet and rotlet of (03.4)."""
    log = np.log(abs(r) / gauge)
    return (r * ((r.conj() * F).real + 1j * L) / abs(r) ** 2 - log * F) / (4 * np.pi * mu)


modes = np.column_stack([real(v) for v in (1 + 0 * x, 1j + 0 * x, 1j * x)])  # rigid motions
weighted = modes.T * np.tile(w, 2)
means = np.linalg.solve(weighted @ modes, weighted)  # U_1, U_2 and omega of a density (03.9)
rest = np.eye(2 * N) - modes @ means
matrix = (layer(x, on_curve=True) - 0.5 * np.eye(2 * N)) @ rest - modes @ means  # (03.11)
for name, data in (("force_1", -loads(x, 1, 0)), ("force_2", -loads(x, 1j, 0)),
                   ("torque", -loads(x, 0, 1)), ("shear", -x.imag + 0j)):  # u = (x_2, 0)
    print(f"motion_by_{name}", *(means @ np.linalg.solve(matrix, real(data))))
eta = np.linalg.solve(matrix, -real(loads(x, -1j, 0)))
U = complex(*(means @ eta)[:2])
z = np.linspace(-2.5, 2.5, 100) + 1j * np.linspace(-2, 2, 80)[:, None]
u = (np.array([1, 1j]) @ (layer(z.ravel()) @ rest @ eta).reshape(2, -1)
     + loads(z.ravel(), -1j, 0)).reshape(z.shape) - U
plt.streamplot(z[0].real, z[:, 0].imag, u.real, u.imag, color="steelblue", density=1.4)
plt.fill(x.real, x.imag, color="black", zorder=3)
plt.quiver(0, 0, U.real, U.imag, color="orange", zorder=4)
plt.gca().set(aspect="equal", title="streamlines seen from the ellipse; arrow: its velocity")
figure = (sys.argv + ["twin_03.png"])[1]
plt.savefig(figure)
print("figure", figure)
