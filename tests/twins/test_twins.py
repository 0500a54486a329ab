"""Runs the twins of the chapters, and compares their numbers with those of the libraries.

test_twins.py PROGRAM    PROGRAM is built from twins.cpp; it prints lines "01 perimeters 8.3 8.4"
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from matplotlib import pyplot

ROOT = pathlib.Path(__file__).resolve().parents[2]
TWINS = {path.parent.name[:2]: path for path in sorted(ROOT.glob("chapters/[0-9][0-9]_*/twin.py"))}
MOST_LINES = 60

# Twin and library evaluate the same formulas with the same nodes, so that they differ by rounding
# errors, times condition numbers of a few hundreds and, in chapter 07, two differentiations. In
# chapter 10 both find places of contact up to a tolerance of 1e-9, on edges that turn; in chapter
# 12 the solver chooses its own nodes, to a tolerance of 1e-11.
TOLERANCE = {"10": 1e-8}
USUAL_TOLERANCE = 1e-10


def numbers(lines):
    """Name -> values, of lines with a name and numbers."""
    return {name: [float(value) for value in values]
            for name, *values in (line.split() for line in lines)}


def differences(twin, library, tolerance):
    """Texts about names that only one has, and about values that differ, relative to the line."""
    found = [f"{name} has no partner" for name in sorted(twin.keys() ^ library.keys())]
    for name in sorted(twin.keys() & library.keys()):
        ours, theirs = twin[name], library[name]
        if len(ours) != len(theirs):
            found.append(f"{name} has {len(ours)} values, and {len(theirs)} in the library")
            continue
        scale = max(map(abs, theirs))
        for a, b in zip(ours, theirs):
            if not abs(a - b) <= tolerance * scale:  # or one is not a number
                found.append(f"{name} has {a!r}, and {b!r} in the library")
    return found


def run(twin, *arguments, folder=None):
    """The lines of a twin: its numbers, and the file of its figure."""
    output = subprocess.run([sys.executable, "-B", twin, *arguments], cwd=folder, text=True,
                            check=True, capture_output=True,
                            env=os.environ | {"PYTHONWARNINGS": "error::RuntimeWarning"}).stdout
    *lines, last = output.splitlines()
    word, figure = last.split(maxsplit=1)
    assert word == "figure"
    return lines, figure


class Twins(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.library = {}
        output = subprocess.run([PROGRAM], check=True, capture_output=True, text=True).stdout
        for line in output.splitlines():
            chapter, rest = line.split(maxsplit=1)
            cls.library.setdefault(chapter, []).append(rest)

    def test_each_chapter_with_a_program_has_a_twin(self):
        programs = {path.parent.name[:2] for path in ROOT.glob("chapters/*/program.cpp")}
        self.assertEqual(TWINS.keys(), programs)
        self.assertEqual(self.library.keys(), programs)

    def test_numbers_and_figures(self):
        for chapter, twin in TWINS.items():
            with self.subTest(chapter=chapter), tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "figure of a twin.png")
                lines, figure = run(twin, path)
                self.assertEqual(figure, path)
                self.assertGreater(len({*pyplot.imread(path).reshape(-1, 4)[:, 0]}), 10)
                self.assertEqual(differences(numbers(lines), numbers(self.library[chapter]),
                                             TOLERANCE.get(chapter, USUAL_TOLERANCE)), [])

    def test_a_planted_mistake_is_found(self):
        text = TWINS["03"].read_text()
        with tempfile.TemporaryDirectory() as folder:
            for right, wrong in (("1j * dx / abs(dx)", "-1j * dx / abs(dx)"),  # the normal
                                 ("-loads(x, 1, 0)", "loads(x, 1, 0)"),
                                 ("1j * x)])", "1j * x.conj())])")):  # the rotation
                with self.subTest(wrong=wrong):
                    self.assertEqual(text.count(right), 1)
                    copy = pathlib.Path(folder, "twin.py")
                    copy.write_text(text.replace(right, wrong))
                    lines, _ = run(copy, folder=folder)
                    self.assertNotEqual(differences(numbers(lines), numbers(self.library["03"]),
                                                    USUAL_TOLERANCE), [])

    def test_without_argument_the_figure_is_in_the_current_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            _, figure = run(TWINS["01"], folder=folder)
            self.assertEqual(os.listdir(folder), [figure])

    def test_twins_are_short(self):
        for chapter, twin in TWINS.items():
            with self.subTest(chapter=chapter):
                lines = twin.read_text().splitlines()
                self.assertLessEqual(len(lines), MOST_LINES)
                self.assertLessEqual(max(map(len, lines)), 100)

    def test_chapters_name_their_twins(self):
        for chapter, twin in TWINS.items():
            with self.subTest(chapter=chapter):
                head = (twin.parent / "chapter.md").read_text().split("```sh")[0]
                self.assertIn(f"`{twin.relative_to(ROOT)}`", head)

    def test_sections_exist(self):
        for chapter, twin in TWINS.items():
            with self.subTest(chapter=chapter):
                text = (twin.parent / "chapter.md").read_text()
                docstring = " ".join(twin.read_text().split('"""')[1].split())
                names = docstring.split('"')[1::2]
                self.assertTrue(names)
                for name in names:
                    self.assertRegex(text, rf"(?m)^##+ {re.escape(name)}( \{{|:)")


class Comparison(unittest.TestCase):
    def test_differences_are_found(self):
        library = {"a": [1.0, 2.0], "b": [3.0]}
        self.assertEqual(differences(library, library, 1e-10), [])
        self.assertEqual(differences(library | {"a": [1.0, 2.1]}, library, 1e-10),
                         ["a has 2.1, and 2.0 in the library"])
        self.assertEqual(differences(library | {"a": [1.0]}, library, 1e-10),
                         ["a has 1 values, and 2 in the library"])
        self.assertEqual(differences(library | {"a": [1.0, float("nan")]}, library, 1e-10),
                         ["a has nan, and 2.0 in the library"])
        self.assertEqual(differences({"a": [1.0, 2.0], "c": [3.0]}, library, 1e-10),
                         ["b has no partner", "c has no partner"])


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
