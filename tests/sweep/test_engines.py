"""Tests sweeps that Slurm and GNU parallel run, by the commands that stokes sweep --plan prints.

Usage: test_engines.py PROGRAM SWEEPS [unittest arguments]
"""

import contextlib
import os
import pathlib
import re
import shlex
import signal
import subprocess
import sys
import unittest

from slurm import Slurm
from sweeping import TASKS, Sweeping


class Engines(Sweeping):
    @classmethod
    def setUpClass(cls):
        cls.whole = cls.undisturbed()

    def planned(self, word):
        """Returns the command of the plan that contains the word."""
        plan = self.sweep("--out", "a", "--plan").stdout.splitlines()
        found, = [line for line in plan if re.search(rf"(^|\| ){word} ", line)]
        return found

    def test_gnu_parallel(self):
        command = self.planned("env .* parallel")
        process = subprocess.Popen(["sh", "-c", command], cwd="/")
        self.kill_one_with_a_checkpoint("a")
        self.assertEqual(process.wait(120), 0)  # the task was tried again
        done = self.done("a")
        self.assertEqual(len(done), TASKS)
        self.sweep("--out", "a", "--collect")
        self.assertEqual(self.results("a"), self.whole)
        subprocess.run(["sh", "-c", command], cwd="/", check=True)  # the same command again
        self.assertEqual(done, self.done("a"))

    def test_slurm(self):
        command = shlex.split(self.planned("sbatch"))
        with Slurm(cpus=2) as slurm:
            def ended():
                return slurm("squeue", "-h") == ""

            slurm(*command)
            lost = self.kill_one_with_a_checkpoint("a")
            slurm.wait_until("the jobs have ended", ended)
            self.assertEqual(len(self.done("a")), TASKS - 1)
            self.assertIn("JobState=FAILED", slurm("scontrol", "show", "job", f"1_{lost}"))
            self.sweep("--out", "a", "--collect")
            self.assertNotEqual(self.results("a"), self.whole)
            slurm(*command)  # the same command again
            slurm.wait_until("the jobs have ended", ended)
            self.sweep("--out", "a", "--collect")
            self.assertEqual(self.results("a"), self.whole)

    def test_slurm_loses_its_node(self):
        command = shlex.split(self.planned("sbatch"))
        with Slurm(cpus=2) as slurm:
            slurm(*command)
            self.wait_until("three runs", lambda: len(self.done("a")) >= 3)
            workers = self.wait_until("a worker", lambda: [
                process for task, process in self.workers().items()
                if self.caught("a", task, process)])
            slurm.kill_node()
            for process in workers:
                self.kill_with_its_keeper(process)
            slurm.miss_node()
            self.assertLess(len(self.done("a")), TASKS)
            slurm.start_node()
            slurm.wait_until("the jobs have ended", lambda: slurm("squeue", "-h") == "")
            # Slurm itself has queued the lost jobs again.
            self.assertEqual(len(self.done("a")), TASKS)
            jobs = slurm("scontrol", "--oneliner", "show", "job")
            self.assertRegex(jobs, r" Restarts=[1-9]")
            self.sweep("--out", "a", "--collect")
            self.assertEqual(self.results("a"), self.whole)

    def kill_with_its_keeper(self, process):
        """Kills a worker and its parents up to Slurm's daemon of the job, the daemon first."""
        chain = [process]
        while True:
            status = pathlib.Path(f"/proc/{chain[-1]}/status").read_text()
            if status.startswith("Name:\tslurmstepd"):
                break
            chain.append(int(re.search(r"^PPid:\t(\d+)", status, re.MULTILINE)[1]))
            self.assertGreater(chain[-1], 1)
        for one in reversed(chain):
            with contextlib.suppress(ProcessLookupError):  # the process ended with its parent
                os.kill(one, signal.SIGKILL)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
