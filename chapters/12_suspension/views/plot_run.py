"""Reads a run into arrays and draws the paths of its bodies: a beginning for scripts of your own.

plot_run.py FOLDER     writes FOLDER/paths.svg; needs NumPy and nothing else
"""

import pathlib
import sys

import numpy


def read_table(path):
    """The columns of trajectory.csv or walls.csv by name: a row a written time, a column a body.

    The last time is left out while a run that goes on has not written all of it.
    """
    rows = numpy.atleast_1d(numpy.genfromtxt(path, names=True, delimiter=","))
    n_bodies = numpy.count_nonzero(rows["t"] == rows["t"][0]) if len(rows) else 0
    n_times = len(rows) // n_bodies if n_bodies else 0
    return {name: rows[name][: n_times * n_bodies].reshape(n_times, n_bodies)
            for name in rows.dtype.names}


def draw_paths(x, y):
    """SVG of curves whose columns are x and y, with a mark at the end of each."""
    margin = 0.05 * max(numpy.ptp(x), numpy.ptp(y)) or 1.0
    left, top = x.min() - margin, -y.max() - margin
    width, height = numpy.ptp(x) + 2 * margin, numpy.ptp(y) + 2 * margin
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{left} {top} {width} {height}" '
             f'fill="none" stroke="steelblue" stroke-width="{0.1 * margin}">']
    for path_x, path_y in zip(x.T, -y.T):  # y points down in SVG
        points = " ".join(f"{a:.6g},{b:.6g}" for a, b in zip(path_x, path_y))
        lines += [f'<polyline points="{points}"/>',
                  f'<circle cx="{path_x[-1]:.6g}" cy="{path_y[-1]:.6g}" r="{0.2 * margin}"/>']
    return "\n".join([*lines, "</svg>\n"])


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: plot_run.py FOLDER")
    folder = pathlib.Path(sys.argv[1])
    bodies = read_table(folder / "trajectory.csv")
    if bodies["x"].size == 0:
        sys.exit(f"{folder / 'trajectory.csv'} holds no body")
    (folder / "paths.svg").write_text(draw_paths(bodies["x"], bodies["y"]))
