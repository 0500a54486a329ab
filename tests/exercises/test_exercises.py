"""Tests the tool of the exercises as readers and as authors run it.

Usage: test_exercises.py CHAPTERS BUILD DIAGNOSIS [unittest arguments]
"""

import contextlib
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import unittest.mock

CHAPTERS, BUILD, DIAGNOSIS = map(pathlib.Path, sys.argv[1:4])
sys.path[:0] = [str(CHAPTERS), str(pathlib.Path(__file__).resolve().parents[1])]
import exercises  # noqa: E402
from tiers import full  # noqa: E402

# Without this, tests that a shell starts in the background, and their children, ignore SIGINT.
signal.signal(signal.SIGINT, signal.default_int_handler)

ALIASING = CHAPTERS / "01_trapezoid/exercises/1_aliasing"
PLACE = pathlib.Path("exercises/01_trapezoid/1_aliasing")

TAGGED = """int common;
//@ starter
not_done();
//@ solution
right();
//@ wrong slow: too slow
wrong();
//@ end
//@ starter
//@ solution
second();
//@ wrong sign: the sign
minus();
//@ end
"""

FUNCTIONS = """#include <cstdio>
//@ starter
//@ solution
int one() {
  return 1;
}
//@ end
int first() {
  //@ starter
  return 2;
  //@ solution
  return one();
  //@ wrong more: more
  return 3;
  //@ wrong less: less
  return 0;
  //@ end
}
int second() {
  //@ wrong less: less
  return 40;
  //@ wrong last: last
  return 50;
  //@ starter
  return 30;
  //@ solution
  return 20;
  //@ end
}
int main() { std::printf("%d %d\\n", first(), second()); }
"""


