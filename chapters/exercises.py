"""The exercises: ./stokes exercise and ./stokes check, and the proof that the checks can fail.

For authors. An exercise is a folder chapters/NN_METHOD/exercises/K_NAME of three files, and a line
in chapters/CMakeLists.txt, where it has the library METHOD and all that this one uses; a check that
wants another, such as study for a plot, links it there.

README.md     A title ("# ..."), objective, tasks (numbered as in check.cpp), what is out of scope,
              and hints, each folded in <details>.
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

The reader's file, its check and the variants are compiled with the warnings of the project and with
assertions, the reader's file and the variants also with sanitizers. The test exercise_NN.K proves:
the starter reports every task as not done, the solution passes all, and every wrong variant is
rejected with its text. The test exercise_NN.K_includes proves that the starter and the solution
compile with no more than their own includes.

Usage: exercises.py exercise [NN]                  copies starters; lists the exercises
       exercises.py check BUILD [NN[.K]]           compiles and checks the reader's files
       exercises.py variants EXERCISE FOLDER       writes the source of the program of all variants
       exercises.py prove EXERCISE PROGRAM         runs it for every variant
"""

import collections
import os
import pathlib
import re
import resource
import signal
import subprocess
import sys
import tempfile

CHAPTERS = pathlib.Path(__file__).resolve().parent
TAG = re.compile(r"\s*//@ (?:(starter|solution|end)|wrong (\w+): (\S.*?))\s*$")
OUTCOME = re.compile(r"^  task (\d+), .*: (passed|not done|wrong|stopped by an exception)$",
                     re.MULTILINE)
SECONDS = 60  # of CPU for a reader's program, which may loop for ever
SECONDS_BY_THE_CLOCK = 600  # for a program that may wait for ever


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


def write(path, text):
    """Keeps the time of a file that has this text already, so that it is not compiled again."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or text_of_file(path) != text:
        path.write_text(text, encoding="utf-8")


def list_exercises():
    for exercise in exercises():
        copied = (pathlib.Path("exercises") / exercise.place).is_dir()
        state = "copied" if copied else "not copied yet"
        print(f"{exercise.number}  {exercise.title():52} {state}")
    print("./stokes exercise NN copies the starters of a chapter to ./exercises/NN_METHOD;\n"
          "./stokes check NN.K tells whether an exercise is done.")


def copy(number):
    for exercise in exercises(number):
        place = pathlib.Path("exercises") / exercise.place
        starter = variants(exercise.folder / "exercise.cpp").texts["starter"]
        for path, text in [(place / "README.md", text_of_file(exercise.folder / "README.md")),
                           (place / "exercise.cpp", starter)]:
            if path.exists():
                print(f"kept   {path}: it is yours; for a fresh one, move it away first")
            else:
                write(path, text)
                print(f"wrote  {path}")


def without_build_lines(output):
    """What the compiler said, of what ninja prints."""
    return re.sub(r"^(FAILED: .*\n.*\n|\[\d+/\d+\] .*\n|ninja: .*\n?)", "", output,
                  flags=re.MULTILINE)


def run(program, folder, variant="", **options):
    """A program of the exercises; leaks are not their subject, 1 is the code of a wrong task. Freed
    memory is watched for a while only, and one thread suffices: both save most of the time. The
    time is limited in CPU seconds, because other programs may keep the machine busy, and by the
    clock, because a program may wait for ever."""
    settings = {"ASAN_OPTIONS": "detect_leaks=0:exitcode=3:quarantine_size_mb=4",
                "UBSAN_OPTIONS": "exitcode=3", "OMP_NUM_THREADS": "1",
                "STOKESBOOK_VARIANT": variant}

    def limit_time():
        resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 1))

    return subprocess.run([program], cwd=folder, timeout=SECONDS_BY_THE_CLOCK,
                          stderr=subprocess.STDOUT, preexec_fn=limit_time,
                          env={**os.environ, **settings}, **options)


def check_one(build, exercise):
    """Whether the reader's file passes; says all that there is to say."""
    place = pathlib.Path("exercises") / exercise.place
    reader = (place / "exercise.cpp").absolute()
    print(f"{exercise}  ({place / 'exercise.cpp'})", flush=True)
    if not reader.exists():
        print(f"  there is no such file; ./stokes exercise {exercise.number[:2]} makes it")
        return False
    # The compiler names the reader's file in what it says.
    write(build / "exercises" / exercise.place / "reader.cpp",
          f'#line 1 "{reader}"\n' + text_of_file(reader))
    ninja = ["cmake", "--build", build, "--target"]
    library = [*ninja, f"stokesbook_{exercise.method}", exercise.target("check")]
    # The first time this takes a while; a terminal shows how far it is.
    first = subprocess.run(library, text=True, stdout=2 if sys.stderr.isatty() else
                           subprocess.PIPE, stderr=subprocess.STDOUT)
    if first.returncode:
        raise Failure(f"the book's own part does not compile\n{first.stdout or ''}")
    compiled = subprocess.run([*ninja, exercise.target("reader")], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    print(without_build_lines(compiled.stdout), end="", flush=True)
    if compiled.returncode:
        print("  does not compile")
        return False
    try:
        code = run(build / "exercises" / exercise.place / "reader", place).returncode
    except subprocess.TimeoutExpired:
        print(f"\n  stopped after {SECONDS_BY_THE_CLOCK} s")
        return False
    if code == -signal.SIGXCPU:
        print(f"\n  stopped after {SECONDS} CPU seconds")
    elif code not in (0, 1):
        print(f"\n  stopped by an error in the task named last (exit code {code})")
    return code == 0


def check(build, number):
    chosen = exercises(number)
    if "." not in number:
        chosen = [e for e in chosen if (pathlib.Path("exercises") / e.place).is_dir()]
    if not chosen:
        raise Failure(f"nothing to check in ./exercises: ./stokes exercise {number or 'NN'} copies "
                      "starters there")
    if not all([check_one(build, exercise) for exercise in chosen]):
        raise SystemExit(1)


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
    with tempfile.TemporaryDirectory() as folder:
        result = run(program.absolute(), folder, variant, text=True, stdout=subprocess.PIPE)
    return result.returncode, result.stdout, dict(OUTCOME.findall(result.stdout))


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


def main(command, *arguments):
    if command == "exercise" and len(arguments) <= 1:
        copy(*arguments) if arguments else list_exercises()
    elif command == "check" and 1 <= len(arguments) <= 2:
        check(pathlib.Path(arguments[0]), *arguments[1:] or [""])
    elif command == "variants" and len(arguments) == 2:
        write_variants(*map(pathlib.Path, arguments))
    elif command == "prove" and len(arguments) == 2:
        prove(*map(pathlib.Path, arguments))
    else:
        raise Failure("usage: ./stokes exercise [NN], ./stokes check [NN[.K]]")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:] or [""])
        sys.stdout.flush()
    except BrokenPipeError:  # nobody reads on; nor at the interpreter's end
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)
    except (Failure, OSError) as failure:
        sys.exit(f"stokes: {failure}")
