"""Draws means with their 95 % intervals as SVG, from tables of stokes sweep or stokes measure.

plot_means.py out/sweep/results.csv --x area_fraction --y torque_ratio --law '1 + 2 * x' --out means.svg

--x is an expression of the columns, such as 'pi * radius**2'; a list in a column has elements, as in
'channel[1]'. --y is a column that has a column of intervals: torque_ratio has torque_ratio_interval.
Several tables are drawn side by side, with a --y and a --label for each of them, in the same order.
Each --law is an expression of x, which is drawn as a line. --log makes the vertical axis logarithmic.
The script needs no other packages.
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
ASIDE = 7  # distance of the bars of two tables that have the same x, pixels
COLOURS = [("#0072b2", "#56b4e9"), ("#c2410c", "#f59e4b"), ("#00805f", "#2fc796"), ("#a03c78", "#e08fc0"),
           ("#6b6b00", "#cfc04a")]  # on light and on dark pages: the tables, then the laws


def value(expression, variables):
    """Returns the value of an expression of functions in NAMES and of variables."""
    return float(eval(expression, {"__builtins__": {}}, NAMES | variables))


def read_means(table, x, y):
    """Returns rows (x, mean, half of the interval), ascending; the interval may be nan."""
    with open(table, newline="") as file:
        rows = [{name: json.loads(cell.replace("nan", "NaN")) for name, cell in row.items()}
                for row in csv.DictReader(file)]
    return sorted((value(x, row), row[y], row[f"{y}_interval"]) for row in rows)


def log_ticks(low, high):
    """Returns the numbers 1, 2 and 5 times powers of ten from 10^low to 10^high."""
    numbers = (m * 10.0**k for k in range(math.floor(low), math.ceil(high)) for m in (1, 2, 5))
    return [number for number in numbers if low <= math.log10(number) <= high]


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


def draw(tables, laws, log, title, x_label, y_label):
    """Returns the SVG of tables: label -> rows of read_means, and of laws: expression -> rows (x, y)."""
    scale = math.log10 if log else float
    ends = [(x, end) for rows in tables.values() for x, mean, half in rows
            for end in ((mean - half, mean + half) if half == half else (mean,))]
    all_x = [x for x, _ in ends]
    all_y = [scale(y) for _, y in ends] + [scale(y) for points in laws.values() for _, y in points]
    margin_x, margin_y = (share * (max(values) - min(values)) or 1.0
                          for share, values in ((0.03, all_x), (0.05, all_y)))
    low_x, high_x = min(all_x) - margin_x, max(all_x) + margin_x
    low_y, high_y = min(all_y) - margin_y, max(all_y) + margin_y

    def column(x):
        return LEFT + (RIGHT - LEFT) * (x - low_x) / (high_x - low_x)

    def row(y):
        return BOTTOM - (BOTTOM - TOP) * (scale(y) - low_y) / (high_y - low_y)

    grid = 'stroke="currentColor" stroke-opacity="0.13"'
    axis = 'fill="none" stroke="currentColor" stroke-opacity="0.6"'
    line = 'fill="none" stroke="currentColor" stroke-width="1.4"'
    height = BOTTOM + 48 + ROW * (len(tables) + len(laws))
    light, dark = ("".join(f".stokesbook-picture .line-{k}{{color:{pair[theme]}}}"
                           for k, pair in enumerate(COLOURS)) for theme in (0, 1))
    svg = [f'<svg xmlns="http://www.w3.org/2000/svg" class="stokesbook-picture" role="img" width="520" '
           f'height="{height}" viewBox="0 0 520 {height}">', f"<title>{html.escape(title)}</title>",
           "<style>.stokesbook-picture{color:#1f2328;font:13px system-ui,sans-serif}" + light +
           "@media(prefers-color-scheme:dark){.stokesbook-picture{color:#d5dbe1}" + dark + "}</style>"]
    for x in ticks(low_x, high_x):
        svg += [path([(column(x), TOP), (column(x), BOTTOM)], grid),
                label(column(x), BOTTOM + 17, f"{x:.6g}", 'text-anchor="middle"')]
    for y in (log_ticks if log else ticks)(low_y, high_y):
        svg += [path([(LEFT, row(y)), (RIGHT, row(y))], grid),
                label(LEFT - 6, row(y) + 4, f"{y:.6g}", 'text-anchor="end"')]
    svg += [path([(LEFT, TOP), (LEFT, BOTTOM), (RIGHT, BOTTOM)], axis),
            label(LEFT, 20, y_label, 'font-weight="600"'),
            label((LEFT + RIGHT) / 2, BOTTOM + 37, x_label, 'text-anchor="middle" font-weight="600"')]
    keys = [BOTTOM + 56 + ROW * k for k in range(len(tables) + len(laws))]  # the rows of the legend
    for k, (law, points) in enumerate(laws.items(), len(tables)):
        svg += [f'<g class="line-{k % len(COLOURS)}">', path([(column(x), row(y)) for x, y in points], line),
                path([(LEFT, keys[k] - 4), (LEFT + 14, keys[k] - 4)], line), "</g>",
                label(LEFT + 20, keys[k], law)]
    for k, (name, rows) in enumerate(tables.items()):
        aside = ASIDE * (k - 0.5 * (len(tables) - 1))
        svg.append(f'<g class="line-{k % len(COLOURS)} means">')
        for x, mean, half in rows:
            if half == half:
                px, bottom, top = column(x) + aside, row(mean - half), row(mean + half)
                svg.append(path([(px, bottom), (px, top)], line))
                svg += [path([(px - CAP, end), (px + CAP, end)], line) for end in (bottom, top)]
        marks = [(column(x) + aside, row(mean)) for x, mean, _ in rows] + [(LEFT + 6, keys[k] - 4)]
        svg += [f'<circle cx="{px:.2f}" cy="{py:.2f}" r="{RADIUS}" fill="currentColor"/>' for px, py in marks]
        svg += ["</g>", label(LEFT + 20, keys[k], name)]
    return "\n".join([*svg, "</svg>", ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("tables", type=pathlib.Path, nargs="+")
    parser.add_argument("--x", required=True)
    parser.add_argument("--y", action="append", required=True)
    parser.add_argument("--label", action="append")
    parser.add_argument("--law", action="append", default=[])
    parser.add_argument("--log", action="store_true")
    parser.add_argument("--title")
    parser.add_argument("--x-label")
    parser.add_argument("--y-label")
    parser.add_argument("--out", type=pathlib.Path, required=True)
    options = parser.parse_args()
    labels = options.label or ["means, with 95 % intervals"]
    if not len(options.tables) == len(options.y) == len(set(labels)) == len(labels):
        parser.error("each table requires a --y, and several tables require a different --label each")
    tables = {}
    for table, y, name in zip(options.tables, options.y, labels):
        try:
            tables[name] = read_means(table, options.x, y)
        except (ArithmeticError, LookupError, NameError, SyntaxError, TypeError, ValueError) as error:
            parser.error(f"{table}: {error}; --x requires an expression of the columns, --y a column with an "
                         "interval")
    all_x = [x for rows in tables.values() for x, _, _ in rows]
    low, high = min(all_x), max(all_x)
    if low == high:
        parser.error(f"{options.tables[0]}: all rows have {options.x} = {low}; a plot requires two values")
    try:
        points = [low + (high - low) * k / 200 for k in range(201)]
        laws = {law: [(x, value(law, {"x": x})) for x in points] for law in options.law}
    except (ArithmeticError, NameError, SyntaxError, TypeError, ValueError) as error:
        parser.error(f"{error}; --law requires an expression of x")
    x_label, y_label = options.x_label or options.x, options.y_label or options.y[0]
    title = options.title or f"{y_label} over {x_label}"
    try:
        picture = draw(tables, laws, options.log, title, x_label, y_label)
    except ValueError:  # the logarithm of a number that is not positive
        parser.error("--log requires means, ends of intervals and laws above zero")
    options.out.write_text(picture)


if __name__ == "__main__":
    main()
