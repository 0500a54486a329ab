"""Chapter 08 in NumPy: the velocities of many nodes, from a few numbers.

The multipole expansion of a box, and its translation to a local expansion (sections "Goursat's
functions about a centre" and "Three translations, one matrix"). Usage: twin.py [FIGURE]
"""
import sys
from math import comb

import matplotlib.pyplot as plt
import numpy as np

j = np.arange(50)
c, R, target_centre, target_R = 1.0 + 2.0j, 0.5, 2.4 + 1.4j, 0.5
y = c + R * np.sqrt((j + 0.5) / 50) * np.exp(2.4j * j)  # fifty nodes in a disk about c
w, n, eta = 0.1 + 0 * j, np.exp(1j * j), np.cos(j) + 1j * np.sin(3 * j)
a, b = w / (4 * np.pi) * n * eta, w / (2 * np.pi) * (n.conj() * eta).real  # (08.4)
targets = target_centre + target_R * np.sqrt((j + 0.5) / 50) * np.exp(-2.4j * j)


def direct(z):  # the sum (08.1) over all nodes
    r = z[:, None] - y
    return ((n.conj() * r).real * (eta.conj() * r).real * r / abs(r) ** 4) @ w / np.pi


def multipole(p):
    """The coefficients A_k and B_k, k = 1 ... p (08.6)."""
    k, W = np.arange(1, p + 1)[:, None], (y - c) / R
    return (W ** (k - 1) @ a / R,
            -(W ** (k - 1) @ b - ((k - 1) * W.conj() * W ** np.maximum(k - 2, 0)) @ a) / R)


def local(p):
    """The coefficients lambda_l and mu_l, l = 0 ... p, of (08.7), by (08.10) and (08.11)."""
    D, k, l = target_centre - c, np.arange(1, p + 1), np.arange(p + 1)
    H = np.array([[comb(kk + ll - 1, ll) for kk in k] for ll in l], dtype=float)
    lambda_l, mu_l = ((-target_R / D) ** l * (H @ ((R / D) ** k * A)) for A in multipole(p))
    mu_l[:-1] += np.conj(D) / target_R * l[1:] * lambda_l[1:]
    return lambda_l, mu_l


def velocity(z, p):
    """The velocity of the local expansion (08.5)."""
    zeta = (z - target_centre) / target_R
    phi, psi = (np.polynomial.Polynomial(coefficients) for coefficients in local(p))
    return phi(zeta) - zeta * np.conj(phi.deriv()(zeta)) - np.conj(psi(zeta))


for name, coefficients in zip(("A", "B", "lambda", "mu"), multipole(12) + local(12)):
    print(name, *coefficients.view(float))
print("direct", *direct(targets[:3]).view(float))
print("velocity_12", *velocity(targets[:3], 12).view(float))
orders = np.arange(2, 33)
errors = [abs(velocity(targets, p) - direct(targets)).max() for p in orders]
plt.semilogy(orders, errors, "o", label="50 nodes, 50 targets")
rho = R / (abs(target_centre - c) - target_R)
plt.semilogy(orders, 0.1 * orders * rho ** orders, label="worst case: like $p\\,\\rho^p$ (08.9)")
plt.legend(title="largest error of the velocity over the order p")
figure = (sys.argv + ["twin_08.png"])[1]
plt.savefig(figure)
print("figure", figure)
