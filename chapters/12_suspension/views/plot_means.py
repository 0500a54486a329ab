"""Draws means with their 95 % intervals as SVG, from a table of stokes sweep or stokes measure.

plot_means.py out/sweep/results.csv --x area_fraction --y torque_ratio --law '1 + 2 * x' --out means.svg

--x is an expression of the columns, such as 'pi * radius**2'; a list in a column has elements, as in
'channel[1]'. --y is a column that has a column of intervals: torque_ratio has torque_ratio_interval.
Each --law is an expression of x, which is drawn as a line. The script needs no other packages.
"""

import argparse
import csv
import html
import json
import math
import pathlib

NAMES = {name: getattr(math, name) for name in ("cos", "exp", "log", "pi", "sin", "sqrt")}
NAMES |= {"max": max, "min": min}
LEFT, RIGHT, TOP, BOTTOM = 62, 504, 34, 314  # edges of the frame, pixels
CAP, RADIUS, ROW = 4, 3.6, 19  # half of a bar's cap, radius of a mark, height of a row of the legend
COLOURS = [("#0072b2", "#56b4e9"), ("#c2410c", "#f59e4b"), ("#00805f", "#2fc796"),
           ("#a03c78", "#e08fc0")]  # on light and on dark pages: the means, then the laws


def value(expression, variables):
    """Returns the value of an expression of functions in NAMES and of variables."""
    return float(eval(expression, {"__builtins__": {}}, NAMES | variables))


def read_means(table, x, y):
    """Returns rows (x, mean, half of the interval), ascending; the interval may be nan."""
    with open(table, newline="") as file:
        rows = [{name: json.loads(cell.replace("nan", "NaN")) for name, cell in row.items()}
                for row in csv.DictReader(file)]
    return sorted((value(x, row), row[y], row[f"{y}_interval"]) for row in rows)


def ticks(low, high):
    """Returns at most eight round numbers from low to high."""
    step = 10.0 ** math.floor(math.log10((high - low) / 7))
    for factor in 2, 2.5, 2:
        if (high - low) / step > 7:
            step *= factor
    return [k * step for k in range(math.ceil(low / step), math.floor(high / step) + 1)]


def label(x, y, text, style=""):
    return f'<text x="{x:.2f}" y="{y:.2f}" fill="currentColor" {style}>{html.escape(text)}</text>'


def path(points, style):
    return f'<path {style} d="M{"L".join(f"{x:.2f} {y:.2f}" for x, y in points)}"/>'


def draw(means, laws, title, x_label, y_label):
    """Returns the SVG of means (rows of read_means) and of laws: expression -> rows (x, y)."""
    bars = [(x, mean - half, mean + half) for x, mean, half in means if half == half]
    all_y = [mean for _, mean, _ in means] + [end for _, *ends in bars for end in ends]
    all_y += [y for points in laws.values() for _, y in points]
    margin = 0.05 * (max(all_y) - min(all_y)) or 1.0
    low_y, high_y = min(all_y) - margin, max(all_y) + margin
    low_x, high_x = means[0][0], means[-1][0]
    low_x, high_x = low_x - 0.03 * (high_x - low_x), high_x + 0.03 * (high_x - low_x)

    def at(x, y):
        return (LEFT + (RIGHT - LEFT) * (x - low_x) / (high_x - low_x),
                BOTTOM - (BOTTOM - TOP) * (y - low_y) / (high_y - low_y))

    grid = 'stroke="currentColor" stroke-opacity="0.13"'
    axis = 'fill="none" stroke="currentColor" stroke-opacity="0.6"'
    height = BOTTOM + 48 + ROW * (1 + len(laws))
    light, dark = ("".join(f".stokesbook-picture .line-{k}{{color:{pair[theme]}}}"
                           for k, pair in enumerate(COLOURS)) for theme in (0, 1))
    svg = [f'<svg xmlns="http://www.w3.org/2000/svg" class="stokesbook-picture" role="img" width="520" '
           f'height="{height}" viewBox="0 0 520 {height}">', f"<title>{html.escape(title)}</title>",
           "<style>.stokesbook-picture{color:#1f2328;font:13px system-ui,sans-serif}" + light +
           "@media(prefers-color-scheme:dark){.stokesbook-picture{color:#d5dbe1}" + dark + "}</style>"]
    for x in ticks(low_x, high_x):
        svg += [path([at(x, low_y), at(x, high_y)], grid),
                label(at(x, low_y)[0], BOTTOM + 17, f"{x:.6g}", 'text-anchor="middle"')]
    for y in ticks(low_y, high_y):
        svg += [path([at(low_x, y), at(high_x, y)], grid),
                label(LEFT - 6, at(low_x, y)[1] + 4, f"{y:.6g}", 'text-anchor="end"')]
    svg += [path([(LEFT, TOP), (LEFT, BOTTOM), (RIGHT, BOTTOM)], axis),
            label(LEFT, 20, y_label, 'font-weight="600"'),
            label((LEFT + RIGHT) / 2, BOTTOM + 37, x_label, 'text-anchor="middle" font-weight="600"')]
    line = 'fill="none" stroke="currentColor" stroke-width="1.4"'
    legend = BOTTOM + 56
    for k, (law, points) in enumerate(laws.items(), 1):
        row = legend + ROW * k
        svg += [f'<g class="line-{k % len(COLOURS)}">', path([at(*point) for point in points], line),
                path([(LEFT, row - 4), (LEFT + 14, row - 4)], line), "</g>", label(LEFT + 20, row, law)]
    svg.append('<g class="line-0 means">')
    for x, low, high in bars:
        (px, bottom), (_, top) = at(x, low), at(x, high)
        svg.append(path([(px, bottom), (px, top)], line))
        svg += [path([(px - CAP, end), (px + CAP, end)], line) for end in (bottom, top)]
    for px, py in [at(x, mean) for x, mean, _ in means] + [(LEFT + 6, legend - 4)]:
        svg.append(f'<circle cx="{px:.2f}" cy="{py:.2f}" r="{RADIUS}" fill="currentColor"/>')
    svg += ["</g>", label(LEFT + 20, legend, "means, with 95 % intervals"), "</svg>", ""]
    return "\n".join(svg)


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("table", type=pathlib.Path)
    parser.add_argument("--x", required=True)
    parser.add_argument("--y", required=True)
    parser.add_argument("--law", action="append", default=[])
    parser.add_argument("--title")
    parser.add_argument("--x-label")
    parser.add_argument("--y-label")
    parser.add_argument("--out", type=pathlib.Path, required=True)
    options = parser.parse_args()
    try:
        means = read_means(options.table, options.x, options.y)
        low, high = means[0][0], means[-1][0]
        points = [low + (high - low) * k / 200 for k in range(201)]
        laws = {law: [(x, value(law, {"x": x})) for x in points] for law in options.law}
    except (ArithmeticError, LookupError, NameError, SyntaxError, TypeError, ValueError) as error:
        parser.error(f"{options.table}: {error}; --x requires an expression of the columns, --y a column "
                     "with an interval, --law an expression of x")
    if low == high:
        parser.error(f"{options.table}: all rows have {options.x} = {low}; a plot requires two values")
    x_label, y_label = options.x_label or options.x, options.y_label or options.y
    options.out.write_text(draw(means, laws, options.title or f"{y_label} over {x_label}",
                                x_label, y_label))


if __name__ == "__main__":
    main()
