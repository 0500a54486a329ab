"""Tests stokes sweep as its users run it: tables, lost workers, shared folders and errors.

Usage: test_program.py PROGRAM SWEEPS [unittest arguments]
"""

import csv
import fcntl
import os
import pathlib
import re
import signal
import statistics
import subprocess
import sys
import unittest

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parents[1]))
from tiers import full
from sweeping import PROGRAM, SCENE, SWEEP, SWEEPS, TASKS, Sweeping


class Results(Sweeping):
    def test_the_table_is_that_of_the_runs_by_numpy(self):
        told = self.sweep("--out", "a", "--jobs", 2)
        self.assertEqual(len([line for line in told.stdout.splitlines() if "done" in line]), TASKS)
        with open(self.folder / "a/tasks.csv") as file:
            tasks = list(csv.DictReader(file))
        with open(self.folder / "a/results.csv") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(tasks), TASKS)
        self.assertEqual([(row["count"], row["flow.rate"]) for row in rows],
                         [("2", "0.5"), ("2", "1.0"), ("3", "0.5"), ("3", "1.0")])
        # The quantile p = 0.975 of Student's distribution with 2 degrees of freedom.
        student = 0.95 / (2 * 0.975 * 0.025) ** 0.5
        for row in rows:
            averages, gaps = [], []
            for task in tasks:
                if any(task[key] != row[key] for key in ("count", "flow.rate")):
                    continue
                folder = self.folder / "a" / task["folder"]
                table = numpy.genfromtxt(folder / "rheology.csv", names=True, delimiter=",")
                t = numpy.append(0.25, table["t"][table["t"] > 0.25])
                s12 = numpy.interp(t, table["t"], table["s12"])
                averages.append(float(numpy.sum(numpy.diff(t) * (s12[1:] + s12[:-1])) / 2 / 0.75))
                steps = numpy.genfromtxt(folder / "steps.csv", names=True, delimiter=",")
                gaps.append(float(steps["min_gap"].min()))
                saved = (folder / "scene.toml").read_text()
                self.assertIn(f"seed = {task['seed']}\n", saved)
                self.assertIn(f"rate = {task['flow.rate']}\n", saved)
            self.assertEqual(row["runs"], "3")
            for name, values in ("s12", averages), ("min_gap", gaps):
                error = statistics.stdev(values) / 3**0.5
                expected = [statistics.mean(values), error, student * error]
                found = [float(row[name + end]) for end in ("", "_standard_error", "_interval")]
                numpy.testing.assert_allclose(found, expected, rtol=1e-11)

    def test_results_without_a_folder_are_named_after_the_sweep(self):
        self.sweep("--plan")
        planned = sorted(path.relative_to(self.folder).as_posix()
                         for path in (self.folder / "out").iterdir())
        self.assertEqual(planned, ["out/sweep"])

    @full
    def test_jobs_do_not_change_a_bit(self):
        for jobs in 1, 3:
            self.sweep("--out", f"jobs{jobs}", "--jobs", jobs)
        self.assertEqual(self.results("jobs1"), self.results("jobs3"))

    def test_scenes_without_time_are_solved_once(self):
        self.write("scene.toml", SCENE[:SCENE.index("[time]")])
        self.write("sweep.toml", 'scene = "scene.toml"\nseeds = [3, 1]\n[[collect]]\n'
                   'table = "rheology.csv"\ncolumn = "s12"\ntake = "last"\n')
        self.sweep("--out", "a")
        values = [float((self.folder / "a/runs" / run / "rheology.csv").read_text()
                        .splitlines()[1].split(",")[5]) for run in ("0000", "0001")]
        row = (self.folder / "a/results.csv").read_text().splitlines()[1].split(",")
        self.assertEqual(row[:3], ["2", "0", "0"])
        self.assertAlmostEqual(float(row[3]), sum(values) / 2, places=14)
        solved = subprocess.run([PROGRAM, "solve", "scene.toml", "--out", "b", "--set", "seed=3"],
                                cwd=self.folder, capture_output=True)
        self.assertEqual(solved.returncode, 0)
        self.assertEqual(*((self.folder / run / "rheology.csv").read_bytes()
                           for run in ("a/runs/0000", "b")))

    def test_sweeps_that_ship(self):
        sweeps = sorted(SWEEPS.glob("*.toml"))
        self.assertGreaterEqual(len(sweeps), 2)
        for sweep in sweeps:
            out = self.folder / sweep.stem
            planned = subprocess.run([PROGRAM, "sweep", sweep, "--out", out, "--plan"],
                                     capture_output=True, text=True)
            self.assertEqual(planned.returncode, 0, planned.stderr)
            last = len((out / "tasks.csv").read_text().splitlines()) - 2
            self.assertIn(f"--array=0-{last} ", planned.stdout)

    def test_the_page_of_sweeps(self):
        """The sweep on the page has the columns that the Python code on the page prints."""
        page = (SWEEPS.parents[2] / "docs/sweeps.md").read_text()
        blocks = dict(re.findall(r"```(toml|python)\n(.*?)```", page, re.DOTALL))
        self.write("page.toml", blocks["toml"].replace("../scenes", str(SWEEPS.parent / "scenes")))
        for how in "--plan", "--collect":
            subprocess.run([PROGRAM, "sweep", "page.toml", "--out", "out/sweep", "--quiet", how],
                           cwd=self.folder, stdout=subprocess.DEVNULL, check=True)
        printed = subprocess.run([sys.executable, "-c", blocks["python"]], cwd=self.folder,
                                 capture_output=True, text=True)
        self.assertEqual(printed.returncode, 0, printed.stderr)
        self.assertEqual(printed.stdout.count(" +- "), 6)

    def test_a_task_of_a_sweep_that_ships(self):
        out = self.folder / "a"
        for arguments in ["--plan"], ["--task", "0"], ["--collect"]:
            result = subprocess.run([PROGRAM, "sweep", SWEEPS / "couette.toml", "--out", out,
                                     *arguments], capture_output=True, text=True)
            self.assertEqual(result.returncode, 0, result.stderr)
        with open(out / "results.csv") as file:
            row = next(csv.DictReader(file))
        self.assertEqual(row["runs"], "1")
        self.assertGreater(float(row["torque_ratio"]), 1.0)  # bodies increase the viscosity


