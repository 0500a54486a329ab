"""Writes the pages that Doxygen reads: texts with their numbers, lists of chapters and exercises.

make_pages.py ROOT FOLDER STUDY RESULTS

Figures and tables come from the folder STUDY, RESULTS or FOLDER, from docs/drawings or
docs/interactive, or from a chapter's folder.
The table of the README lists the methods and what each adds. The first paragraph of a chapter names
the chapters that it builds on. An exercise is listed if it has a README.md.
"""

import html
import pathlib
import re
import shutil
import sys

import glossary
import number_pages

# Each method has a column and a row in the graph. Arrows point down.
PLACES = {
    "trapezoid": (1, 0), "double_layer": (1, 1), "closure": (1, 2), "near_singular": (2, 3),
    "krylov": (0, 3), "null_space": (1, 3), "fmm": (3, 4), "time_stepping": (0, 4),
    "stress": (2, 4), "stiv": (0, 5), "lcp": (0, 6), "suspension": (0, 7),
    "preconditioning": (0, 8), "periodic": (2, 8)}
PITCH, WIDTH, HEIGHT, ROW = 90, 78, 40, 62
LAST_COLUMN, LAST_ROW = 3, 7  # the chapter in this row, which uses all above, is as wide as the graph


def methods_of(root):
    """Returns the rows (number, method, what it adds) of the README's table."""
    rows = re.findall(r"^\| (\d\d) \| `(\w+)` \| (.*?) \|", (root / "README.md").read_text(),
                      re.MULTILINE)
    assert len(rows) == len(PLACES), "the README's table of methods is not as expected"
    return rows


def builds_on(root, methods):
    """Returns the methods that each method builds on, directly or through others: method -> set."""
    names = {int(number): method for number, method, _ in methods}
    found = {}
    for number, method in sorted(names.items()):
        text = (root / f"chapters/{number:02}_{method}/chapter.md").read_text()
        said = re.search(r"\*\*Builds on:\*\*(.*?)\*\*Library", text, re.DOTALL)[1]
        found[method] = set()
        for first, last in re.findall(r"@ref\s+chapter_(\d+)(?:\s+to\s+@ref\s+chapter_(\d+))?", said):
            for k in range(int(first), int(last or first) + 1):
                found[method] |= {names[k]} | found[names[k]]
    return found


def direct_uses(uses, methods):
    """Returns the methods that each method uses and does not get through another method."""
    direct = {}
    for method in methods:
        used = uses[method]
        direct[method] = {u for u in used if not any(u in uses[other] for other in used)}
    return direct


def box(method):
    """Returns the left, the top and the width of a method's box."""
    column, row = PLACES[method]
    more = LAST_COLUMN if row == LAST_ROW else 1 if row > LAST_ROW else 0  # columns
    return column * PITCH + 2, row * ROW + 2, more * PITCH + WIDTH


def arrow(used, user):
    """Draws an arrow from the bottom of one box to the top of another box, which is below."""
    left, top, width = box(used)
    x1, y1 = left + width / 2, top + HEIGHT
    left, y2, width = box(user)
    assert y1 < y2, f"the graph of chapters has no place for {user} below {used}"
    x2 = x1 if PLACES[user][1] == LAST_ROW else left + width / 2
    if PLACES[used][1] == LAST_ROW:
        x1 = x2
    return f'<path class="arrow" d="M{x1:g} {y1:g} L{x2:g} {y2 - 5:g}" marker-end="url(#tip)"/>'


def graph(methods, uses):
    names = [method for _, method, _ in methods]
    rows = max(row for _, row in PLACES.values())
    lines = ['<div class="chapter-graph">',
             f'<svg viewBox="0 0 {LAST_COLUMN * PITCH + WIDTH + 4} {rows * ROW + HEIGHT + 4}" role="img" '
             'aria-label="The chapters; arrows lead to those that build on them">',
             '<defs><marker id="tip" viewBox="0 0 6 6" refX="2" refY="3" markerWidth="6" '
             'markerHeight="6" orient="auto"><path d="M0 0 L6 3 L0 6 z"/></marker></defs>']
    for user, used in direct_uses(uses, names).items():
        lines += [arrow(name, user) for name in sorted(used)]
    for number, method, adds in methods:
        left, top, width = box(method)
        words = [method.replace("_", " ")] if width > WIDTH else method.split("_")
        middle = left + width / 2
        text = "".join(f'<text x="{middle:g}" y="{top + 24 + 10 * k}">{word}</text>'
                       for k, word in enumerate(words))
        lines.append(f'<a href="chapter_{number}.html"><title>{html.escape(adds)}</title>'
                     f'<rect x="{left}" y="{top}" width="{width}" height="{HEIGHT}" rx="6"/>'
                     f'<text class="number" x="{middle:g}" y="{top + 12}">{number}</text>{text}</a>')
    return "\n".join([*lines, "</svg>", "</div>", ""])


