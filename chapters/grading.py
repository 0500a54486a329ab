"""Grades the exercises that a class handed in: ./stokes check --dir.

CHECK_HELP of exercises.py says what the folder of a class holds. Each task runs in a program of its
own, so that an endless loop or a crash in one task costs no other. A task has passed if check.cpp
has written so to a file; what a program prints, and its exit code, can only make a verdict worse.
"""

import collections
import json
import os
import pathlib
import signal
import tempfile

import exercises as tool

MARKS = {"passed": "+", "failed": "-", "does not compile": "C", "timed out": "T", "crashed": "X",
         "missing": ".", "not graded": "?"}
CHARACTERS_OF_DETAILS = 2000


def text_of_path(path):
    """The name of a file, which may have letters that are not in UTF-8."""
    return os.fsencode(path).decode("utf-8", "replace")


def handed_in(student):
    """Lists of a student's files, by "01.2" or "01_trapezoid/2_distance_of_a_pole"."""
    found = collections.defaultdict(list)
    for path in student.rglob("*.cpp"):
        if path.is_file():
            key = path.stem if path.name != "exercise.cpp" else "/".join(path.parts[-3:-1])
            found[key].append(path)
    return found


def files_for(exercise, found):
    """The one that counts is the last."""
    return sorted(found.get(exercise.place, []) + found.get(exercise.number, []),
                  key=lambda path: (path.stat().st_mtime_ns, path))


def run_task(program, task, seconds):
    """Verdict and details."""
    with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as other:
        file = pathlib.Path(other) / "report"  # not where the program may write its plots
        with open("/dev/null", "w") as nowhere:
            code = tool.run(program, folder, seconds, nowhere, report=file, task=task)
        word, said = tool.records_of(file).get(task, (None, ""))
    if code in (-signal.SIGXCPU, -signal.SIGKILL):
        return "timed out", f"after {seconds} CPU seconds, or {tool.CLOCK * seconds} s by the clock"
    if code not in (0, 1):
        return "crashed", f"exit code {code}"
    if not word:
        return "crashed", f"ended before its check did, with exit code {code}"
    if word == "passed" and code == 0:
        return "passed", ""
    return "failed", " ".join(f"{word}; {said}".split()).strip("; ")


def grade(build, exercise, file, name, seconds):
    """Verdict and details of each task."""
    def same(*verdict):
        return [verdict] * exercise.tasks()

    if file is None:
        return same("missing", "")
    try:
        # A letter that is not in UTF-8 may stand in a comment.
        text = file.read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        return same("not graded", str(error))
    program, output = tool.compile_reader(build, exercise, text, name)
    if program is None:
        return same("does not compile", output[:CHARACTERS_OF_DETAILS])
    return [run_task(program, task, seconds) for task in range(1, exercise.tasks() + 1)]


def require_starter(build, exercise):
    """Raises a Failure unless the starter compiles here, and is told to be not done."""
    tool.build_check(build, exercise)
    program, output = tool.compile_reader(build, exercise, exercise.starter(), "starter")
    verdict = program and run_task(program, exercise.tasks(), tool.SECONDS)
    if verdict != ("failed", "not done"):
        raise tool.Failure(f"exercise {exercise.number}, the starter: {verdict}\n{output}")


def grade_class(build, number, folder, json_file, seconds):
    """Prints the table of a class, and writes a row for each student and task."""
    students = sorted(p for p in folder.iterdir() if p.is_dir() and not p.name.startswith("."))
    if not students:
        raise tool.Failure(f"{folder} has no folder of a student")
    found = {student: handed_in(student) for student in students}
    chosen = [exercise for exercise in tool.exercises(number)
              if number or any(files_for(exercise, files) for files in found.values())]
    if not chosen:
        raise tool.Failure(f"{folder} has no file of an exercise, as ./stokes exercise writes them")
    output = json_file and json_file.open("w", encoding="utf-8")
    rows = []
    with tool.locked(build):
        for exercise in chosen:
            require_starter(build, exercise)
        names = {student: text_of_path(student.name) for student in students}
        width = max(len("student"), *map(len, names.values()))
        columns = {exercise: max(len(exercise.number), exercise.tasks()) for exercise in chosen}
        print(f"{'student':{width}}  " +
              "".join(f"{e.number:{columns[e]}}  " for e in chosen) + "passed")
        for student in students:
            line, passed, total = f"{names[student]:{width}}  ", 0, 0
            for exercise in chosen:
                files = files_for(exercise, found[student])
                name = text_of_path(files[-1].relative_to(folder)) if files else ""
                verdicts = grade(build, exercise, files[-1] if files else None, name, seconds)
                marks = "".join(MARKS[verdict] for verdict, _ in verdicts)
                line += f"{marks:{columns[exercise]}}  "
                passed, total = passed + marks.count("+"), total + len(marks)
                rows += [{"student": names[student], "exercise": exercise.number, "task": task,
                          "verdict": verdict, "details": details, "file": name,
                          "submissions": len(files)}
                         for task, (verdict, details) in enumerate(verdicts, 1)]
            print(f"{line}{passed} of {total}", flush=True)
    print("a mark for each task: " + ", ".join(f"{m} {v}" for v, m in MARKS.items()))
    if output:
        with output:
            json.dump(rows, output, indent=1)
            output.write("\n")
    if any(row["verdict"] == "not graded" for row in rows):
        raise SystemExit(1)
