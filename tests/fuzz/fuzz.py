"""Feeds the program with damaged scenes, lists of bodies, sweeps, checkpoints and run folders.

For every input, the program must end with an exit code other than that of an internal error, or
report its progress, within bounded time and memory, and must touch no file outside its folder. The
seed and the number of a case determine it: --first N --count 1 runs case N again and keeps its
folder.
"""

import argparse
import concurrent.futures
import hashlib
import os
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile

SECONDS, BYTES = 30, 2 * 10**9

NUMBERS = ["0", "-0.0", "1", "-1", "7", "8", "9", "1e-320", "1e-200", "1e-100", "1e-30", "1e-12", "1e-8", "1e-3", "0.5",
           "0.999", "1e3", "1e5", "1e12", "1e100", "1e101", "1e308", "1e999", "nan", "inf", "-inf", "2147483648",
           "-9223372036854775808", "9223372036854775808", "64", "1000000", "''", "'auto'", "true", "[]", "{}", "[[0]]",
           "1979-05-27"]

CORPUS = pathlib.Path(__file__).parent / "corpus"
LISTS = [(CORPUS / name).read_text() for name in ("placements.csv", "ellipses.csv")]
SCENES = [(CORPUS / name).read_text() for name in ("loads.toml", "container.toml", "list.toml")]

SWEEP = """
scene = "scene.toml"
seeds = { first = 1, count = 2 }
[[axes]]
key = "solver.tolerance"
name = "tolerance"
values = [0.01, 0.02]
[[collect]]
table = "steps.csv"
column = "dt"
average = [0.0, 0.2]
"""


def damaged_text(draw, text):
    """Makes one to four edits of a number, a word, a line or a character."""
    for _ in range(draw.randint(1, 4)):
        lines = text.splitlines(keepends=True) or [""]
        kind = draw.randrange(7)
        if kind <= 2:  # a number
            places = list(re.finditer(r"(?<![A-Za-z_])-?\d+(\.\d+)?(e-?\d+)?", text))
            if places:
                place = draw.choice(places)
                text = text[:place.start()] + draw.choice(NUMBERS) + text[place.end():]
        elif kind == 3:  # a word
            words = list(re.finditer(r"[A-Za-z_]{2,}", text))
            if words:
                place, other = draw.choice(words), draw.choice(words)
                text = text[:place.start()] + other[0] + text[place.end():]
        elif kind == 4:  # a line is removed, repeated or moved
            k, to = draw.randrange(len(lines)), draw.randrange(len(lines))
            line = lines[k] if draw.random() < 0.5 else lines.pop(k)
            if draw.random() < 0.7:
                lines.insert(to, line)
            text = "".join(lines)
        elif kind == 5:  # a character
            at = draw.randrange(len(text) + 1)
            text = text[:at] + draw.choice('\0\n"\'[]{}=,.#\\\x1b\u00e9\U0001f300 ') + text[at + draw.randrange(2):]
        else:  # the rest is missing
            text = text[:draw.randrange(len(text) + 1)]
    return text


def damaged_bytes(draw, data):
    """Changes, removes or repeats bytes, or replaces numbers of a text."""
    kind = draw.randrange(4)
    at = draw.randrange(len(data) + 1)
    if kind == 0:
        return data[:at]
    if kind == 1:
        return data[:at] + bytes(draw.randrange(256) for _ in range(draw.randint(1, 8))) + data[at + draw.randint(0, 8):]
    if kind == 2:
        return data[:at] + data[draw.randrange(len(data) + 1):]
    return damaged_text(draw, data.decode("latin-1")).encode("latin-1", "replace")


def replaced_file(draw, path, outside):
    """Replaces a file of a run folder by something else of the same name."""
    kind = draw.randrange(5)
    data = path.read_bytes()
    if kind <= 1:
        path.write_bytes(damaged_bytes(draw, data))
        return
    path.unlink()
    if kind == 2:
        path.mkdir()
    elif kind == 3:
        path.symlink_to(draw.choice([outside / "kept", path, "/dev/zero", "missing"]))
    else:
        os.mkfifo(path)


def with_checksum(checkpoint):
    """Returns a checkpoint whose last line has the right checksum, as in a forgery."""
    body, _, last = checkpoint.rstrip(b"\n").rpartition(b"\n")
    words = last.split()
    if len(words) < 2:
        return checkpoint
    fnv = 0xcbf29ce484222325
    for byte in body + b"\n":
        fnv = (fnv ^ byte) * 0x100000001b3 % 2**64
    return body + b"\n" + b" ".join(words[:-1]) + b" %016x\n" % fnv


def limited():
    resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_FSIZE, (10**8, 10**8))


def run(program, folder, *arguments):
    """Returns why the program should not have ended as it did; empty if it ended correctly."""
    environment = os.environ | {"OMP_NUM_THREADS": "1", "OMP_WAIT_POLICY": "passive"}
    try:
        result = subprocess.run([program, *arguments], cwd=folder, capture_output=True, timeout=SECONDS,
                                preexec_fn=limited, env=environment, stdin=subprocess.DEVNULL)
    except subprocess.TimeoutExpired as long_run:
        told = long_run.stdout and b"\nt = " in long_run.stdout
        return "" if told else f"no word in {SECONDS} s: {arguments}"
    message = result.stderr.decode("utf-8", "backslashreplace")
    if result.returncode not in (0, 1, 2, 3):
        return f"exit code {result.returncode}: {arguments}: {message[-500:]}"
    if result.returncode != 0 and not message.strip():
        return f"exit code {result.returncode} without a word: {arguments}"
    if not message.replace("\n", "").isprintable():
        return f"control characters in a message: {message[-500:]!r}"
    return ""