class Tool(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def tool(self, *arguments, code=0):
        result = subprocess.run([sys.executable, "-B", CHAPTERS / "exercises.py", *arguments],
                                cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result.stdout + result.stderr


class Diagnosis(unittest.TestCase):
    """What check.cpp says of planted results."""

    def report(self, **settings):
        settings = {f"STOKESBOOK_{name}": value for name, value in settings.items()}
        result = subprocess.run([DIAGNOSIS], env={**os.environ, **settings}, text=True,
                                stdout=subprocess.PIPE)
        self.assertEqual(result.returncode, 1)
        return result.stdout

    def task(self, title):
        return re.search(rf"task \d+, {title}: (.*\n(    .*\n)*)", self.report())[1]

    def test_a_mistake_is_named_if_it_explains_two_inputs(self):
        self.assertEqual(self.task("right"), "passed\n")
        for title in "twice", "vector":
            self.assertIn("\n    mistake   twice as much\n", self.task(title))

    def test_else_it_is_one_way_to_get_a_value(self):
        for title, sentence in [("once", "twice as much"), ("mixed", "the sign"),
                                ("constant", "this is nothing"), ("equal", "twice as much")]:
            self.assertIn(f"\n    perhaps   {sentence} (one way to get this value)\n",
                          self.task(title))
            self.assertNotIn("mistake", self.task(title))
        self.assertEqual(self.task("unknown"), "wrong\n    for       x = 1\n    got       3\n"
                         "    expected  10\n")

    def test_a_task_names_the_wrong_ones_on_which_it_builds(self):
        self.assertIn("    note      task 10 builds on task 2, which is wrong\n"
                      "    note      task 10 builds on task 9, which is not done\n",
                      self.report())
        self.assertNotIn("builds on task 1", self.report())

    def test_hints_and_formulas_are_shown_on_request(self):
        for show in ["", "hint", "formula", "hint formula"]:
            for word, shown in [("hint", "    hint      the hint\n"),
                                ("formula", "    formula   the formula\n")]:
                self.assertEqual(shown in self.report(SHOW=show), word in show)

    def test_one_task(self):
        text = self.report(TASK="2")
        self.assertEqual(re.findall(r"task \d+", text), ["task 2"])
        self.assertIn("0 of 1 tasks passed", text)

    def test_records(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "records"
            self.report(REPORT=str(file))
            records = exercises.records_of(file)
        self.assertEqual([word for word, _ in records.values()],
                         ["passed", *7 * ["wrong"], "not done", "stopped by an exception"])
        self.assertIn("thrown;1\tpassed", records[10][1])


class Reader(Tool):
    def place(self, source):
        path = self.folder / PLACE / "exercise.cpp"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(source)
        return path

    def check(self, source, *options, code):
        self.place(source)
        return self.tool("check", BUILD, "01.1", *options, code=code)

    def variant(self, name):
        return exercises.variants(ALIASING / "exercise.cpp").texts[name]

    def test_list(self):
        text = self.tool("exercise")
        self.assertRegex(text, r"01\.1  Aliasing.* not copied yet")
        self.tool("exercise", "01.1")
        text = self.tool("exercise")
        self.assertRegex(text, r"01\.1  Aliasing.* copied")
        self.assertRegex(text, r"01\.2 .* not copied yet")

    def state(self):
        return re.search(r"^01\.1  .{52} (.*)", self.tool("exercise"), re.MULTILINE)[1]

    def test_progress(self):
        def row(name):
            return [*map(int, re.search(rf"^{name} +(\d+) +(\d+) +(\d+)$",
                                        self.tool("check", BUILD), re.MULTILINE).groups())]

        every = len(exercises.exercises())
        self.assertEqual(row("all"), [0, 0, every])
        for source, code, state, counts in [
                (self.variant("starter"), 1, "0 of 4 tasks passed", [0, 1]),
                (self.variant("rounded"), 1, "3 of 4 tasks passed", [0, 1]),
                (self.variant("solution"), 0, "solved", [1, 0]),
                ("broken", 1, "0 of 4 tasks passed", [0, 1])]:
            self.check(source, code=code)
            self.assertEqual(self.state(), state)
            self.assertEqual(row("01_trapezoid"), [*counts, 3])
            self.assertEqual(row("all"), [*counts, every - 1])

    def test_copy(self):
        self.tool("exercise", "01")
        for name in ["1_aliasing", "2_distance_of_a_pole", "3_corner"]:
            place = self.folder / "exercises" / "01_trapezoid" / name
            self.assertEqual({p.name for p in place.iterdir()}, {"README.md", "exercise.cpp"})
            source = (place / "exercise.cpp").read_text()
            self.assertIn("not_done", source)
            self.assertNotIn("//@", source)

    def test_copy_keeps_what_is_there(self):
        self.tool("exercise", "1")
        mine = self.folder / PLACE / "exercise.cpp"
        mine.write_text("// mine\n")
        self.assertRegex(self.tool("exercise", "1"), r"kept .*exercise\.cpp.* move it away first")
        self.assertEqual(mine.read_text(), "// mine\n")
        mine.unlink()
        self.assertIn(f"wrote  {PLACE / 'exercise.cpp'}", self.tool("exercise", "1"))

    def test_unknown_numbers(self):
        for command in [["exercise"], ["check", BUILD]]:
            for number in ["99", "01.99", "0", "krylov"]:
                text = self.tool(*command, number, code=1)
                self.assertIn(f"there is no exercise {number}", text)
                self.assertIn("  01.2  The distance of a pole", text)
        self.assertIn("usage", self.tool("exercise", "01", "02", code=1))

    def test_files_that_cannot_be_used(self):
        reader = self.folder / PLACE / "exercise.cpp"
        reader.parent.mkdir(parents=True)
        reader.write_bytes(b"// fine\n// na\xefve\n")
        self.assertIn(f"{PLACE / 'exercise.cpp'}:2: not in UTF-8\n",
                      self.tool("check", BUILD, "01.1", code=1))
        shutil.rmtree(self.folder / "exercises")
        (self.folder / "exercises").write_text("")
        text = self.tool("exercise", "01", code=1)
        self.assertRegex(text, r"^stokes: \[Errno \d+\] .*exercises")
        self.assertEqual(text.count("\n"), 1)

    def test_nobody_reads_on(self):
        process = subprocess.Popen([sys.executable, "-B", CHAPTERS / "exercises.py", "exercise"],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=self.folder)
        process.stdout.close()
        self.assertEqual(process.stderr.read(), b"")
        process.stderr.close()
        self.assertEqual(process.wait(), 1)

    def test_nothing_to_check(self):
        for options in ["--hint"], ["--watch"], ["--json", "file"]:
            self.assertIn("\nusage: ", self.tool("check", BUILD, *options, code=1))
        self.assertIn("./stokes exercise 01",
                      self.tool("check", BUILD, "01", "--watch", code=1))
        self.assertIn("./stokes exercise 01", self.tool("check", BUILD, "01", code=1))
        self.assertIn("./stokes exercise 01", self.tool("check", BUILD, "01.1", code=1))

    def test_check_of_the_starter(self):
        text = self.check(self.variant("starter"), code=1)
        self.assertIn(f"({PLACE / 'exercise.cpp'})", text)
        self.assertRegex(text, "task 1, .*: not done")
        self.assertIn("0 of 4 tasks passed", text)
        self.assertEqual(text, self.tool("check", BUILD, "1", code=1))

    def test_check_of_the_solution(self):
        text = self.check(self.variant("solution"), code=0)
        self.assertIn("4 of 4 tasks passed", text)
        self.assertNotRegex(text, "warning|ninja|FAILED")

    def test_check_of_a_wrong_answer(self):
        first = ["for ", "got ", "expected ", "mistake   this is half"]
        for options, words in [([], first), (["--hint"], [*first, "hint "]),
                               (["--explain"], [*first, "formula "]),
                               (["--hint", "--explain"], [*first, "hint ", "formula "])]:
            text = self.check(self.variant("half_of_the_modes"), *options, code=1)
            lines = [line[4:] for line in text.splitlines() if line.startswith("    ")]
            self.assertEqual(len(lines), len(words), text)
            for line, word in zip(lines, words):
                self.assertTrue(line.startswith(word), text)
            self.assertIn("3 of 4 tasks passed", text)
            self.assertEqual("--hint" in text, not options)

    def test_compile_errors_name_the_readers_file(self):
        text = self.check(self.variant("starter") + "int broken(;\n", code=1)
        line = len(self.variant("starter").splitlines()) + 1
        self.assertIn(f"{(self.folder / PLACE / 'exercise.cpp').resolve()}:{line}:", text)
        self.assertNotRegex(text, r"ninja|FAILED|-std=")

    def test_warnings_are_shown_and_forgiven(self):
        text = self.check(self.variant("solution") + "static int unused() { return 1; }\n", code=0)
        self.assertIn("-Wunused-function", text)

    def test_errors_at_run_time(self):
        starter = self.variant("starter")
        for code, message in [
                ("int x[3] = {}; return x[k + 8];", "index 8 out of bounds"),
                ("double* x = new double[3]; delete[] x; return a + k + x[1];", "use-after-free")]:
            text = self.check(starter.replace("not_done(a, k);", code), code=1)
            self.assertIn(message, text)
            self.assertIn("stopped by an error in the task named last", text)
        thrown = 'throw std::range_error(a > k ? "mine" : "other");'
        text = self.check("#include <stdexcept>\n" + starter.replace("not_done(a, k);", thrown),
                          code=1)
        self.assertRegex(text, "task 1, .*: stopped by an exception\n    message   mine\n")
        self.assertRegex(text, "task 2, .*: not done")

    def test_a_program_that_ends_early_has_not_passed(self):
        leave = 'std::exit(a > k ? 0 : 0);'
        text = self.check("#include <cstdlib>\n" + self.variant("starter").replace(
            "not_done(a, k);", leave), code=1)
        self.assertIn("the program ended in the task named last", text)

    def test_watch(self):
        path = self.place(self.variant("starter"))
        command = [sys.executable, "-B", CHAPTERS / "exercises.py", "check", BUILD, "01.1",
                   "--watch"]
        with subprocess.Popen(command, cwd=self.folder, stdout=subprocess.PIPE, text=True,
                              stderr=subprocess.STDOUT) as process, \
                contextlib.ExitStack() as stack:
            stack.callback(process.kill)  # otherwise, a test that fails would wait for its end

            def wait_for(text):
                lines = []
                while not lines or "waiting" not in lines[-1]:
                    lines.append(process.stdout.readline())
                    self.assertTrue(lines[-1], lines)
                self.assertIn(text, "".join(lines))

            wait_for("0 of 4 tasks passed")
            for source, text in [(b"// na\xefve\n", "not in UTF-8"),
                                 (b"int x(", "does not compile"),
                                 (self.variant("solution").encode(), "4 of 4 tasks passed")]:
                new = path.with_name("new")
                new.write_bytes(source)
                new.replace(path)
                wait_for(text)
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(), 130)
            self.assertEqual(process.stdout.read(), "")


class Programs(Tool):
    def script(self, text):
        path = self.folder / "program"
        path.write_text("#!/bin/sh\n" + text)
        path.chmod(0o755)
        return path

    def test_endless_loops_are_stopped(self):
        loop = self.script("while :; do :; done\n")
        self.assertEqual(exercises.run(loop, self.folder, seconds=1), -signal.SIGXCPU)

    def test_programs_that_wait_are_stopped(self):
        waiting = self.script("exec sleep 60\n")
        with unittest.mock.patch.object(exercises, "CLOCK", 0.1):
            self.assertEqual(exercises.run(waiting, self.folder, seconds=1), -signal.SIGXCPU)

    def test_nothing_that_a_program_starts_is_left(self):
        parent = self.script("(sleep 1; touch late) &\nexit 7\n")
        self.assertEqual(exercises.run(parent, self.folder), 7)
        time.sleep(1.5)
        self.assertFalse((self.folder / "late").exists())

    def test_what_a_program_writes_is_limited(self):
        with unittest.mock.patch.object(exercises, "BYTES_WRITTEN", 1 << 20):
            flood = self.script("exec dd if=/dev/zero of=file bs=1M\n")
            self.assertEqual(exercises.run(flood, self.folder), -signal.SIGXFSZ)
        self.assertEqual((self.folder / "file").stat().st_size, 1 << 20)


class StudentTree(Tool):
    def setUp(self):
        super().setUp()
        self.tree = self.folder / "tree"
        self.tool("exercise", "--student-tree", self.tree)

    def student(self, *arguments, code=0):
        result = subprocess.run([self.tree / "stokes", *arguments], cwd=self.folder,
                                capture_output=True, text=True)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result.stdout + result.stderr

    def test_it_has_starters_only(self):
        for exercise in exercises.exercises():
            source = self.tree / (exercise.folder / "exercise.cpp").relative_to(CHAPTERS.parent)
            self.assertEqual(source.read_text(), exercise.starter())
        tracked = subprocess.run(["git", "-C", CHAPTERS.parent, "ls-files"], capture_output=True,
                                 text=True, check=True).stdout.splitlines()
        self.assertEqual(len(tracked), sum(p.is_file() for p in self.tree.rglob("*")))
        self.assertTrue(os.access(self.tree / "stokes", os.X_OK))
        self.assertIn("exists already",
                      self.tool("exercise", "--student-tree", self.tree, code=1))

    def test_its_page_for_teachers_has_questions_only(self):
        page = (self.tree / "docs/teaching.md").read_text()
        whole = (CHAPTERS.parent / "docs/teaching.md").read_text()
        answered = ["\\pi/16", "*01.1.*", "A Stokeslet has a force", "*13.3.*"]
        for answer in answered:
            self.assertIn(answer, whole)
            self.assertNotIn(answer, page)
        self.assertEqual(re.findall("^#.*", page, re.MULTILINE),
                         re.findall("^#.*", whole, re.MULTILINE))
        self.assertEqual(page.count("This copy has no answers."), whole.count("<details>") - 1)
        for kept in ["For which \\f$ N \\f$ is", "Answers to the self-test", "Capture by value"]:
            self.assertIn(kept, page)

    def test_exercises_are_copied_from_it(self):
        self.student("exercise", "01.1")
        [exercise] = exercises.exercises("01.1")
        self.assertEqual((self.folder / PLACE / "exercise.cpp").read_text(), exercise.starter())

    @full
    def test_it_configures_and_checks(self):
        for tests in "ON", "OFF":
            subprocess.run(["cmake", "--preset", "release", "-S", self.tree, "-B",
                            self.folder / "build", f"-DSTOKESBOOK_TESTS={tests}"], check=True,
                           stdout=subprocess.DEVNULL)
        self.student("exercise", "01.1")
        self.assertIn("0 of 4 tasks passed", self.student("check", "01.1", code=1))


class Author(Tool):
    def compile(self, *arguments, code=0):
        result = subprocess.run(["c++", "-std=c++20", "-I", CHAPTERS.parent, *arguments],
                                cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(result.returncode, code, result.stderr)
        return result.stderr

    def write_variants(self, source, code=0):
        (self.folder / "exercise.cpp").write_text(source)
        return self.tool("variants", ".", "out", code=code)

    def test_variants(self):
        self.write_variants(TAGGED)
        texts = exercises.variants(self.folder / "exercise.cpp").texts
        self.assertEqual([*texts], ["starter", "solution", "slow", "sign"])
        for name, lines in [("starter", ["not_done();"]), ("solution", ["right();", "second();"]),
                            ("slow", ["wrong();", "second();"]),
                            ("sign", ["right();", "minus();"])]:
            self.assertEqual(texts[name].splitlines(), ["int common;", *lines])
        for name in ["starter", "solution"]:
            self.assertEqual((self.folder / "out" / f"{name}.cpp").read_text(), texts[name])

    def test_one_program_has_all_variants(self):
        self.write_variants(FUNCTIONS)
        program = self.folder / "program"
        self.compile(self.folder / "out/variants.cpp", CHAPTERS / "variant.cpp", "-o", program)
        for variant, result in [("starter", "2 30\n"), ("solution", "1 20\n"), ("", "1 20\n"),
                                ("more", "3 20\n"), ("less", "0 40\n"), ("last", "1 50\n")]:
            output = subprocess.run([program], env={"STOKESBOOK_VARIANT": variant}, text=True,
                                    stdout=subprocess.PIPE, check=True).stdout
            self.assertEqual(output, result, variant)

    def test_compile_errors_name_the_authors_line(self):
        for line, text in enumerate(FUNCTIONS.splitlines(), 1):
            if "return" in text:
                self.write_variants(FUNCTIONS.replace(text, "return missing;", 1))
                errors = self.compile("-c", self.folder / "out/variants.cpp", code=1)
                self.assertIn(f"{self.folder / 'exercise.cpp'}:{line}:", errors)

    def test_bad_tags(self):
        for old, new, message in [
                ("//@ solution\nright", "right",
                 "exercise.cpp:7: this group has no starter or no solution"),
                ("//@ wrong slow: too slow", "//@ wrong slow", "exercise.cpp:6: not a tag"),
                ("//@ wrong slow: too slow", "//@ starter", "exercise.cpp:6: a second starter"),
                ("//@ starter\nnot", "//@ end\nnot", "exercise.cpp:2: this group has no starter"),
                ("minus();\n//@ end\n", "", "the last group has no end")]:
            self.assertIn(old, TAGGED)
            self.assertIn(message, self.write_variants(TAGGED.replace(old, new), code=1))

    def prove(self, results, code=0):
        """Runs the proof of a program with these outcomes, exit codes and texts per variant."""
        cases = ""
        for variant, (words, exit_code, text) in results.items():
            lines = [f"  task {k}, a title: {word}" for k, word in enumerate(words, 1)]
            cases += f"{variant}) echo '" + "\n".join([*lines, text]) + f"'; exit {exit_code} ;;\n"
        program = self.folder / "program"
        program.write_text(f'#!/bin/sh\ncase $STOKESBOOK_VARIANT in\n{cases}esac\nexit 4\n')
        program.chmod(0o755)
        return self.tool("prove", ".", "program", code=code)

    def test_proof(self):
        (self.folder / "exercise.cpp").write_text(TAGGED)
        right = {"starter": (["not done", "not done"], 1, ""),
                 "solution": (["passed", "passed"], 0, ""),
                 "slow": (["wrong", "passed"], 1, "it is too slow"),
                 "sign": (["passed", "wrong"], 1, "the sign")}
        self.prove(right)
        for variant, planted, message in [
                ("solution", (["passed", "wrong"], 1, ""), "solution does not pass"),
                ("solution", (["passed", "passed"], 1, ""), "solution does not pass"),
                ("solution", ([], 0, ""), "solution does not pass"),
                ("starter", (["not done", "passed"], 1, ""), "every task as not done"),
                ("starter", (["not done"], 1, ""), "every task as not done"),
                ("starter", (["not done", "not done"], 3, ""), "as not done"),
                ("slow", (["passed", "passed"], 0, ""), "slow is not rejected"),
                ("slow", (["wrong"], 3, ""), "slow is not rejected"),
                ("sign", (["passed", "wrong"], 1, ""), "does not say 'the sign'")]:
            self.assertIn(message, self.prove({**right, variant: planted}, code=1))

    def test_proof_of_a_wrong_answer_that_passes(self):
        """A program runs the solution if it has no variant of the given name."""
        program = BUILD / PLACE / "variants"
        self.tool("prove", ALIASING, program)
        source = (ALIASING / "exercise.cpp").read_text()
        planted = source.replace("  //@ end\n}", "  //@ wrong planted: never\n  //@ end\n}", 1)
        self.assertNotEqual(planted, source)
        (self.folder / "exercise.cpp").write_text(planted)
        self.assertIn("the wrong answer planted is not rejected",
                      self.tool("prove", ".", program.absolute(), code=1))

    def test_proof_wants_two_wrong_answers(self):
        self.write_variants(TAGGED.replace("//@ wrong slow: too slow\nwrong();\n", ""))
        self.assertIn("fewer than two", self.tool("prove", ".", ".", code=1))

    def test_every_exercise_is_complete_and_proved(self):
        folders = [p for p in CHAPTERS.glob("*/exercises/*")]
        self.assertTrue(folders)
        tests = (BUILD / "chapters/CTestTestfile.cmake").read_text()
        for folder in folders:
            self.assertEqual({p.name for p in folder.iterdir()},
                             {"README.md", "exercise.cpp", "check.cpp"}, folder)
            number = f"{folder.parents[1].name[:2]}.{folder.name.partition('_')[0]}"
            self.assertIn(f"exercise_{number}]", tests, f"{folder} is not in chapters/CMakeLists.txt")
            readme = (folder / "README.md").read_text()
            for part in ["# ", "**Objective.**", "**Tasks.**", "**Out of scope.**", "<details>"]:
                self.assertIn(part, readme, folder)
            self.assertRegex(readme, r"\*\*Time\.\*\* Some \d+ minutes; (easy|medium|hard)\.\n")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