def exercises_of(root):
    """Returns rows (chapter's number, exercise's number, README.md), in order."""
    found = []
    for readme in (root / "chapters").glob("*/exercises/*/README.md"):
        chapter = readme.parents[2].name[:2]
        exercise = int(readme.parent.name.partition("_")[0])
        found.append((chapter, exercise, readme))
    return sorted(found)


def exercise_page(chapter, exercise, text):
    """Returns an exercise's README as a page: with its number, links, and formulas for Doxygen."""
    title, _, body = text.partition("\n")
    title = f"# Exercise {chapter}.{exercise}: {title.removeprefix('# ')}"
    parts = re.split(r"(^```.*?^```$|`[^`\n]*`)", body, flags=re.MULTILINE | re.DOTALL)
    for k in range(0, len(parts), 2):  # the parts with odd k are code
        parts[k] = re.sub(r"\$\$(.+?)\$\$", r"\\f[\1\\f]", parts[k], flags=re.DOTALL)
        parts[k] = re.sub(r"\$(.+?)\$", r"\\f$\1\\f$", parts[k], flags=re.DOTALL)
        # Doxygen would end a paragraph, and with it the folded text, after the summary.
        parts[k] = re.sub(r"<details><summary>.*?</summary>|</details>",
                          r"\n@htmlonly[block]\n\g<0>\n@endhtmlonly\n", parts[k])
    return (f"{title} {{#exercise_{chapter}_{exercise}}}\n\n"
            f"This exercise belongs to chapter @ref chapter_{chapter}. "
            f"`./stokes check {chapter}.{exercise}` checks your answer.\n{''.join(parts)}")


def chapters_page(methods):
    lines = ["# Chapters {#chapters}", "",
             "In reading order. Each is a text, a program, a study and exercises about one library;",
             "chapter 00 is a text alone.", "",
             "| chapter | library | what it adds |", "|---|---|---|",
             "| @subpage chapter_00 | | the fluid, its equations, and what the book computes |"]
    lines += [f"| @subpage chapter_{number} | @ref {method} | {adds} |"
              for number, method, adds in methods]
    return "\n".join([*lines, ""])


EXERCISES = """# Exercises {#exercises}

`./stokes exercise 03` copies the starters of a chapter into `exercises/` of the working directory.
`./stokes check 03.2` compiles your file and reports on each task. For the first wrong result it
prints the arguments, what your function returned, and what was expected. If your results are those
of a known mistake at two inputs or more, it names the mistake. At one input it calls the mistake
one way to get this value.

- `--hint` adds a hint for each task that has not passed, and `--explain` adds its formula.
- `--watch` checks again whenever you save the file.
- `./stokes check` shows how many exercises of each chapter you have solved or tried.

The times at the heads of the exercises are estimates.

Teachers: `./stokes exercise --student-tree FOLDER` writes a copy of the book without solutions and
answers, and `./stokes check --dir FOLDER --json FILE` grades the files of a class.
`./stokes check --help` describes the folder and the result.
"""


def exercises_page(methods, exercises):
    lines = [EXERCISES]
    for number, method, _ in methods:
        pages = [f"- @subpage exercise_{number}_{exercise}"
                 for chapter, exercise, _ in exercises if chapter == number]
        if pages:
            lines += [f"## Chapter {number}: {method.replace('_', ' ')}", "", *pages, ""]
    return "\n".join(lines)


def included_file(name, folders):
    """Returns the text of an included file, which is in one of the folders."""
    for folder in folders:
        if (folder / name).exists():
            return (folder / name).read_text()
    raise SystemExit(f"{name} is included, but is in none of {', '.join(map(str, folders))}")


def main(root, folder, study, results):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    methods, exercises = methods_of(root), exercises_of(root)
    for chapter, exercise, readme in exercises:
        (folder / f"exercise_{chapter}_{exercise}.md").write_text(
            exercise_page(chapter, exercise, readme.read_text()))
    (folder / "chapters.md").write_text(chapters_page(methods))
    (folder / "chapter_graph.html").write_text(graph(methods, builds_on(root, methods)))
    (folder / "exercises.md").write_text(exercises_page(methods, exercises))
    chapters = sorted(root.glob("chapters/*/chapter.md"))
    texts = [path.read_text() for path in [*chapters, *sorted(root.glob("docs/*.md"))]]
    faults = [f"{number_pages.TITLE.match(text)[2]}: {fault}"
              for text in texts for fault in number_pages.faults(text)]
    if faults:
        raise SystemExit("\n".join(faults))
    folders = [study, results, folder, root / "docs/drawings", root / "docs/interactive",
               *(path.parent for path in chapters)]
    pages = number_pages.numbered_pages(texts, lambda name: included_file(name, folders),
                                        number_pages.study_sections(study))
    pages["glossary.md"] = glossary.glossary_page(
        [text for name, text in sorted(pages.items()) if re.fullmatch(r"chapter_\d\d\.md", name)])
    for file in set().union(*map(number_pages.quoted_files, texts)):
        pages[f"source/{file}.txt"] = (root / file).read_text()
    for name, text in pages.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)


if __name__ == "__main__":
    main(*map(pathlib.Path, sys.argv[1:]))
