"""Measures how many random defects of src the quick tier of the tests catches.

Plants one defect at a time in a copy of the tree, builds what depends on it, and runs the quick
tests until a test fails. Debian 12 packages no mutation tester for C++. Mull, the best known, is
not in Debian 12, and mutates one program, while the tier runs many programs and scripts.

The results for a defect are
  not compiled  the compiler rejects it; another defect is drawn instead
  equivalent    the tests would run the same programs, byte for byte; another defect is drawn
  caught        a test fails, or takes far longer than without the defect
  survived      all tests pass
"""

import argparse
import collections
import difflib
import fcntl
import filecmp
import hashlib
import json
import math
import os
import pathlib
import random
import re
import shlex
import shutil
import signal
import subprocess
import sys
import threading
import time

import defects

ROOT = pathlib.Path(__file__).resolve().parents[2]
PRESET = "mutants"
# Arguments by which ctest selects the quick tier, without tests that require more address space
# than they may have here: for a browser, and for the sanitizers of the exercises.
QUICK = ["-L", "as_shipped|sanitized", "-E", "^(animation|exercises|grading)$"]

# Boost.Test prints such a line at once; the rest of the test can no longer change the result.
FIRST_ERROR = re.compile(r": (?:fatal )?error: in \"")
HEEDED = {"ENVIRONMENT", "WORKING_DIRECTORY", "PASS_REGULAR_EXPRESSION",
          "LABELS", "COST", "PROCESSORS", "RUN_SERIAL", "TIMEOUT"}  # properties of a test
MOST_MEMORY = 8 << 20  # KiB for a process: a defect may allocate without end


def sources(root):
    """Returns the sources in which defects are planted: name -> text."""
    return {path.relative_to(root).as_posix(): path.read_text()
            for path in sorted((root / "src").rglob("*")) if path.suffix in (".cpp", ".hpp")}


def draws(texts, seed):
    """Yields all defects of the sources as (file, line, defect), in the random order of the seed.

    Every line that can hold a defect is equally likely, so that a file is drawn in proportion to
    its code. On a line every kind of defect is equally likely, and within a kind every defect.
    """
    lines = collections.defaultdict(lambda: collections.defaultdict(list))
    for name, text in texts.items():
        for defect in defects.Source(text).defects():
            line = text.count("\n", 0, defect.start) + 1
            lines[name, line][defect.kind].append(defect)
    left = list(lines)
    generator = random.Random(seed)
    while left:
        place = generator.choice(left)
        kind = generator.choice(list(lines[place]))
        of_kind = lines[place][kind]
        yield *place, of_kind.pop(generator.randrange(len(of_kind)))
        if not of_kind:
            del lines[place][kind]
        if not lines[place]:
            left.remove(place)


def run(command, **options):
    """Runs a command that has to succeed; returns what it prints."""
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            errors="replace", **options)
    if result.returncode:
        sys.exit(f"{result.stdout}\nmutants: this failed: {shlex.join(map(str, command))}")
    return result.stdout


def files_below(folder):
    return {path.relative_to(folder) for path in folder.rglob("*") if path.is_file()}


def is_untouched(file, original):
    file, original = file.stat(), original.stat()
    return (file.st_size, file.st_mtime_ns) == (original.st_size, original.st_mtime_ns)


