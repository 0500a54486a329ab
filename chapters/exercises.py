"""The exercises: ./stokes exercise and ./stokes check, and the proof that the checks can fail.

For authors. An exercise is a folder chapters/NN_METHOD/exercises/K_NAME of three files, and a line
in chapters/CMakeLists.txt, where it has the library METHOD and all that this one uses; a check that
wants another, such as study for a plot, links it there.

README.md     A title ("# ..."), time and difficulty, objective, tasks (numbered as in check.cpp),
              what is out of scope, and hints, each folded in <details>.
exercise.cpp  One source for all variants of the reader's file. Lines outside tags are common; a
              group of tagged blocks, one for each variant, stands for what the reader has to write:

                  double area(double radius) {
                    //@ starter
                    not_done(radius);  // your code instead of this line
                    //@ solution
                    return pi * radius * radius;
                    //@ wrong diameter: this is four times the area
                    return 4.0 * pi * radius * radius;
                    //@ end
                  }

              Every group has a starter and a solution; a wrong variant without a block in a group
              has the solution's. What follows the colon must appear in the rejection. At least two
              wrong variants; each a mistake that readers make. A group ends where its function
              does, because one program has all variants: each block becomes a branch of an if.
              Functions that the solution needs are a group outside functions, of an empty starter
              and a solution.
check.cpp     Declares the reader's functions and calls exercise::run() of chapters/check.hpp with
              one Task a function. Expected values come from identities or exact solutions, never
              from stored numbers. A Mistake for each wrong variant and others that can be computed.
              A mistake is named only if a reader's results agree with it at two inputs or more, so
              each check tries several. A task says on which earlier ones it builds.

A chapter's drills, K_drills, are one exercise of five short tasks. Their tests are in the full tier,
as are the proofs of 09.2, 13.2 and 13.3, which solve many systems.

The reader's file, its check and the variants are compiled with the warnings of the project and with
assertions, the reader's file and the variants also with sanitizers. The test exercise_NN.K proves:
the starter reports every task as not done, the solution passes all, and every wrong variant is
rejected with its text. The test exercise_NN.K_includes proves that the starter and the solution
compile with no more than their own includes.

Usage: exercises.py exercise ..., exercises.py check BUILD ...    as ./stokes does; see --help
       exercises.py variants EXERCISE FOLDER       writes the source of the program of all variants
       exercises.py prove EXERCISE PROGRAM         runs it for every variant
"""

import argparse
import collections
import contextlib
import fcntl
import itertools
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

CHAPTERS = pathlib.Path(__file__).resolve().parent
TAG = re.compile(r"\s*//@ (?:(starter|solution|end)|wrong (\w+): (\S.*?))\s*$")
OUTCOME = re.compile(r"^  task (\d+), .*: (passed|not done|wrong|stopped by an exception)$",
                     re.MULTILINE)
RECORD = re.compile(r"^(\d+)\t([a-z ]+)\t(.*)$", re.MULTILINE)  # of check.cpp, on a task
RECORDS = "checked.txt"  # beside the reader's file, of the last check
SECONDS = 60  # of CPU for a reader's program, which may loop for ever
SECONDS_TO_COMPILE = 300  # of CPU
CLOCK = 10  # seconds by the clock per second of CPU: a program may wait for ever
BYTES_WRITTEN = 1 << 30  # by a program, to each file
BYTES_OF_COMPILER = 4 << 30
ANSWERS = re.compile(r"@htmlonly\[block\]\n<details><summary>Answers</summary>.*?</details>\n"
                     r"@endhtmlonly\n", re.DOTALL)  # on the page for teachers

EXERCISE_HELP = """usage: ./stokes exercise [NN[.K]]
       ./stokes exercise --student-tree FOLDER

Without a number: lists all exercises, and how far you are. With one: copies the starters of a
chapter, or of one exercise, to ./exercises. What is there already is kept.

--student-tree FOLDER    writes a copy of this tree, as far as git tracks it, into a new folder,
                         without the solutions and the wrong answers of the exercises, and without
                         the teachers' answers. ./stokes exercise and ./stokes check work there."""

