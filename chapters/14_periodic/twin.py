"""Chapter 14 in NumPy: the viscosity of an array of free disks in a sheared cell.

The periodic kernels are sums over rows of images, which are cotangents, with a linear term that
makes the sums periodic (section "Rows and disks"). Usage: twin.py [FIGURE]
"""
import sys

import matplotlib.pyplot as plt
import numpy as np

N, a, rows = 96, np.sqrt(0.3 / np.pi), np.arange(-7, 8)  # rows beyond these add less than rounding
n = -np.exp(2j * np.pi * np.arange(N) / N)  # normals out of the fluid
x, w = -a * n, 2 * np.pi * a / N


def real(v):  # all components 1 of plane vectors, then all components 2
    return np.concatenate([v.real, v.imag])


def kernels(z, shear):
    """F and g by rows of images (14.7), for the lattice of 1 and shear + i."""
    y, s = z.imag[..., None] - rows, np.pi * (z[..., None] - rows * (shear + 1j))
    F = 2j * np.pi * z.imag + np.sum(np.pi / np.tan(s), axis=-1)
    return F, F - 2j * np.pi ** 2 * np.sum(y / np.sin(s) ** 2, axis=-1)


def layer(shear):
    """The matrix of the double layer (14.4), D eta = A eta + B conj(eta)."""
    F, g = kernels(x[:, None] - x + np.eye(N) / 2, shear)  # for any vector on the diagonal
    A, B = w * (n * F).real / (2 * np.pi), w * (n * F.conj() + (n * g).conj()) / (4 * np.pi)
    np.fill_diagonal(A, w / (4 * np.pi * a))  # the limit (02.9); all other images cancel
    np.fill_diagonal(B, -w * n ** 2 / (4 * np.pi * a))
    return np.block([[A + B.real, B.imag], [B.imag, A - B.real]])


modes = np.column_stack([real(v) for v in (1 + 0 * x, 1j + 0 * x, 1j * x)])  # rigid motions
means = np.linalg.pinv(modes)  # U_1, U_2 and omega of a density (03.9)
rest = np.eye(2 * N) - modes @ means


def free_disk(shear):
    """Rotation, added viscosity and N1 in the shear (y, 0)."""
    matrix = (layer(shear) - 0.5 * np.eye(2 * N)) @ rest - modes @ means  # (03.11)
    eta = np.linalg.solve(matrix, -real(x.imag + 0j))
    S = -w * np.sum(n * (eta[:N] + 1j * eta[N:]))  # (07.14)
    return (means @ eta)[2], S.imag, 2 * S.real


for shear in (0.0, 0.1, 0.3, 0.5):
    print(f"disk_at_{shear}", *free_disk(shear))
    sines = np.sin(np.pi * rows[rows != 0] * (shear + 1j))
    S_2 = np.pi ** 2 / 3 + np.sum((np.pi / sines) ** 2) - np.pi  # by rows, and the last term (14.8)
    print(f"sum_at_{shear}", 1 + S_2.real, S_2.imag)
omega, viscosity, N1 = np.transpose([free_disk(shear) for shear in np.linspace(0, 1, 21)])
plt.plot(np.linspace(0, 1, 21), np.transpose([viscosity, N1, omega + 0.5]),
         label=["added viscosity", "N1", "rotation + 1/2"])
plt.legend(title="over viscosity and shear rate")
figure = (sys.argv + ["twin_14.png"])[1]
plt.savefig(figure)
print("figure", figure)
