"""Provides a sweep of 12 small runs for tests of sweeps, and finds the processes of its tasks."""

import contextlib
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM, SWEEPS = sys.argv[1], pathlib.Path(sys.argv[2])

# Without this, tests that a shell starts in the background, and their children, ignore SIGINT.
signal.signal(signal.SIGINT, signal.default_int_handler)

SCENE = """
[flow]
kind = "shear"
rate = 1.0
[[fill]]
shape = { kind = "ellipse", semi_axes = [0.6, 0.3] }
count = 3
region = { box = [-3, -3, 3, 3] }
clearance = 0.3
n_nodes = "auto"
[solver]
tolerance = 1e-3
[time]
t_final = 1.0
dt = 0.025
method = "rk4"
[output]
dt_write = 0.1
"""

SWEEP = """
scene = "scene.toml"
seeds = { first = 1, count = 3 }
[[axes]]
key = "fill.0.count"
name = "count"
values = [2, 3]
[[axes]]
key = "flow.rate"
range = { from = 0.5, to = 1.0, count = 2 }
[[collect]]
table = "rheology.csv"
column = "s12"
average = [0.25, 1.0]
[[collect]]
table = "steps.csv"
column = "min_gap"
take = "least"
"""
TASKS = 12


def has_ended(information):
    """Returns whether a run.json exists and contains the exit status of its run."""
    return information.exists() and json.loads(information.read_text())["exit_status"] is not None


class Sweeping(unittest.TestCase):
    """A folder with a scene and its sweep; processes in the folder end with the test."""

    def setUp(self):
        # Characters that a shell or GNU parallel would replace.
        scratch = tempfile.TemporaryDirectory(prefix="stokesbook's {} \"$HOME\" ")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name).resolve()
        self.write("scene.toml", SCENE)
        self.write("sweep.toml", SWEEP)

    @staticmethod
    def undisturbed():
        """Returns the table of a sweep without any interruption."""
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            (folder / "scene.toml").write_text(SCENE)
            (folder / "sweep.toml").write_text(SWEEP)
            subprocess.run([PROGRAM, "sweep", folder / "sweep.toml", "--out", folder / "whole",
                            "--quiet"], check=True)
            return (folder / "whole/results.csv").read_bytes()

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def command(self, *arguments):
        return [PROGRAM, "sweep", "sweep.toml", *map(str, arguments)]

    def sweep(self, *arguments, code=0):
        result = subprocess.run(self.command(*arguments), cwd=self.folder, capture_output=True,
                                text=True)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result

    def start(self, *arguments):
        """Starts the sweep in the background, in a process group of its own."""
        process = subprocess.Popen(self.command(*arguments), cwd=self.folder, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   start_new_session=True)

        self.addCleanup(self.kill_all, process)
        return process

    def kill_all(self, process):
        """Kills the processes of a sweep: GNU parallel, and the shells and workers that it started."""
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.communicate()

        def killed():
            left = self.processes()
            for number in left:
                with contextlib.suppress(ProcessLookupError):
                    os.kill(number, signal.SIGKILL)
            return not left
        self.wait_until("the end of all processes", killed)

    def results(self, out):
        return (self.folder / out / "results.csv").read_bytes()

    def done(self, out):
        """Returns, for every finished task, file data that change if the task runs again."""
        return {path.parent.name: (path.stat().st_ino, path.stat().st_mtime_ns)
                for path in (self.folder / out).glob("runs/*/run.json") if has_ended(path)}

    def processes(self):
        """Returns the words of each process that works in this folder, by the process's number.

        A sanitizer may run as a second process of a worker, with the same words.
        """
        found, unique = {}, self.folder.name.split()[-1]
        for process in pathlib.Path("/proc").iterdir():
            with contextlib.suppress(OSError):  # no process, or a process that has just ended
                command = (process / "cmdline").read_bytes().decode()
                if unique in command:
                    found[int(process.name)] = command.split("\0")
        return found

    def workers(self):
        """Returns the process of each task that runs in this folder, by the task's number."""
        return {int(words[words.index("--task") + 1]): number
                for number, words in self.processes().items()
                if words[0] == PROGRAM and "--task" in words}

    def wait_until(self, what, value, seconds=60):
        """Waits for the first value that is true, and returns it."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if found := value():
                return found
            time.sleep(0.002)
        self.fail(f"{what}: not within {seconds} s")

    def frames(self, out, task):
        """Returns how many times a run has written; the last one may lack its checkpoint."""
        table = self.folder / out / f"runs/{task:04}/rheology.csv"
        return table.read_bytes().count(b"\n") - 1 if table.exists() else 0

    def solves(self, out, task):
        """Returns the number of linear systems that the last process of a task has solved."""
        text = (self.folder / out / f"runs/{task:04}/run.json").read_text()
        return json.loads(text)["totals"]["solves"]

    def caught(self, out, task, process):
        """Stops a worker so that it can be killed; returns whether its run had not ended before."""
        try:
            os.kill(process, signal.SIGSTOP)
            if not has_ended(self.folder / out / f"runs/{task:04}/run.json"):
                return True
            os.kill(process, signal.SIGCONT)
        except ProcessLookupError:
            pass
        return False

    def kill_one_with_a_checkpoint(self, out):
        """Kills a worker in the middle of its task; returns the task."""
        def killed():
            for task, process in self.workers().items():
                if self.frames(out, task) >= 3 and self.caught(out, task, process):
                    os.kill(process, signal.SIGKILL)
                    return [task]
            return None
        return self.wait_until("a worker with a checkpoint", killed)[0]