CHECK_HELP = """usage: ./stokes check                        how far you are, in all chapters
       ./stokes check NN[.K] [--hint] [--explain] [--watch]
       ./stokes check [NN[.K]] --dir FOLDER [--json FILE] [--seconds S]

The second form compiles and checks your files in ./exercises: of a chapter, or one exercise.
--hint      prints the hint of each task that has not passed
--explain   prints its formula
--watch     checks again whenever a file changes, until you press Ctrl-C
What a check has found is kept in checked.txt beside your file. Exit code: 0 if all tasks pass,
else 1.

The third form grades a class. FOLDER has a folder for each student, and this folder has, at any
depth, files NN_METHOD/K_NAME/exercise.cpp, as ./stokes exercise writes them, or NN.K.cpp. Of
several files for one exercise, the newest by time counts; of equally old ones, the last by name.
Without a number, those exercises are graded for which any student has a file.
--json FILE    also writes a list with a row for each student and task: student, exercise, task,
               verdict, details, file and submissions (the number of files for this exercise)
--seconds S    time for each task, in seconds of CPU; 60 by default, and ten times as long by the
               clock
Each task runs in a program of its own, and no task passes by what this program prints or returns.
The programs have your rights, however: grade files that you do not trust in a container, and in a
tree for students (./stokes exercise --help), where no file can include a solution.
Exit code: 0 if everything was graded, whatever the marks; 1 if something could not be graded."""


class Failure(Exception):
    """What the user is told; exit code 1."""


class Exercise:
    """A folder of the book. Number: "01.2"; place: "01_trapezoid/2_distance_of_a_pole"."""

    def __init__(self, folder):
        self.folder = folder
        chapter = folder.parent.parent.name
        self.number = f"{chapter[:2]}.{folder.name.partition('_')[0]}"
        self.method = chapter[3:]
        self.place = f"{chapter}/{folder.name}"

    def __str__(self):
        return f"{self.number}  {self.title()}"

    def title(self):
        return text_of_file(self.folder / "README.md").splitlines()[0].removeprefix("# ")

    def target(self, part):
        return f"exercise_{self.number}_{part}"

    def tasks(self):
        """How many tasks it has."""
        return len(re.findall(r"^\d+\. ", text_of_file(self.folder / "README.md"), re.MULTILINE))

    def starter(self):
        return variants(self.folder / "exercise.cpp").texts["starter"]

    def copied_to(self):
        """The reader's folder."""
        return pathlib.Path("exercises") / self.place

    def passed(self):
        """How many tasks passed at the reader's last check; None without one."""
        file = self.copied_to() / RECORDS
        if not file.exists():
            return None
        return [word for word, _ in records_of(file).values()].count("passed")

    def state(self):
        passed = self.passed()
        if passed is None:
            return "open"
        return "solved" if passed == self.tasks() else "tried"


def exercises(number=""):
    """Those of "" (all), "01" (a chapter) or "01.2", in reading order."""
    everything = sorted(map(Exercise, CHAPTERS.glob("[0-9]*/exercises/[0-9]*")),
                        key=lambda exercise: exercise.place)
    if not number:
        return everything
    wanted = number.zfill(2) if "." not in number else number.zfill(4)
    found = [e for e in everything if wanted in (e.number, e.number[:2])]
    if not found:
        raise Failure(f"there is no exercise {number}; there are\n" +
                      "\n".join(f"  {e}" for e in everything))
    return found


Variants = collections.namedtuple("Variants", ["texts", "rejections", "together"])


