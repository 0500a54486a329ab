"""Chapter 12 in NumPy: a disk and an ellipse pass each other in a shear flow.

One linear system gives the velocities of all bodies at an instant (sections "System" and "Solver"),
and Heun's method moves the bodies (section "Motion"). Usage: twin.py [FIGURE]
"""
import sys

import matplotlib.pyplot as plt
import numpy as np

N, body = 64, np.repeat([0, 1], 64)  # nodes of each body, and the body of each node
unit = np.exp(2j * np.pi * np.arange(N) / N)
shapes = [unit, 1.2 * unit.real + 0.5j * unit.imag]  # in their own frames: nodes,
slopes = [1j * unit, -1.2 * unit.imag + 0.5j * unit.real]  # and x'; on both curves x'' = -x


def real(v):  # all components 1 of plane vectors, then all components 2
    return np.concatenate([v.real, v.imag])


def velocities(state):
    """U_1, U_2 and omega of all bodies, from a state with the rows (c_1, c_2, theta)."""
    own, dx = (np.exp(1j * state[body, 2]) * np.concatenate(f) for f in (shapes, slopes))
    x = state[body, 0] + 1j * state[body, 1] + own
    w, n = 2 * np.pi / N * abs(dx), 1j * dx / abs(dx)
    r = x[:, None] - x + np.eye(len(x))
    A, turn = w * (r.conj() * n).real / (2 * np.pi * abs(r) ** 2), r / r.conj()  # (02.6)
    np.fill_diagonal(A, (dx.conj() * -own).imag / abs(dx) ** 3 * w / (4 * np.pi))  # (02.9)
    np.fill_diagonal(turn, dx / dx.conj())
    B, identity = A * turn, np.eye(2 * len(x))
    layer = np.block([[A + B.real, B.imag], [B.imag, A - B.real]]) - 0.5 * identity
    modes = np.column_stack([real(v * (body == k)) for k in (0, 1)
                             for v in (1 + 0 * x, 1j + 0 * x, 1j * own)])
    weighted = modes.T * np.tile(w, 2)
    means = np.linalg.solve(weighted @ modes, weighted)  # the motions P eta (03.9)
    matrix = layer @ (identity - modes @ means) - modes @ means  # (12.1) for free bodies
    eta = np.linalg.solve(matrix, -real(x.imag + 0j))  # in the flow u = (x_2, 0)
    return (means @ eta).reshape(state.shape)


def heun(state, h):  # the end of a step (09.4)
    first = velocities(state)
    return state + h / 2 * (first + velocities(state + h * first))


state = np.array([[-3.0, 0.8, 0.0], [3.0, -0.8, 0.6]])
print("velocities", *velocities(state).ravel())
print("state_after_a_step", *heun(state, 0.1).ravel())
states = [state]
while states[-1][0, 0] < 3:
    states.append(heun(states[-1], 0.1))
for k, color in ((0, "tab:blue"), (1, "tab:orange")):
    for c_1, c_2, theta in [state[k] for state in states[::8]]:
        outline = c_1 + 1j * c_2 + np.exp(1j * theta) * shapes[k]
        plt.fill(outline.real, outline.imag, edgecolor=color, fill=False)
    plt.plot(*np.array(states)[:, k, :2].T, ".", color=color, markersize=3)
plt.gca().set(aspect="equal", title="the disk goes right, the ellipse left")
figure = (sys.argv + ["twin_12.png"])[1]
plt.savefig(figure)
print("figure", figure)
