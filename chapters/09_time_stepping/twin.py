"""Chapter 09 in NumPy: a point passes a disk by steps that know their error.

The pair 3(2) of Bogacki and Shampine estimates the error of each step, and a controller chooses the
next length (section "Steps that know their error"). Usage: twin.py [FIGURE]
"""
import sys

import matplotlib.pyplot as plt
import numpy as np


def rate(q):
    """The velocity (09.12) at a point of the shear flow past a free disk of radius 1."""
    E_q, square = 0.5 * q[::-1], q @ q
    return (0.5 * q[::-1] * [1, -1] + (1 - square ** -2) * E_q
            - 2 * (q @ E_q) * (square - 1) / square ** 3 * q)


def step(q, k_1, h):
    """The end of a step (09.6), its rate, and the estimated error delta (09.7)."""
    k_2 = rate(q + h / 2 * k_1)
    k_3 = rate(q + 3 * h / 4 * k_2)
    end = q + h * (2 / 9 * k_1 + 1 / 3 * k_2 + 4 / 9 * k_3)
    k_4 = rate(end)  # the next step begins with it
    return end, k_4, h * (-5 / 72 * k_1 + 1 / 12 * k_2 + 1 / 9 * k_3 - 1 / 8 * k_4)


def run(q, t_end, tolerance, h):
    """All states and lengths of steps, and the number of rejected steps."""
    t, k, e_before, tried_again, states, lengths, rejected = 0.0, rate(q), 1.0, False, [q], [], 0
    while t < t_end:
        h = (t_end - t) / np.ceil((t_end - t) / h - 1e-9)  # equal steps up to the end
        end, k_end, delta = step(q, k, h)
        e = np.max(abs(delta)) / tolerance  # (09.9)
        factor = 0.9 * e ** (-0.7 / 3) * max(e_before, 1e-4) ** (0.4 / 3)  # (09.10) with m = 3
        factor = np.clip(factor, 0.2, 5.0)
        if e <= 1:
            t, q, k, e_before = t + h, end, k_end, e
            states.append(q)
            lengths.append(h)
            factor = min(factor, 1.0) if tried_again else factor
        tried_again, rejected = e > 1, rejected + (e > 1)
        h *= factor
    return np.array(states), np.array(lengths), rejected


above, below = plt.subplots(2, sharex=True)[1]
for tolerance in (1e-7, 1e-5, 1e-3):
    states, lengths, rejected = run(np.array([-5.0, 0.2]), 34.0, tolerance, h=0.1)
    print(f"steps_{tolerance:g}", len(lengths), rejected)
    print(f"end_{tolerance:g}", *states[-1])
    below.semilogy(states[1:, 0], lengths, ".", label=f"tolerance {tolerance:g}")
above.plot(*states.T, "o-", markersize=3)
above.add_patch(plt.Circle((0, 0), 1, color="lightgray"))
above.set(aspect="equal", ylim=(-1, 2), title="ends of the steps, tolerance 0.001")
below.set(ylim=(0.005, 20), title="lengths of the steps, over the place of the point")
below.legend(ncol=3, loc="upper center", fontsize="small")
figure = (sys.argv + ["twin_09.png"])[1]
plt.savefig(figure)
print("figure", figure)