class Losses(Sweeping):
    """A sweep of 12 runs survives the loss of a worker, of all workers, and of itself."""

    @classmethod
    def setUpClass(cls):
        cls.whole = cls.undisturbed()

    def test_a_worker_is_killed(self):
        process = self.start("--out", "a", "--jobs", 2)
        task = self.kill_one_with_a_checkpoint("a")
        told, errors = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 0, errors)
        self.assertEqual(errors, "")
        self.assertIn("Killed", (self.folder / f"a/runs/{task:04}/log.txt").read_text())
        self.assertRegex(told, rf"\ntask {task}: .*: done")
        # The task was resumed, not restarted.
        self.assertLess(self.solves("a", task), self.solves("a", 0 if task > 0 else TASKS - 1))
        self.assertEqual(self.results("a"), self.whole)

    @full
    def test_a_worker_is_killed_again_and_again(self):
        process = self.start("--out", "a", "--jobs", 2)
        for _ in range(3):
            worker = self.wait_until("task 0", lambda: self.workers().get(0))
            self.assertTrue(self.caught("a", 0, worker))
            os.kill(worker, signal.SIGKILL)
            self.wait_until("its end", lambda: self.workers().get(0) != worker)
        told, errors = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 2, errors)
        self.assertRegex(errors, r"^stokes: task 0: .*: failed: killed by signal 9, the last of 3 "
                         r"tries\n$")
        self.assertEqual(len(self.done("a")), TASKS - 1)
        self.assertIn(b"\n2,0.5,2,1,0,", self.results("a"))
        self.sweep("--out", "a")
        self.assertEqual(self.results("a"), self.whole)

    def test_all_of_it_is_killed(self):
        process = self.start("--out", "a", "--jobs", 2)
        self.wait_until("three runs", lambda: len(self.done("a")) >= 3)
        self.kill_all(process)
        done = self.done("a")
        self.assertLess(len(done), TASKS)
        self.sweep("--out", "a", "--collect")
        before = (self.folder / "a/results.csv").read_text().splitlines()[1:]
        counts = [list(map(int, row.split(",")[2:5])) for row in before]
        self.assertEqual([sum(column) for column in zip(*counts)],
                         [len(done), 0, TASKS - len(done)])
        told = self.sweep("--out", "a", "--jobs", 2).stdout
        self.assertIn(f"{TASKS} tasks, {TASKS - len(done)} of them to do, 2 at a time\n", told)
        self.assertEqual(self.results("a"), self.whole)
        self.assertEqual(done, {run: of for run, of in self.done("a").items() if run in done})

    def test_workers_end_with_the_sweep(self):
        for cause in signal.SIGKILL, signal.SIGTERM, signal.SIGINT:
            process = self.start("--out", "a", "--jobs", 2)
            self.wait_until("workers", self.workers)
            process.send_signal(cause)
            self.wait_until("their end", lambda: not self.workers(), seconds=10)
            self.assertEqual(process.wait(), -cause)
        self.sweep("--out", "a", "--jobs", 2)
        self.assertEqual(self.results("a"), self.whole)

    def test_workers_outlive_gnu_parallel(self):
        """If GNU parallel is killed by SIGKILL, its workers go on; the next sweep waits for them."""
        process = self.start("--out", "a", "--jobs", 2)
        self.wait_until("two workers", lambda: len(self.workers()) == 2)
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        orphans = self.workers()
        self.sweep("--out", "a", "--jobs", 2)
        self.assertEqual(self.results("a"), self.whole)
        for task in orphans:  # the run was neither repeated nor resumed
            self.assertEqual(self.solves("a", task), self.solves("a", TASKS - 1))

    def test_gnu_parallel_ends(self):
        process = self.start("--out", "a", "--jobs", 2)
        self.wait_until("workers", self.workers)
        child, = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
        os.kill(int(child), signal.SIGTERM)
        _, errors = process.communicate(timeout=20)
        self.assertEqual(process.returncode, 3)
        self.assertIn("stokes: GNU parallel: ended before all tasks had ended", errors)
        self.wait_until("the workers' end", lambda: not self.workers(), seconds=10)

    def test_a_run_killed_at_its_very_end(self):
        self.sweep("--out", "a")
        (self.folder / "a/results.csv").unlink()
        (self.folder / "a/runs/0003/run.json").unlink()
        self.assertIn(" 1 of them to do", self.sweep("--out", "a").stdout)
        self.assertEqual(self.results("a"), self.whole)

    def test_tasks_one_by_one(self):
        self.sweep("--out", "a", "--plan")
        for task in range(TASKS):
            self.sweep("--out", "a", "--task", task)
        done = self.done("a")
        self.sweep("--out", "a", "--task", 5)
        self.assertEqual(self.done("a"), done)
        self.sweep("--out", "a", "--collect")
        self.assertEqual(self.results("a"), self.whole)

    @full
    def test_two_sweeps_share_a_folder(self):
        processes = [self.start("--out", "a", "--jobs", 2) for _ in range(2)]
        seen = set()
        while any(process.poll() is None for process in processes):
            seen |= set(self.done("a").items())
        for process in processes:
            _, errors = process.communicate()
            self.assertEqual(process.returncode, 0, errors)
        self.assertEqual(seen | set(self.done("a").items()), set(self.done("a").items()))
        self.assertEqual(self.results("a"), self.whole)

    def test_a_locked_task_is_waited_for(self):
        self.sweep("--out", "a", "--plan")
        with open(self.folder / "a/runs/0000/lock", "w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            process = self.start("--out", "a", "--jobs", 2)
            self.wait_until("the others", lambda: len(self.done("a")) == TASKS - 1)
            self.assertFalse((self.folder / "a/runs/0000/checkpoint").exists())
            self.assertIsNone(process.poll())
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 0, errors)
        self.assertEqual(self.results("a"), self.whole)