def state_of(folder):
    """Returns the hash of every file below a folder, without links."""
    return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
            for path in sorted(folder.rglob("*")) if path.is_file() and not path.is_symlink()}


def scene_case(draw, program, folder, _):
    (folder / "list.csv").write_text(damaged_text(draw, draw.choice(LISTS)) if draw.random() < 0.3
                                     else draw.choice(LISTS))
    text = damaged_text(draw, draw.choice(SCENES))
    (folder / "scene.toml").write_bytes(text.encode("utf-8", "replace"))
    return run(program, folder, draw.choice(["solve", "run", "run"]), "scene.toml", "--out", "out")


def setting_case(draw, program, folder, _):
    (folder / "list.csv").write_text(draw.choice(LISTS))
    (folder / "scene.toml").write_text(draw.choice(SCENES))
    settings = []
    for _ in range(draw.randint(1, 3)):
        key = draw.choice(["flow.rate", "time.dt", "time.t_final", "bodies.0.n_nodes", "bodies.1.position", "fill.0.count",
                           "solver.tolerance", "contact.minimum_separation", "walls.0.motion", "output.dt_write",
                           "bodies.0.shape", "solver.preconditioner", "body_lists.0.file", "a.b.c"])
        settings += ["--set", damaged_text(draw, f"{key}={draw.choice(NUMBERS)}").replace("\0", "")]
    return run(program, folder, "solve", "scene.toml", "--out", "out", *settings)


def sweep_case(draw, program, folder, _):
    (folder / "list.csv").write_text(draw.choice(LISTS))
    (folder / "scene.toml").write_text(draw.choice(SCENES))
    (folder / "sweep.toml").write_bytes(damaged_text(draw, SWEEP).encode("utf-8", "replace"))
    return run(program, folder, "sweep", "sweep.toml", "--out", "out", draw.choice(["--plan", "--collect", "--jobs=1"]))


def resume_case(draw, program, folder, finished):
    """Resumes a run folder with a state that does not match its files, or with traps in it."""
    shutil.copytree(finished, folder, dirs_exist_ok=True)
    run_folder = folder / "out"
    if draw.random() < 0.5:
        path = run_folder / "checkpoint"
        data = damaged_bytes(draw, path.read_bytes())
        path.write_bytes(with_checksum(data) if draw.random() < 0.7 else data)
    else:
        for _ in range(draw.randint(1, 2)):
            files = sorted(path for path in run_folder.iterdir() if path.is_file() and not path.is_symlink())
            replaced_file(draw, draw.choice(files), folder.parent / "outside")
    return run(program, folder, "run", "scene.toml", "--out", "out", draw.choice(["--resume", "--resume", "--overwrite"]))


CASES = [scene_case] * 6 + [setting_case] * 2 + [sweep_case] + [resume_case] * 3


def fuzz(program, number, seed, finished, keep):
    """Runs one case; returns its problem, or an empty text."""
    draw = random.Random(f"{seed} {number}")
    case = draw.choice(CASES)
    root = pathlib.Path(tempfile.mkdtemp(prefix="stokesbook-fuzz-"))
    try:
        folder, outside = root / "inside", root / "outside"
        folder.mkdir(), outside.mkdir()
        (outside / "kept").write_text("not yours\n")
        problem = case(draw, program, folder, draw.choice(finished))
        if not problem and state_of(outside) != {"kept": hashlib.sha256(b"not yours\n").hexdigest()}:
            problem = "a file outside the folder was touched"
        if not problem and sorted(os.listdir(root)) != ["inside", "outside"]:
            problem = f"a file beside the folder was made: {os.listdir(root)}"
    finally:
        if keep:
            print(f"case {number}: {root}")
        else:
            shutil.rmtree(root)
    return f"case {number} ({case.__name__}): {problem}" if problem else ""


def finished_runs(program, folder):
    """Returns one finished run of each scene, whose folders the cases damage."""
    runs = []
    for k, scene in enumerate(SCENES):
        place = folder / str(k)
        place.mkdir()
        (place / "scene.toml").write_text(scene)
        (place / "list.csv").write_text(LISTS[0])
        problem = run(program, place, "run", "scene.toml", "--out", "out")
        assert not problem and (place / "out" / "checkpoint").exists(), problem
        runs.append(place)
    return runs


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=5000)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    numbers = range(arguments.first, arguments.first + arguments.count)
    with tempfile.TemporaryDirectory() as name, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        finished = finished_runs(arguments.program, pathlib.Path(name))
        tasks = [pool.submit(fuzz, arguments.program, number, arguments.seed, finished, arguments.count == 1)
                 for number in numbers]
        problems = [problem for task in tasks if (problem := task.result())]
    for problem in problems:
        print(problem)
    print(f"{len(numbers)} cases, {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