def variants(source):
    """Text of every variant of an exercise.cpp, the texts that must reject the wrong ones, and one
    text that has all variants, line by line where the source has them."""
    pieces, group, block, rejections = [], None, None, {}

    def require(condition, message):
        if not condition:
            raise Failure(f"{source}:{number}: {message}")

    for number, line in enumerate(text_of_file(source).splitlines(keepends=True), 1):
        if "//@" not in line:
            (pieces if group is None else block).append(line)
            continue
        tag = TAG.match(line)
        require(tag, "not a tag: starter, solution, wrong NAME: TEXT, or end")
        if tag[1] == "end":
            require({"starter", "solution"} <= (group or {}).keys(),
                    "this group has no starter or no solution")
            pieces.append(group)
            group = None
            continue
        name = tag[1] or tag[2]
        if group is None:
            group = {}
        require(name not in group, f"a second {name} in one group")
        block = group[name] = []
        if tag[2]:
            rejections.setdefault(name, []).append(tag[3])
    require(group is None, "the last group has no end")
    names = ["starter", "solution", *rejections]
    texts = {name: "".join(text_of(piece, name) for piece in pieces) for name in names}
    return Variants(texts, rejections, "".join(map(text_of_all, pieces)))


def text_of(piece, variant):
    """A common line, or what a group has for a variant."""
    return piece if isinstance(piece, str) else "".join(piece.get(variant, piece["solution"]))


def text_of_all(piece):
    """A common line, or a chain of conditions, in which each variant has its block of a group."""
    if isinstance(piece, str):
        return piece
    if piece.keys() == {"starter", "solution"} and not piece["starter"]:  # outside functions
        return "\n\n" + "".join(piece["solution"]) + "\n"
    text, others = "", piece.keys() - {"solution"}
    for number, (name, block) in enumerate(piece.items(), 1):
        condition = (f"is_variant(\"{name}\")" if name != "solution" else
                     " && ".join(f"!is_variant(\"{other}\")" for other in sorted(others)))
        text += (("} else " if text else "") +
                 (f"if ({condition}) {{\n" if number < len(piece) else "{\n") + "".join(block))
    return text + "}\n"


def text_of_file(path):
    try:
        return path.read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        line = path.read_bytes().count(b"\n", 0, error.start) + 1
        raise Failure(f"{path}:{line}: not in UTF-8") from error


def records_of(file):
    """Outcome and details of every task, by number, from a file that check.cpp has written."""
    text = file.read_text(encoding="utf-8", errors="replace") if file.exists() else ""
    return {int(task): (word, details) for task, word, details in RECORD.findall(text)}


