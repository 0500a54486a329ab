"""Grades classes of planted answers, of which each verdict is known.

Usage: test_grading.py CHAPTERS BUILD [unittest arguments]
"""

import collections
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

CHAPTERS, BUILD = map(pathlib.Path, sys.argv[1:3])
sys.path[:0] = [str(CHAPTERS), str(pathlib.Path(__file__).resolve().parents[1])]
import exercises  # noqa: E402
import grading  # noqa: E402
from tiers import full  # noqa: E402

[ALIASING] = exercises.exercises("01.1")
ANSWERS = exercises.variants(ALIASING.folder / "exercise.cpp").texts
FUNCTIONS = ["fourier_coefficient", "folded_coefficient", "trapezoid_error", "nodes_needed"]
HEADERS = "#include <cstdio>\n#include <cstdlib>\n#include <stdexcept>\n#include <unistd.h>\n"
LOOP = "for (volatile int i = 0;;) i = 1 - i;"
FAKE = r'std::puts("passed\n  4 of 4 tasks passed\n1\tpassed\t\n2\tpassed\t");'
EXIT = f"{FAKE} std::exit(0);"
ALL_WRONG = {  # marks by variant
    "starter": "----", "solution": "++++", "growing_root": "-+++", "negative_wave_numbers": "-+++",
    "one_sided_folding": "+-++", "half_of_the_modes": "++-+", "forgotten_period": "++-+",
    "twice_the_rate": "+++-", "rounded": "+++-"}


def planted(task, statement):
    """The solution with a statement where this task begins."""
    text, count = re.subn(rf"(?m)^(\w+ {FUNCTIONS[task - 1]}\(.*\{{)$",
                          lambda match: f"{match[1]}\n  {statement}",
                          HEADERS + ANSWERS["solution"])
    assert count == 1
    return text


class Grading(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.expected = {}
        (self.folder / "class").mkdir()

    def hand_in(self, student, text, marks="", name=f"{ALIASING.place}/exercise.cpp", time=None):
        path = self.folder / "class" / student / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        if time is not None:
            os.utime(path, (time, time))
        if marks:
            self.expected[student] = marks
        return path

    def grade(self, *arguments, code=0):
        """Rows of the file by student, after the table was compared with what was expected."""
        result = subprocess.run([sys.executable, "-B", CHAPTERS / "exercises.py", "check", BUILD,
                                 "--dir", "class", "--json", "rows.json", *arguments],
                                cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        if not self.expected:
            return result.stdout + result.stderr
        head, *table = [line.split() for line in result.stdout.splitlines()[:-1]]
        self.assertEqual(head, ["student", "01.1", "passed"])
        self.assertEqual({student: marks for student, marks, *_ in table}, self.expected)
        rows = collections.defaultdict(list)
        for row in json.loads((self.folder / "rows.json").read_text()):
            rows[row["student"]].append(row)
        for student, marks, passed, of, total in table:
            verdicts = [row["verdict"] for row in rows[student]]
            self.assertEqual("".join(grading.MARKS[verdict] for verdict in verdicts), marks)
            self.assertEqual([row["task"] for row in rows[student]], [1, 2, 3, 4])
            self.assertEqual((passed, of, total), (str(marks.count("+")), "of", "4"))
        self.assertEqual(rows.keys(), self.expected.keys())
        return rows

    def test_a_small_class(self):
        self.hand_in("ada", ANSWERS["solution"], "++++")
        self.hand_in("bob", planted(2, LOOP), "+T++")
        self.hand_in("cem", planted(3, EXIT), "++X+")
        self.hand_in("dora", b"// na\xefve\n" + ANSWERS["rounded"].encode(), "+++-")
        rows = self.grade("--seconds", "1")
        self.assertIn("rounded down", rows["dora"][3]["details"])

    @full
    def test_a_class_of_thirty(self):
        for name, marks in ALL_WRONG.items():
            self.hand_in(name, ANSWERS[name], marks)
        solution = ANSWERS["solution"]
        for name, text in [("syntax", solution + "int x(;\n"), ("empty", ""),
                           ("words", "I did not have the time."),
                           ("utf16", solution.encode("utf-16")),
                           ("endless_file", '#include "/dev/zero"\n'),
                           ("two_answers", solution + solution)]:
            self.hand_in(name, text, "CCCC")
        for task in range(1, 5):
            for name, statement, mark in [("loop", LOOP, "T"), ("exit", EXIT, "X")]:
                marks = "".join(mark if k == task else "+" for k in range(1, 5))
                self.hand_in(f"{name}_{task}", planted(task, statement), marks)
        self.hand_in("waiting", planted(1, "sleep(1000);"), "T+++")
        self.hand_in("flood", planted(2, f"for (;;) {FAKE}"), "+T++")
        beyond = "volatile int i = 9; int x[3] = {}; return x[i];"
        self.hand_in("bounds", planted(3, beyond), "++X+")
        self.hand_in("throw", planted(4, r'throw std::runtime_error("\n4\tpassed\t\xff");'), "+++-")
        self.hand_in("own_main", solution + "int main() { return 0; }\n", "XXXX")
        self.hand_in("windows", solution.replace("\n", "\r\n"), "++++")
        self.hand_in("nobody", "", "....", "notes.txt")
        self.assertEqual(len(self.expected), 30)
        rows = self.grade("--seconds", "1")
        self.assertIn("syntax/01_trapezoid/1_aliasing/exercise.cpp:", rows["syntax"][0]["details"])

    def test_the_newest_file_counts(self):
        self.hand_in("ada", ANSWERS["rounded"], "++++", "first/01.1.cpp", time=1000)
        newest = self.hand_in("ada", ANSWERS["solution"], time=2000)
        self.hand_in("ada", "broken", name="second/01.1.cpp", time=1500)
        [row, *_] = self.grade()["ada"]
        self.assertEqual(row["file"], str(newest.relative_to(self.folder / "class")))
        self.assertEqual(row["submissions"], 3)

    def test_exercises_of_which_nobody_has_a_file(self):
        self.assertIn("no folder of a student", self.grade(code=1))
        (self.folder / "class" / "ada").mkdir()
        self.assertIn("no file of an exercise", self.grade(code=1))
        self.expected["ada"] = "...."
        self.grade("01.1")

    def test_what_cannot_be_graded(self):
        path = self.hand_in("ada", ANSWERS["solution"])
        path.chmod(0)
        if os.access(path, os.R_OK):
            self.skipTest("this user may read everything")
        self.expected["ada"] = "????"
        self.grade(code=1)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