def mirror(source, target):
    """Makes target a copy of source, with the files' times of change."""
    names = files_below(source)
    for name in files_below(target) - names:
        (target / name).unlink()
    for name in names:
        if not ((target / name).is_file() and is_untouched(target / name, source / name)):
            (target / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(source / name, target / name)


running = {}  # running builds and tests, each in a session of its own -> signal that ends it


def kill(process, by=signal.SIGKILL):
    """Ends a process together with what it has started."""
    try:
        os.killpg(process.pid, by)
    except ProcessLookupError:
        pass


class Test:
    """A test of ctest, and the time it takes without a defect."""

    slack = (10, 60)  # CPU seconds and seconds that a test may take in addition

    def __init__(self, description, build):
        self.name = description["name"]
        self.command = description["command"]
        properties = {p["name"]: p["value"] for p in description["properties"]}
        if unknown := set(properties) - HEEDED:
            sys.exit(f"mutants: the test {self.name} has properties that mutants.py does not "
                     f"implement: {', '.join(sorted(unknown))}")
        self.environment = dict(v.split("=", 1) for v in properties.get("ENVIRONMENT", []))
        self.folder = properties.get("WORKING_DIRECTORY", build)
        self.patterns = properties.get("PASS_REGULAR_EXPRESSION", [])
        self.programs = [word for word in self.command if word.startswith(f"{build}/bin/")]
        self.loaded = {build / os.path.relpath(file, build) for program in self.programs for file in
                       [program, *re.findall(rf"=> ({build}/\S+)", run(["ldd", program]))]}
        self.seconds = None  # CPU time and elapsed time

    def reason_to_fail(self, scratch):
        """Runs the test; returns why it failed, or "" if it passed."""
        limits, wait = f"ulimit -c 0; ulimit -v {MOST_MEMORY}", None
        if self.seconds:
            # Limits CPU time, as the machine may be busy. All processes of the test inherit it.
            limits += f"; ulimit -t {math.ceil(5 * self.seconds[0] + self.slack[0])}"
            wait = 10 * self.seconds[1] + self.slack[1]
        scratch.mkdir(exist_ok=True)
        process = subprocess.Popen(
            ["sh", "-c", f'{limits}; exec "$@"', "sh", *self.command], cwd=self.folder,
            env={**os.environ, "OMP_WAIT_POLICY": "passive", "BOOST_TEST_COLOR_OUTPUT": "no",
                 **self.environment, "TMPDIR": str(scratch)},
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
            errors="replace", start_new_session=True)
        running[process] = signal.SIGKILL
        watch = threading.Timer(wait or 3600, kill, [process])
        watch.start()
        output = collections.deque(maxlen=10000)
        try:
            while line := process.stdout.readline(10000):
                output.append(line)
                if FIRST_ERROR.search(line):
                    return line.strip()
            process.wait()
        finally:
            kill(process)
            process.wait()
            process.stdout.close()
            watch.cancel()
            running.pop(process)
            shutil.rmtree(scratch, ignore_errors=True)
        if process.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
            return "takes too long"
        if self.patterns:  # ctest does not look at the exit code then
            text = "".join(output)
            return "" if any(re.search(p, text) for p in self.patterns) else "other output"
        last = next((line.strip() for line in reversed(output) if line.strip()), "no output")
        return f"exit code {process.returncode}: {last}" if process.returncode else ""


class Copy:
    """A copy of the tree with its build, in which one defect at a time is planted."""

    def __init__(self, root, folder):
        self.root = root
        self.folder = folder
        self.tree = folder / "tree"
        self.build = self.tree / "build" / PRESET
        self.pristine = folder / "pristine"  # the build without a defect
        # The program contains its commit. Without the ceiling, git would read the commit of the
        # tree around the copy.
        self.environment = {**os.environ, "GIT_CEILING_DIRECTORIES": str(folder)}
        self.tests = []

    def prepare(self, jobs, seconds):
        """Copies the tree and builds it; measures the tests' seconds if they are unknown."""
        if self.pristine.exists():
            mirror(self.pristine, self.build)  # an interrupted run may have left a defect
        if self._take_over_tree() or not self.pristine.exists():
            print(f"mutants: building {self.build}", flush=True)
            shutil.rmtree(self.pristine, ignore_errors=True)
            run(["cmake", "--preset", PRESET], cwd=self.tree, env=self.environment)
            run(self._build_command(jobs, self._programs()), env=self.environment)
            (self.folder / "seconds.json").unlink(missing_ok=True)
            mirror(self.build, self.pristine)
        # Tests that run no program of the build cannot see a defect.
        self.tests = [test for test in (Test(t, self.build) for t in self._listed_tests())
                      if test.programs]
        record = self.folder / "seconds.json"
        if seconds is None and record.exists():
            seconds = json.loads(record.read_text())
        if seconds is None:
            print(f"mutants: measuring {len(self.tests)} tests", flush=True)
            seconds = {test.name: self._measured(test) for test in self.tests}
            mirror(self.pristine, self.build)
            record.write_text(json.dumps(seconds))
        for test in self.tests:
            test.seconds = seconds[test.name]
        return seconds

    def _take_over_tree(self):
        """Copies files that differ; returns whether any did."""
        listed = run(["git", "-c", "safe.directory=*", "-C", self.root, "ls-files", "-z",
                      "--cached", "--others", "--exclude-standard"])
        names = {pathlib.Path(name) for name in listed.split("\0") if (self.root / name).is_file()}
        stale = {name for name in files_below(self.tree) - names if name.parts[0] != "build"}
        for name in stale:
            (self.tree / name).unlink()
        different = [name for name in names if not (self.tree / name).is_file()
                     or not filecmp.cmp(self.root / name, self.tree / name, shallow=False)]
        for name in different:
            (self.tree / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(self.root / name, self.tree / name)  # changed now, so that ninja rebuilds
        return bool(stale or different)

    def _listed_tests(self):
        shown = run(["ctest", "--test-dir", self.build, "--show-only=json-v1", *QUICK])
        return json.loads(shown[shown.index("{"):])["tests"]

    def _programs(self):
        """Returns the quick tests' programs. ctest lists commands only of programs that exist."""
        quick = {test["name"] for test in self._listed_tests()}
        programs = set()
        for listing in self.build.rglob("CTestTestfile.cmake"):
            text = listing.read_text()
            for name, command in re.findall(r"add_test\(\[=\[(.*?)\]=\] (.*)\)", text):
                if name in quick:
                    programs.update(re.findall(rf'"({self.build}/bin/[^"]+)"', command))
        return programs

    def _build_command(self, jobs, programs):
        targets = [os.path.relpath(program, self.build) for program in programs]
        return ["timeout", "3600", "ninja", "-C", self.build, "-j", str(jobs), *targets]

    def _builds(self, programs):
        """Builds programs; returns whether that succeeded."""
        process = subprocess.Popen(self._build_command(1, programs), env=self.environment,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                   start_new_session=True)
        running[process] = signal.SIGTERM  # ninja passes it on to the compilers
        try:
            return process.wait() == 0
        finally:
            running.pop(process)

    def _measured(self, test):
        """Returns the CPU seconds and elapsed seconds of a test without a defect."""
        before, start = os.times(), time.monotonic()
        if reason := test.reason_to_fail(self.folder / "scratch"):
            sys.exit(f"mutants: {test.name} fails without a defect: {reason}")
        after = os.times()
        return [after.children_user - before.children_user + after.children_system
                - before.children_system, time.monotonic() - start]

    def result(self, name, defect):
        """Plants a defect; returns the result, the test that caught it, and its message."""
        path = self.tree / name
        original, times = path.read_text(), path.stat()
        path.write_text(defect.planted(original))
        try:
            return self._first_failure(pathlib.Path(name).parts[1])
        finally:
            path.write_text(original)
            os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns))
            mirror(self.pristine, self.build)

    def _first_failure(self, room):
        def is_of_room(test):
            return test.name == room or test.name.startswith(f"{room}_")

        equivalent = True
        for test in sorted(self.tests, key=lambda t: (not is_of_room(t), t.seconds)):
            if not self._builds(test.programs):
                return "not compiled", "", ""
            if all(is_untouched(file, original) or filecmp.cmp(file, original, shallow=False)
                   for file in test.loaded
                   for original in [self.pristine / file.relative_to(self.build)]):
                continue
            equivalent = False
            if reason := test.reason_to_fail(self.folder / "scratch"):
                return "caught", test.name, reason
        return "equivalent" if equivalent else "survived", "", ""