def write(path, text):
    """Keeps the time of a file that has this text already, so that it is not compiled again."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or text_of_file(path) != text:
        path.write_text(text, encoding="utf-8")


def list_exercises():
    for exercise in exercises():
        state = exercise.state()
        if state == "tried":
            state = f"{exercise.passed()} of {exercise.tasks()} tasks passed"
        elif state == "open":
            state = "copied" if exercise.copied_to().is_dir() else "not copied yet"
        print(f"{exercise.number}  {exercise.title():52} {state}")
    print("./stokes exercise NN copies the starters of a chapter to ./exercises/NN_METHOD;\n"
          "./stokes check NN.K tells whether an exercise is done.")


def show_progress():
    """Counts what earlier checks have found."""
    states = ["solved", "tried", "open"]
    print(f"{'chapter':20}" + "".join(f"{state:>8}" for state in states))
    total = collections.Counter()
    for chapter, group in itertools.groupby(exercises(), lambda e: e.folder.parent.parent.name):
        count = collections.Counter(exercise.state() for exercise in group)
        total += count
        print(f"{chapter:20}" + "".join(f"{count[state]:8}" for state in states))
    print(f"{'all':20}" + "".join(f"{total[state]:8}" for state in states))
    print("./stokes check NN.K checks an exercise; ./stokes exercise lists them.")


def copy(number):
    for exercise in exercises(number):
        place = exercise.copied_to()
        for path, text in [(place / "README.md", text_of_file(exercise.folder / "README.md")),
                           (place / "exercise.cpp", exercise.starter())]:
            if path.exists():
                print(f"kept   {path}: it is yours; for a fresh one, move it away first")
            else:
                write(path, text)
                print(f"wrote  {path}")


def write_student_tree(folder):
    """Copies what git tracks; of the tagged sources, the starters only, and of the page for teachers
    all but its folded answers."""
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise Failure(f"{folder} exists already")
    root = CHAPTERS.parent
    tracked = subprocess.run(["git", "-C", root, "ls-files", "-z"], capture_output=True, text=True)
    if tracked.returncode:
        raise Failure(f"git lists no files of {root}: {tracked.stderr.strip()}")
    for name in tracked.stdout.split("\0")[:-1]:
        source, target = root / name, folder / name
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(source, target, follow_symlinks=False)
        if pathlib.PurePath(name).match("chapters/*/exercises/*/exercise.cpp"):
            target.write_text(variants(source).texts["starter"], encoding="utf-8")
    page = folder / "docs/teaching.md"
    page.write_text(ANSWERS.sub("This copy has no answers.\n", text_of_file(page)), encoding="utf-8")


def without_build_lines(output):
    """What the compiler said, of what ninja prints."""
    return re.sub(r"^(FAILED: .*\n.*\n|\[\d+/\d+\] .*\n|ninja: .*\n?)", "", output,
                  flags=re.MULTILINE)


def limited(command, seconds, memory=None, **options):
    """Exit code of a command that may loop, wait, or write for ever; negative for a signal. The
    time is limited in CPU seconds, because other programs may keep the machine busy, and by the
    clock, because a program may wait for ever. The rest of its process group is ended with it."""
    def set_limits():
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
        for kind, limit in [(resource.RLIMIT_FSIZE, BYTES_WRITTEN), (resource.RLIMIT_CORE, 0),
                            (resource.RLIMIT_AS, memory)]:
            hard = resource.getrlimit(kind)[1]
            if limit is not None and (hard == resource.RLIM_INFINITY or limit < hard):
                resource.setrlimit(kind, (limit, limit))

    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stderr=subprocess.STDOUT,
                          start_new_session=True, preexec_fn=set_limits, **options) as process:
        try:
            return process.wait(CLOCK * seconds)
        except subprocess.TimeoutExpired:
            process.terminate()  # ninja ends its compilers
            with contextlib.suppress(subprocess.TimeoutExpired):
                process.wait(5)
            return -signal.SIGXCPU
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)


def run(program, folder, seconds=SECONDS, stdout=None, **settings):
    """Exit code of a program of the exercises, with settings that check.hpp and variant.hpp
    describe; leaks are not their subject, 1 is the code of a wrong task. Freed memory is watched
    for a while only, and one thread suffices: both save most of the time."""
    environment = {"ASAN_OPTIONS": "detect_leaks=0:exitcode=3:quarantine_size_mb=4:"
                                   "hard_rss_limit_mb=4000",
                   "UBSAN_OPTIONS": "exitcode=3", "OMP_NUM_THREADS": "1"}
    environment |= {f"STOKESBOOK_{name.upper()}": str(value) for name, value in settings.items()}
    return limited([program], seconds, cwd=folder, stdout=stdout,
                   env={**os.environ, **environment})


@contextlib.contextmanager
def locked(build):
    """Only one check at a time may use the programs of a build folder; ./stokes locks it too."""
    with (build / "lock").open("w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield


def build_check(build, exercise):
    """Builds the book's own part, which takes a while the first time."""
    # A terminal shows how far it is.
    result = subprocess.run(["cmake", "--build", build, "--target",
                             f"stokesbook_{exercise.method}", "stokesbook_variant",
                             exercise.target("check")], text=True,
                            stdout=2 if sys.stderr.isatty() else subprocess.PIPE,
                            stderr=subprocess.STDOUT)
    if result.returncode:
        raise Failure(f"the book's own part does not compile\n{result.stdout or ''}")


