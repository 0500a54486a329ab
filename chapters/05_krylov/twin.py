"""Chapter 05 in NumPy: GMRES needs the same number of products on every mesh.

A basis and a small least-squares problem (sections "A basis by Arnoldi's method" and "Least squares
by rotations") solve for two free circles in a flow. Usage: twin.py [FIGURE]
"""
import sys

import matplotlib.pyplot as plt
import numpy as np


def real(v):  # all components 1 of plane vectors, then all components 2
    return np.concatenate([v.real, v.imag])


def system(N, gap):
    """The reduced system (03.11) of two unit circles in the flow (x_2, x_1), and its data."""
    normal = np.tile(-np.exp(2j * np.pi * np.arange(N) / N), 2)  # out of the fluid
    centre, w = np.repeat([0, 2 + gap], N), 2 * np.pi / N
    x = centre - normal
    r = x[:, None] - x + np.eye(2 * N)
    A, turn = w * (r.conj() * normal).real / (2 * np.pi * abs(r) ** 2), r / r.conj()  # (02.6)
    np.fill_diagonal(A, w / (4 * np.pi))  # the limit (02.9) for s = -1 and kappa = 1
    np.fill_diagonal(turn, -normal ** 2)  # the square of the tangent
    B = A * turn
    layer = np.block([[A + B.real, B.imag], [B.imag, A - B.real]])
    modes = np.column_stack([real(v * (centre == c)) for c in (0, 2 + gap)
                             for v in (1 + 0 * x, 1j + 0 * x, 1j * (x - c))])
    P = modes @ modes.T / N  # (03.9); on a unit circle all motions have the mean square 1
    identity = np.eye(4 * N)
    return (layer - 0.5 * identity) @ (identity - P) - P, real(-1j * x.conj())


def gmres(A, b, tolerance):
    """The solution, and the relative residuals |r_k| / |b| (05.2) for k = 0, 1, ..."""
    V, H, residuals = (b / np.linalg.norm(b))[:, None], np.zeros((1, 0)), [1.0]
    while residuals[-1] > tolerance:
        v = A @ V[:, -1]
        h = np.zeros(V.shape[1])
        for _ in range(2):  # orthogonalise twice
            overlap = V.T @ v
            v, h = v - V @ overlap, h + overlap
        H = np.block([[H, h[:, None]], [np.zeros((1, len(h) - 1)), np.linalg.norm(v)]])  # (05.3)
        V = np.column_stack([V, v / np.linalg.norm(v)])
        e_1 = np.eye(len(H))[0]
        y = np.linalg.lstsq(H, e_1, rcond=None)[0]
        residuals.append(np.linalg.norm(e_1 - H @ y))  # (05.4), divided by |b|
    return V[:, :-1] @ y * np.linalg.norm(b), residuals


for N, style in ((48, "o"), (96, "x"), (192, "-")):
    eta, residuals = gmres(*system(N, gap=0.5), tolerance=1e-10)
    print(f"iterations_{N}", len(residuals) - 1)
    print(f"residuals_{N}", *residuals[1:8])
    plt.semilogy(residuals, style, label=f"{N} nodes on each circle")
plt.gca().set(xlabel="products with the matrix", ylabel="relative residual")
plt.legend()
figure = (sys.argv + ["twin_05.png"])[1]
plt.savefig(figure)
print("figure", figure)