class Campaign:
    """The draws of a seed and their results, in a file that a later run can continue."""

    def __init__(self, texts, seed, count, file, only=()):
        digest = hashlib.sha256("".join(texts.values()).encode()).hexdigest()
        head = {"seed": seed, "src": digest}
        lines = list(map(json.loads, file.read_text().splitlines())) if file.exists() else []
        if lines and lines[0] != head:
            sys.exit(f"mutants: {file} holds results of another seed or of another src; "
                     "please remove it, or name another folder by --out")
        self.results = {line["number"]: line for line in lines[1:]}
        self.draws = enumerate(draws(texts, seed))
        self.count = count
        if only:
            self.draws = iter([(number, draw) for number, draw
                               in zip(range(max(only) + 1), draws(texts, seed)) if number in only])
            self.count = math.inf
            for number in only:
                self.results.pop(number, None)
        self.texts = texts
        self.reached = 0  # draws taken so far that count as caught or survived
        self.under_way = 0
        self.stopped = False
        self.changed = threading.Condition()
        self.file = file
        file.parent.mkdir(parents=True, exist_ok=True)
        if not lines:
            self._write(head)

    def take(self):
        """Returns the next draw without a result, or None at the end.

        Waits while the draws under way may suffice, so that the draws of a campaign do not depend
        on the number of jobs.
        """
        with self.changed:
            while not self.stopped and self.reached < self.count:
                if self.reached + self.under_way >= self.count:
                    self.changed.wait()
                    continue
                number, draw = next(self.draws, (None, None))
                if number is None:
                    break
                if number not in self.results:
                    self.under_way += 1
                    return number, draw
                self.reached += counts(self.results[number])
        return None

    def finish(self, number, draw, outcome, seconds):
        """Records and prints the result of a draw."""
        name, line, defect = draw
        result, test, reason = outcome
        text = self.texts[name]
        diff = difflib.unified_diff(text.splitlines(), defect.planted(text).splitlines(),
                                    name, name, lineterm="", n=2)
        record = {"number": number, "file": name, "line": line, "kind": defect.kind,
                  "before": text[defect.start:defect.end], "after": defect.new, "result": result,
                  "test": test, "reason": reason, "seconds": round(seconds, 1),
                  "diff": "\n".join(diff)}
        with self.changed:
            self.under_way -= 1
            if not self.stopped:  # otherwise the test was ended and did not fail
                self.results[number] = record
                self.reached += counts(record)
                self._write(record)
                print(described(record), flush=True)
            self.changed.notify_all()

    def stop(self):
        with self.changed:
            self.stopped = True
            self.changed.notify_all()
        for process, by in list(running.items()):
            kill(process, by)

    def _write(self, line):
        with self.file.open("a") as file:
            file.write(json.dumps(line) + "\n")