def compile_reader(build, exercise, text, name):
    """Compiles a reader's file; returns the program, or None, and what the compiler said, in which
    the file has the given name."""
    folder = build / "exercises" / exercise.place
    name = name.replace("\\", "\\\\").replace('"', '\\"').replace("\n", " ")
    write(folder / "reader.cpp", f'#line 1 "{name}"\n{text}')
    with tempfile.TemporaryFile("w+", errors="replace") as output:
        code = limited(["cmake", "--build", build, "--target", exercise.target("reader")],
                       SECONDS_TO_COMPILE, BYTES_OF_COMPILER, stdout=output)
        output.seek(0)
        return None if code else folder / "reader", without_build_lines(output.read())


def check_one(build, exercise, show=""):
    """Whether the reader's file passes; says all that there is to say."""
    place = exercise.copied_to()
    reader, records = (place / "exercise.cpp").absolute(), (place / RECORDS).absolute()
    print(f"{exercise}  ({place / 'exercise.cpp'})", flush=True)
    if not reader.exists():
        print(f"  there is no such file; ./stokes exercise {exercise.number[:2]} makes it")
        return False
    text = text_of_file(reader)
    records.write_text("")
    with locked(build):
        build_check(build, exercise)
        program, output = compile_reader(build, exercise, text, str(reader))
        print(output, end="", flush=True)
        if program is None:
            print("  does not compile")
            return False
        code = run(program, place, report=records, show=show)
    solved = code == 0 and exercise.state() == "solved"
    if code == -signal.SIGXCPU:
        print(f"\n  stopped after {SECONDS} CPU seconds, or {CLOCK * SECONDS} s by the clock")
    elif code not in (0, 1):
        print(f"\n  stopped by an error in the task named last (exit code {code})")
    elif code == 0 and not solved:
        print("\n  the program ended in the task named last: does your code call exit()?")
    elif not solved and not show:
        print(f"  for more: ./stokes check {exercise.number} --hint, and --explain for formulas")
    return solved


def check(build, number, show):
    chosen = exercises(number)
    if "." not in number:
        chosen = [e for e in chosen if e.copied_to().is_dir()]
    if not chosen:
        raise Failure(f"nothing to check in ./exercises: ./stokes exercise {number} copies "
                      "starters there")
    if not all([check_one(build, exercise, show) for exercise in chosen]):
        raise SystemExit(1)


def watch(build, number, show):
    """Checks each file at once, and again when its time has changed."""
    checked = {}
    while True:
        for exercise in exercises(number):
            try:
                time_of_file = (exercise.copied_to() / "exercise.cpp").stat().st_mtime_ns
            except FileNotFoundError:  # an editor may be replacing it
                continue
            if checked.get(exercise.number) == time_of_file:
                continue
            checked[exercise.number] = time_of_file
            try:
                check_one(build, exercise, show)
            except Failure as failure:
                print(f"stokes: {failure}")
            print("  waiting for the next change; Ctrl-C ends this", flush=True)
        if not checked:
            raise Failure(f"nothing to watch in ./exercises: ./stokes exercise {number} copies "
                          "starters there")
        time.sleep(0.5)


def write_variants(exercise, folder):
    """What a program of all variants is built from; starter and solution as the reader has them."""
    source = exercise / "exercise.cpp"
    texts, _, together = variants(source)
    for name in ["starter", "solution"]:
        write(folder / f"{name}.cpp", texts[name])
    # The compiler names the author's file in what it says.
    write(folder / "variants.cpp",
          '#include "chapters/variant.hpp"\nusing stokesbook::exercise::is_variant;\n'
          f'#line 1 "{source.absolute()}"\n' + together)