class Errors(Sweeping):
    def test_what_the_numerics_refuse_does_not_stop_the_others(self):
        self.write("scene.toml", SCENE[:SCENE.index("[[fill]]")] + """
[[bodies]]
shape = { kind = "circle", radius = 1.0 }
n_nodes = 48
[[bodies]]
shape = { kind = "circle", radius = 1.0 }
n_nodes = 48
""" + SCENE[SCENE.index("[solver]"):])
        self.write("sweep.toml", 'scene = "scene.toml"\n[[axes]]\nkey = "bodies.1.position"\n'
                   'name = "place"\nvalues = [[0.5, 0], [4, 0], [5, 0]]\n[[collect]]\n'
                   'table = "trajectory.csv"\nbody = 1\ncolumn = "x"\ntake = "last"\n')
        for _ in range(2):  # the next sweep tries the failed task again
            result = self.sweep("--out", "a", "--jobs", 1, code=2)
            self.assertRegex(result.stderr, r"^stokes: task 0: bodies\.1\.position = \[0\.5, 0\]: "
                             r"failed: .*body 0 and body 1.*overlap")
            self.assertEqual(result.stderr.count("\n"), 1)
        rows = (self.folder / "a/results.csv").read_text().splitlines()
        self.assertEqual(rows[1], '"[0.5, 0]",0,1,0,nan,nan,nan')
        self.assertRegex(rows[2], r'^"\[4, 0\]",1,0,0,[0-9.]+,nan,nan$')
        alone = self.sweep("--out", "a", "--task", 0, code=2)
        self.assertRegex(alone.stderr, r"^stokes: refused: .*body 0 and body 1")

    def test_a_fill_that_finds_no_place(self):
        self.write("sweep.toml", SWEEP.replace("[2, 3]", "[2, 200]").replace("count = 3", "count = 1"))
        result = self.sweep("--out", "a", code=2)
        self.assertRegex(result.stderr, r"task 2: fill\.0\.count = 200, .*: failed: .*scene\.toml: ")
        self.assertIn(b"\n200,1.0,0,1,0,", self.results("a"))

    def test_gnu_parallel_is_not_installed(self):
        def sweep(*arguments):
            return subprocess.run(self.command("--out", "a", *arguments), cwd=self.folder, text=True,
                                  capture_output=True, env=os.environ | {"PATH": "/nowhere"})
        result = sweep()
        self.assertEqual(result.returncode, 3)
        self.assertEqual(result.stderr, "stokes: GNU parallel: is not installed; install the package "
                         "parallel, or run the tasks by the commands of --plan\n")
        for how in ["--plan"], ["--task", "0"], ["--collect"]:
            self.assertEqual(sweep(*how).returncode, 0)

    def test_a_grown_sweep_computes_only_what_is_new(self):
        small = SWEEP.replace("count = 3", "count = 1").replace("values = [2, 3]", "values = [3]")
        grown = SWEEP.replace("first = 1, count = 3", "first = 0, count = 2")
        self.write("sweep.toml", small)
        self.sweep("--out", "a")
        before = self.done("a")
        self.assertEqual(len(before), 2)
        self.write("sweep.toml", grown)
        self.assertIn("lacks tasks", self.sweep("--out", "a", "--collect", code=3).stderr)
        self.assertIn("8 tasks, 6 of them to do", self.sweep("--out", "a").stdout)
        after = self.done("a")
        self.assertEqual({name: after[name] for name in before}, before)
        self.sweep("--out", "whole")
        self.assertEqual(self.results("a"), self.results("whole"))

    def test_bad_sweeps_make_nothing(self):
        for old, new, message in (
                ("seeds =", "seed =", "sweep.toml:3:1: seed: unknown key, did you mean 'seeds'?"),
                ("[2, 3]", "[]", "sweep.toml:7:10: axes[0].values = []: must be a list of one or"),
                ("to = 1.0", "to = 0.5", "sweep.toml:10:28: axes[1].range.to = 0.5: must differ"),
                ("scene.toml", "none.toml", 'sweep.toml:2:9: scene = "none.toml": the file none.toml '
                                          'does not exist or cannot be read'),
                ("[2, 3]", "[2, -3]", "sweep.toml:7:14: fill[0].count = -3: must be an integer >= 1"),
                ("flow.rate", "flow.rat", "sweep.toml:10:9: flow.rat = 0.5: unknown key, did you "
                                          "mean 'rate'?")):
            self.write("sweep.toml", SWEEP.replace(old, new))
            for how in [], ["--plan"]:
                result = self.sweep("--out", "a", *how, code=1)
                self.assertIn(message, result.stderr)
            self.assertFalse((self.folder / "a").exists())

    def test_bad_usage(self):
        planned = self.sweep("--out", "a", "--plan")
        self.assertIn("/a/runs/slurm-%a.txt", planned.stdout)
        self.assertIn("/5%%a/runs/slurm-%a.txt", self.sweep("--out", "5%a", "--plan").stdout)
        for arguments in (["--jobs", 0], ["--task", -1], ["--task", 0, "--plan"], ["--jobs", 2, "--plan"],
                          ["--task", 0, "--jobs", 2], ["--plan", "--collect"], ["--threads", 0]):
            self.sweep("--out", "a", *arguments, code=1)
        result = self.sweep("--out", "a", "--task", TASKS, code=1)
        self.assertIn("has 12 tasks, numbered from 0; there is no task 12", result.stderr)

    def test_folders(self):
        self.write("file", "")
        self.assertIn("file/out", self.sweep("--out", "file/out", code=3).stderr)
        for how in ["--task", 0], ["--collect"]:
            self.assertIn("--plan", self.sweep("--out", "none", *how, code=3).stderr)
        self.assertFalse((self.folder / "none").exists())
        self.sweep("--out", "a", "--plan")
        self.write("scene.toml", SCENE.replace("t_final = 1.0", "t_final = 1.1"))
        for how in [], ["--plan"], ["--task", 0], ["--collect"]:
            self.assertRegex(self.sweep("--out", "a", *how, code=3).stderr,
                             r"tasks\.csv: belongs to another sweep, or the scene has changed: the sweep "
                             r"lacks task \d+; choose another --out")
        self.write("scene.toml", SCENE)
        # The first task is the same, but some old results would get new labels.
        for old, new in ("to = 1.0", "to = 9.0"), ("count = 3", "count = 2"), ("[2, 3]", "[2, 4]"):
            self.write("sweep.toml", SWEEP.replace(old, new))
            refused = self.sweep("--out", "a", "--collect", code=3)
            self.assertIn("tasks.csv: belongs to another sweep", refused.stderr)
        self.assertFalse((self.folder / "a/results.csv").exists())
        self.write("sweep.toml", SWEEP)
        self.sweep("--out", "a", "--collect")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
