"""Opens the interactive figures of docs/interactive in a headless Chromium.

interactive.py                            writes the stills of all figures into docs/interactive
interactive.py --screenshots TO [NAME]    saves pictures of the figures: light, dark, phone
"""

import json
import pathlib
import re
import shutil
import sys
import tempfile

import browser

DOCS = pathlib.Path(__file__).parents[2] / "docs"
FIGURES = DOCS / "interactive"
STILL = re.compile(r'(?<=<g class="drawing">).*?(?=</g>\n</svg>)|(?<=<p class="numbers">).*?(?=</p>)', re.DOTALL)


def names():
    """Returns the names of the figures that pages may include."""
    return sorted(path.name.removesuffix("_figure.html") for path in FIGURES.glob("*_figure.html"))


def write_page(folder, shown):
    """Writes a page with the given figures and their scripts, and returns its path."""
    for script in [*FIGURES.glob("*.js"), DOCS / "style.css"]:
        shutil.copy(script, folder)
    page = pathlib.Path(folder).resolve() / "figures.html"
    page.write_text(
        "<!DOCTYPE html><html><head><meta charset='utf-8'><meta name='viewport' content='width=device-width'>"
        "<link rel='stylesheet' href='style.css'><style>:root { color-scheme: light dark; "
        "--primary-color: light-dark(#1779c4, #1982d2); --page-background-color: light-dark(#fff, #1c1d1f); "
        "--separator-color: #8888; } body { background: var(--page-background-color); font: 16px sans-serif; }"
        "</style></head><body><div class='contents'><div class='textblock'>"
        + "".join(f"<figure>{(FIGURES / f'{name}_figure.html').read_text()}</figure>" for name in shown)
        + "</div></div></body></html>")
    return page


def show(tab, name, settings):
    """Applies settings to a figure, and returns the texts of the numbers that it shows: name -> text."""
    return tab.evaluate(f"figures.show({json.dumps(name)}, {json.dumps(settings)})")


def texts(tab, numbers):
    """Returns numbers as the figures show them: name -> text."""
    return tab.evaluate(f"Object.fromEntries(Object.entries({json.dumps(numbers)})"
                        ".map(([name, value]) => [name, figures.text(value)]))")


def stills(tab):
    """Returns the drawing and the line of numbers of each figure as its page opens it: name -> two texts."""
    return {name: tab.evaluate(f"figures.still({json.dumps(name)})") for name in tab.evaluate("figures.names()")}


def main(arguments):
    to = pathlib.Path(arguments[1] if arguments else FIGURES)
    to.mkdir(exist_ok=True)
    with browser.Browser() as chromium:
        tab = chromium.tab()
        page = write_page(to, arguments[2:] or names()) if arguments else None
        if not arguments:
            with tempfile.TemporaryDirectory() as folder:
                tab.open(write_page(folder, names()).as_uri())
                for name, parts in stills(tab).items():
                    path, still = FIGURES / f"{name}_figure.html", iter(parts)
                    path.write_text(STILL.sub(lambda _: next(still), path.read_text()))
            return
        for look, width, dark in [("light", 1000, False), ("dark", 1000, True), ("phone", 390, False)]:
            tab.look(width, 800, dark=dark)
            print(*tab.open(page.as_uri()))
            tab.look(width, tab.evaluate("document.documentElement.scrollHeight"), dark=dark)
            tab.save_picture(to / f"{look}.png")


if __name__ == "__main__":
    main(sys.argv[1:])