def outcomes(program, variant):
    """Exit code, output and the outcome of every task."""
    with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryFile("w+") as output:
        code = run(program.absolute(), folder, stdout=output, variant=variant)
        output.seek(0)
        text = output.read()
    return code, text, dict(OUTCOME.findall(text))


def prove(exercise, program):
    """Raises a Failure unless the check tells right from wrong."""
    rejections = variants(exercise / "exercise.cpp").rejections
    if len(rejections) < 2:
        raise Failure("fewer than two wrong variants")
    code, output, solved = outcomes(program, "solution")
    if code != 0 or not solved or set(solved.values()) != {"passed"}:
        raise Failure(f"the solution does not pass:\n{output}")
    code, output, tasks = outcomes(program, "starter")
    if code != 1 or tasks != dict.fromkeys(solved, "not done"):
        raise Failure(f"the starter does not report every task as not done:\n{output}")
    for name, texts in rejections.items():
        code, output, tasks = outcomes(program, name)
        if code != 1 or tasks.keys() != solved.keys() or "wrong" not in tasks.values():
            raise Failure(f"the wrong answer {name} is not rejected:\n{output}")
        for text in texts:
            if text not in output:
                raise Failure(f"the rejection of {name} does not say '{text}':\n{output}")


class Parser(argparse.ArgumentParser):
    """Of the options of a command; the help is a text, whose first part says how it is used."""

    def __init__(self, text):
        super().__init__(add_help=False)
        self.text = text

    def error(self, message):
        usage, _, _ = self.text.partition("\n\n")
        raise Failure(f"{message}\n{usage}")


def exercise_command(arguments):
    parser = Parser(EXERCISE_HELP)
    parser.add_argument("number", nargs="?", default="")
    parser.add_argument("--student-tree", type=pathlib.Path)
    options = parser.parse_args(arguments)
    if options.student_tree:
        write_student_tree(options.student_tree)
    elif options.number:
        copy(options.number)
    else:
        list_exercises()


def check_command(arguments):
    parser = Parser(CHECK_HELP)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("number", nargs="?", default="")
    for option in ["--hint", "--explain", "--watch"]:
        parser.add_argument(option, action="store_true")
    parser.add_argument("--dir", type=pathlib.Path)
    parser.add_argument("--json", type=pathlib.Path)
    parser.add_argument("--seconds", type=int, default=SECONDS)
    options = parser.parse_intermixed_args(arguments)
    show = " ".join(["hint"] * options.hint + ["formula"] * options.explain)
    if options.dir:
        import grading  # imports this module
        grading.grade_class(options.build, options.number, options.dir, options.json,
                            options.seconds)
    elif options.json:
        parser.error("--json requires --dir")
    elif options.number:
        (watch if options.watch else check)(options.build, options.number, show)
    elif options.watch or show:
        parser.error("which exercise?")
    else:
        show_progress()


def main(command, *arguments):
    if command in ("exercise", "check") and {"-h", "--help"} & {*arguments}:
        print(EXERCISE_HELP if command == "exercise" else CHECK_HELP)
    elif command == "exercise":
        exercise_command(arguments)
    elif command == "check":
        check_command(arguments)
    elif command == "variants" and len(arguments) == 2:
        write_variants(*map(pathlib.Path, arguments))
    elif command == "prove" and len(arguments) == 2:
        prove(*map(pathlib.Path, arguments))
    else:
        raise Failure("usage: ./stokes exercise [NN], ./stokes check [NN[.K]]")


if __name__ == "__main__":
    sys.modules["exercises"] = sys.modules["__main__"]
    try:
        main(*sys.argv[1:] or [""])
        sys.stdout.flush()
    except BrokenPipeError:  # nobody reads on; nor at the interpreter's end
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)
    except KeyboardInterrupt:
        sys.exit(130)
    except (Failure, OSError) as failure:
        sys.exit(f"stokes: {failure}")