def counts(record):
    return record["result"] in ("caught", "survived")


def on_one_line(text, width=40):
    text = " ".join(text.split())
    return text if len(text) <= width else text[:width - 3] + "..."


def described(record):
    by = f"  ({record['test']}: {on_one_line(record['reason'], 60)})" if record["test"] else ""
    return (f"{record['number']:4} {record['result']:12} {record['seconds']:6.1f} s  "
            f"{record['file']}:{record['line']}  {record['kind']}  "
            f"{on_one_line(record['before'])} -> {on_one_line(record['after']) or 'nothing'}{by}")


def interval(hits, n):
    """Returns Wilson's 95 % interval of a share."""
    z2 = 1.96 ** 2
    middle = (hits + z2 / 2) / (n + z2)
    half = math.sqrt(z2 * (hits * (n - hits) / n + z2 / 4)) / (n + z2)
    return middle - half, middle + half


def summary(records):
    """Returns the numbers of results by kind, with the diffs of the defects that survived."""
    number = collections.Counter(record["result"] for record in records)
    by_kind = collections.Counter((record["kind"], record["result"]) for record in records)
    survivors = [record for record in records if record["result"] == "survived"]
    lines = [f"\n{described(record)}\n{record['diff']}" for record in survivors]
    lines += ["", "kind          caught  survived"]
    for kind in sorted({record["kind"] for record in records if counts(record)}):
        lines.append(f"{kind:12} {by_kind[kind, 'caught']:7} {by_kind[kind, 'survived']:9}")
    lines += ["", f"drawn {len(records)}: not compiled {number['not compiled']}, "
                  f"equivalent {number['equivalent']}, caught {number['caught']}, "
                  f"survived {number['survived']}"]
    if n := number["caught"] + number["survived"]:
        low, high = interval(number["caught"], n)
        lines.append(f"caught: {100 * number['caught'] / n:.1f} % "
                     f"(95 % interval: {100 * low:.1f} to {100 * high:.1f} %)")
    return "\n".join(lines)


def work(copy, campaign):
    try:
        while taken := campaign.take():
            number, draw = taken
            start = time.monotonic()
            name, _, defect = draw
            campaign.finish(number, draw, copy.result(name, defect), time.monotonic() - start)
    except BaseException:
        campaign.stop()
        raise


def main():
    parser = argparse.ArgumentParser(description="Plants random defects in src, one at a time, and "
                                                 "lists those that the quick tests do not catch.")
    parser.add_argument("--count", type=int, default=200,
                        help="defects that compile and are not equivalent (default: 200)")
    parser.add_argument("--seed", type=int, default=1, help="default: 1")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(),
                        help="defects at a time, each in a build of its own (default: processors)")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build" / PRESET,
                        help="folder of the copies and their builds (default: build/mutants)")
    parser.add_argument("--out", type=pathlib.Path,
                        help="folder of results.jsonl, which a later run continues "
                             "(default: WORK/seed_SEED)")
    parser.add_argument("--only", type=int, nargs="+", default=[], metavar="NUMBER",
                        help="try these again, for example after a change of the tests")
    options = parser.parse_args()
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    options.work.mkdir(parents=True, exist_ok=True)
    lock = (options.work / "lock").open("w")
    fcntl.flock(lock, fcntl.LOCK_EX)

    copies = [Copy(ROOT, options.work.resolve() / str(i)) for i in range(options.jobs)]
    seconds = None
    for copy in copies:
        seconds = copy.prepare(options.jobs, seconds)
    out = options.out or options.work / f"seed_{options.seed}"
    campaign = Campaign(sources(copies[0].tree), options.seed, options.count, out / "results.jsonl",
                        options.only)
    threads = [threading.Thread(target=work, args=(copy, campaign)) for copy in copies]
    for thread in threads:
        thread.start()
    try:
        for thread in threads:
            thread.join()
    except KeyboardInterrupt:
        campaign.stop()
        for thread in threads:
            thread.join()
    print(summary([campaign.results[number] for number in sorted(campaign.results)]))


if __name__ == "__main__":
    main()
