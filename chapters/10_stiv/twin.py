"""Chapter 10 in NumPy: a fast ellipse passes through another one, and contact is still found.

Each vertex advances only as far as its distance allows (section "Conservative advancement"); its
gap is measured from the line that it touches (section "The gap"). Usage: twin.py [FIGURE]
"""
import sys

import matplotlib.pyplot as plt
import numpy as np

delta, tolerance, unit = 0.1, 1e-9, np.exp(2j * np.pi * np.arange(120) / 120)
A, B = 1.2 * unit.real + 0.5j * unit.imag, 0.6 * unit.real + 0.9j * unit.imag  # the vertices
# Each path is c, theta, and the changes of both in the step.
path_A, path_B = (-2.3 + 0.3j, 0.2, 4.5 - 0.2j, -0.6), (0.2j, -0.1, 0.3 + 0.1j, 0.2)


def place(X, of, seen_from, tau):  # z(tau) of a vertex X, in the frame of the other body (10.2)
    (c_A, theta_A, dc_A, dtheta_A), (c_B, theta_B, dc_B, dtheta_B) = of, seen_from
    arm = np.exp(1j * (theta_A + tau * dtheta_A)) * X
    return np.exp(-1j * (theta_B + tau * dtheta_B)) * (c_A - c_B + tau * (dc_A - dc_B) + arm)


def closest(z, polygon):
    """The distance of z from a polygon, and the unit vector from the closest point to z."""
    edges = np.roll(polygon, -1) - polygon
    part = np.clip(((z - polygon) * edges.conj()).real / abs(edges) ** 2, 0, 1)
    r = min(z - polygon - part * edges, key=abs)
    return abs(r), r / abs(r)


def follow(X, of, polygon, seen_from, tau=0.0):
    """The time of first contact and the gap of a vertex; without contact, the time 1 and no gap."""
    (c_A, _, dc_A, dtheta_A), (c_B, _, dc_B, dtheta_B) = of, seen_from
    centres = c_A - c_B + np.array([0, 1]) * (dc_A - dc_B)  # at the start and at the end
    L = max(abs(dc_A - dc_B - 1j * dtheta_B * centres)) + abs((dtheta_A - dtheta_B) * X)  # (10.4)
    while tau < 1:
        z = place(X, of, seen_from, tau)
        d, n = closest(z, polygon)
        if d <= delta + tolerance:
            return tau, d - delta + (n.conj() * (place(X, of, seen_from, 1) - z)).real  # (10.5)
        tau += (d - delta) / L  # (10.3)
    return 1.0, 0.0


V, touches = 0.0, []
for vertices, of, polygon, seen_from in ((A, path_A, B, path_B), (B, path_B, A, path_A)):
    touches += [follow(X, of, polygon, seen_from) for X in vertices]
    lengths = abs(np.roll(vertices, -1) - vertices)
    V += (lengths + np.roll(lengths, 1)) / 2 @ [min(g, 0) for _, g in touches[-120:]]  # (10.6)
first, deepest = np.min(touches, axis=0)
print("first_contact", first)
print("deepest_gap_and_volume", deepest, V)
plt.fill(B.real, B.imag, color="tab:orange")
for tau, alpha in ((0, 0.2), (first, 0.5), (1, 0.9)):
    z = place(A, path_A, path_B, tau)
    plt.fill(z.real, z.imag, color="tab:blue", alpha=alpha)
plt.gca().set(aspect="equal", title="A seen from B: start (pale), first contact, end (dark)")
figure = (sys.argv + ["twin_10.png"])[1]
plt.savefig(figure)
print("figure", figure)
