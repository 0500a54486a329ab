"""Chapter 13 in NumPy: the least eigenvalue of two circles that nearly touch.

With the blocks of single bodies as preconditioner the spectrum has a closed form (section "Two
circles in closed form"), whose least number falls like 8 g^(3/2). Usage: twin.py [FIGURE]
"""
import sys

import matplotlib.pyplot as plt
import numpy as np


def real(v):  # all components 1 of plane vectors, then all components 2
    return np.concatenate([v.real, v.imag])


def layer(x, y, normal):
    """The matrix of the double layer (02.6) of a unit circle with the nodes y at the points x."""
    w, r = 2 * np.pi / len(y), x[:, None] - y
    if x is y:
        r += np.eye(len(y))
    A, turn = w * (r.conj() * normal).real / (2 * np.pi * abs(r) ** 2), r / r.conj()
    if x is y:  # the limit (02.9), s = -1
        np.fill_diagonal(A, w / (4 * np.pi))
        np.fill_diagonal(turn, -normal ** 2)
    B = A * turn
    return np.block([[A + B.real, B.imag], [B.imag, A - B.real]])


def eigenvalues(gap, N):
    """The eigenvalues of the preconditioned system (05.10) of two free unit circles, sorted."""
    unit, distance = np.exp(2j * np.pi * np.arange(N) / N), 2 + gap
    modes = np.column_stack([real(v) for v in (1 + 0 * unit, 1j + 0 * unit, 1j * unit)])
    P, identity = modes @ modes.T / N, np.eye(2 * N)  # (03.9)
    own = (layer(unit, unit, -unit) - 0.5 * identity) @ (identity - P) - P  # (03.11)
    E_21, E_12 = (layer(unit + shift, unit, -unit) @ (identity - P) @ np.linalg.inv(own)
                  for shift in (distance, -distance))
    zero = 0 * identity
    return np.sort(np.linalg.eigvals(np.block([[identity, E_12], [E_21, identity]])).real)


def closed_form(gap, n):
    """The eigenvalues 1 - exp(-2 n alpha + asinh(n sinh 2 alpha)) of (13.2)."""
    alpha = np.arccosh(1 + gap / 2)
    return 1 - np.exp(-2 * n * alpha + np.arcsinh(n * np.sinh(2 * alpha)))


for gap, N in ((2.0, 48), (1.0, 72), (0.5, 96), (0.2, 192)):
    found = eigenvalues(gap, N)
    print(f"least_and_largest_{gap}", found[0], found[-1])
    plt.loglog(gap, found[0], "ko", label="matrix" if gap == 2.0 else None)
gaps = np.geomspace(1e-4, 4, 60)
for n in (2, 3, 4):
    plt.loglog(gaps, closed_form(gaps, n), label=f"(13.2), n = {n}")
plt.loglog(gaps, 8 * gaps ** 1.5, "--", label="$8\\,g^{3/2}$")
plt.gca().set(xlabel="gap g", ylabel="least eigenvalues of the preconditioned operator")
plt.legend()
figure = (sys.argv + ["twin_13.png"])[1]
plt.savefig(figure)
print("figure", figure)
