"""Chapter 11 in NumPy: Lemke's method finds which contacts push.

The path from large t down to t = 0, pivot by pivot, with the lexicographic rule for ties (sections
"Pivots" and "Cones"). Usage: twin.py [FIGURE]
"""
import sys

import matplotlib.pyplot as plt
import numpy as np


def lemke(M, q):
    """The forces z of (11.2), and the sets of pushing contacts along the path (11.4)."""
    m = len(q)
    # Rows: w - M z - t e = q. Columns: w, z, t, q. The basic variable of row i is basis[i].
    table = np.column_stack([np.eye(m), -M, -np.ones(m), q]).astype(float)
    basis, entering, sets = list(range(m)), 2 * m, [()]
    while 2 * m in basis or entering == 2 * m:
        pivots = table[:, entering]
        if len(sets) == 1:  # t enters for the least q_i
            row = min(range(m), key=lambda i: (q[i], -i))
        else:  # the basic variable that comes to zero first; ties by the columns of w
            row = min((i for i in range(m) if pivots[i] > 1e-12),
                      key=lambda i: tuple(table[i, [-1, *range(m)]] / pivots[i]))
        table[row] /= table[row, entering]
        others = np.arange(m) != row
        table[others] -= np.outer(table[others, entering], table[row])
        leaving, basis[row] = basis[row], entering
        entering = (leaving + m) % (2 * m)  # the other variable of the same contact
        sets.append(tuple(sorted(v - m for v in basis if m <= v < 2 * m)))
    z = np.zeros(2 * m)
    z[basis] = table[:, -1]
    return z[m:], sets


def chain(m):  # each contact opens its own gap, and closes the gaps of its neighbours
    return 2 * np.eye(m) - np.eye(m, k=1) - np.eye(m, k=-1)


z, sets = lemke(chain(9), np.cos(np.arange(9)) + 0.1)
print("forces", *z)
print("pivots_of_chain", len(sets) - 1)
for m in (4, 6, 8):  # Murty's matrix, see (11.6)
    print(f"pivots_of_murty_{m}", len(lemke(np.eye(m) + 2 * np.tri(m, k=-1), -np.ones(m))[1]) - 1)
M, q = np.array([[1.0, -0.4], [-0.4, 0.8]]), np.array([-1.0, -0.3])
z, sets = lemke(M, q)
print("two_forces", *z)
columns = {False: np.eye(2), True: -M}  # of an open gap, and of a contact that pushes
for pushing, color in (((0, 0), "0.9"), ((1, 0), "lightblue"), ((0, 1), "moccasin"),
                       ((1, 1), "lightpink")):
    ray_1, ray_2 = (9 * columns[bool(push)][:, i] for i, push in enumerate(pushing))
    plt.fill(*np.transpose([0 * q, ray_1, ray_1 + ray_2, ray_2]), color=color,
             label=f"pushing: {[i + 1 for i in (0, 1) if pushing[i]]}")
plt.plot(*np.transpose([q, q + 2.5]), "k--", label="q + t e")
plt.plot(*q, "ko", label=f"q, where z = {z.round(2)}")
plt.gca().set(aspect="equal", xlim=(-2.5, 2.5), ylim=(-2.5, 2.5), title="complementary cones")
plt.legend(loc="lower right")
figure = (sys.argv + ["twin_11.png"])[1]
plt.savefig(figure)
print("figure", figure)
