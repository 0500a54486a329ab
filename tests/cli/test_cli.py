"""Tests the stokes program as its users run it: exit codes, messages, plan, records, resume.

Usage: test_cli.py PROGRAM SCENES [unittest arguments]
"""

import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parents[1]))
from tiers import full

PROGRAM, SCENES = sys.argv[1], pathlib.Path(sys.argv[2])

PAIR = """
[flow]
kind = "shear"
rate = 1.0
[[bodies]]
shape = { kind = "circle", radius = 1.0 }
position = [-2.0, 0.4]
n_nodes = 48
[[bodies]]
shape = { kind = "ellipse", semi_axes = [1.0, 0.6] }
position = [2.0, -0.4]
n_nodes = 48
[solver]
tolerance = 1e-5
[time]
t_final = 1.0
dt = 0.1
method = "adams_bashforth2"
[output]
dt_write = 0.1
formats = ["csv", "vtk", "svg", "html"]
fields = { box = [-3, -2, 3, 2], resolution = 19, quantities = ["velocity", "pressure"] }
"""


def stokes(*arguments, **options):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, **options)


class Program(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def scene(self, text=PAIR, name="pair.toml"):
        path = self.folder / name
        path.write_text(text)
        return path

    def run_scene(self, *arguments, text=PAIR, code=0):
        result = stokes("run", self.scene(text), *arguments, cwd=self.folder)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result

    def files(self, name):
        """Returns the contents of every file of a run, except files with wall times."""
        folder = self.folder / name
        return {
            p.name: p.read_bytes()
            for p in folder.iterdir()
            if p.name not in ("run.json", "steps.csv", "checkpoint", "checkpoint_before_end")
        }


class Usage(Program):
    def test_help_and_version(self):
        for arguments in (["--help"], ["run", "--help"], ["solve", "--help"]):
            result = stokes(*arguments)
            self.assertEqual(result.returncode, 0)
            self.assertIn("scene", result.stdout)
        for command in [], ["run"], ["solve"], ["sweep"]:
            version = stokes(*command, "--version")
            self.assertEqual(version.returncode, 0)
            self.assertRegex(version.stdout, r"^stokes \d+\.\d+\.\d+ \(git .+, (GNU|Clang)")

    def test_bad_usage(self):
        for arguments in ([], ["walk"], ["run"], ["run", "a.toml", "--thread"],
                          ["run", "a.toml", "--resume", "--overwrite"],
                          ["run", "a.toml", "--threads", "0"],
                          ["run", "a.toml", "--threads", "1025"]):
            result = stokes(*arguments)
            self.assertEqual(result.returncode, 1, arguments)
            self.assertNotEqual(result.stderr, "")

    def test_bad_scene(self):
        result = self.run_scene(text=PAIR.replace("radius = 1.0", "radius = -1.0"), code=1)
        self.assertIn("pair.toml:6", result.stderr)
        self.assertIn("radius = -1", result.stderr)
        self.assertFalse((self.folder / "out").exists())

    def test_missing_scene(self):
        result = stokes("run", self.folder / "none.toml")
        self.assertEqual(result.returncode, 1)
        self.assertIn("none.toml", result.stderr)

    def test_run_needs_time(self):
        text = PAIR[:PAIR.index("[time]")]
        self.assertIn("[time]", self.run_scene(text=text, code=1).stderr)

    def test_values_of_the_command_line(self):
        self.run_scene("--out", "a", "--set", "time.t_final=0.2", "--set", "fluid.viscosity=2.0")
        saved = (self.folder / "a" / "scene.toml").read_text()
        self.assertRegex(saved, r"viscosity = 2\.0")
        times = numpy.genfromtxt(self.folder / "a" / "trajectory.csv", names=True, delimiter=",")["t"]
        self.assertEqual(times.max(), 0.2)
        self.assertIn("--set", self.run_scene("--set", "time.tfinal=1", code=1).stderr)


class Plan(Program):
    def test_dry_run_prints_the_plan_and_writes_nothing(self):
        result = self.run_scene("--dry-run")
        for topic in ("problem", "unknowns", "N_0", "summation", "near correction",
                      "preconditioner", "fields", "contact", "time", "components", "closest pair",
                      "resolution"):
            self.assertIn(topic, result.stdout)
        self.assertEqual([p.name for p in self.folder.iterdir()], ["pair.toml"])

    def test_dry_run_refuses_what_a_run_would(self):
        text = PAIR.replace("-2.0, 0.4", "-0.01, 0.0").replace("2.0, -0.4", "2.0, 0.0")
        result = self.run_scene("--dry-run", text=text, code=2)
        self.assertIn("body 0 and body 1", result.stderr)
        self.assertIn("n_nodes", result.stderr)
        self.assertRegex(result.stdout, r"48 nodes; \d+ recommended")
        # A gap of 2 is not difficult for the solver, but it is narrower than the separation.
        contact = ("--set", 'time.method="euler"', "--set", "contact.minimum_separation=2.5")
        for how in [], ["--dry-run"]:
            result = self.run_scene(*how, *contact, "--out", "close", code=2)
            self.assertIn("contact.allow_close", result.stderr)
        self.run_scene("--dry-run", *contact, "--set", "contact.allow_close=true")

    def test_dry_run_reports_nodes_and_estimate(self):
        result = self.run_scene("--dry-run", text=PAIR.replace("n_nodes = 48", 'n_nodes = "auto"'))
        self.assertRegex(result.stdout, r"components +1 x circle 1, \d+ nodes initially, chosen")
        found = re.search(r"resolution +estimated error (\S+) of the velocities.*, 1e-05 required; "
                          r"nodes (\d+ x \d+)", result.stdout)
        self.assertIsNotNone(found, result.stdout)
        self.assertTrue(0.0 < float(found[1]) <= 1e-5)

    def test_the_plan_has_what_the_scene_needs_only(self):
        plan = stokes("run", SCENES / "couette.toml", "--dry-run").stdout
        self.assertRegex(plan, r"N_0 +yes")
        self.assertRegex(plan, r"rheology +one solve without bodies")
        self.assertNotRegex(plan, r"\n +fields ")
        self.assertRegex(plan, r"singularities +Stokeslets and rotlets")
        plan = stokes("run", SCENES / "jeffery.toml", "--dry-run").stdout
        self.assertRegex(plan, r"N_0 +no")
        self.assertNotRegex(plan, r"\n +rheology ")
        self.assertRegex(plan, r"near correction +no")
        self.assertRegex(plan, r"singularities +none")


class Records(Program):
    def test_tables_are_read_by_numpy(self):
        told = self.run_scene().stdout
        folder = self.folder / "out" / "pair"
        table = numpy.genfromtxt(folder / "trajectory.csv", names=True, delimiter=",")
        self.assertEqual(table.dtype.names, tuple("t,body,x,y,theta,ux,uy,omega,fx,fy,torque".split(",")))
        self.assertEqual(len(table), 2 * 11)
        numpy.testing.assert_allclose(numpy.unique(table["t"]), numpy.arange(11) / 10, atol=1e-15)
        steps = numpy.genfromtxt(folder / "steps.csv", names=True, delimiter=",")
        self.assertEqual(len(steps), 10)
        self.assertTrue((steps["velocity_error"] < 1e-5).all())
        self.assertFalse((folder / "walls.csv").exists())
        rheology = numpy.genfromtxt(folder / "rheology.csv", names=True, delimiter=",")
        numpy.testing.assert_array_equal(rheology["t"], numpy.unique(table["t"]))
        self.assertTrue(numpy.isnan(rheology["torque_ratio"]).all())
        # In shear of rate 1 without loads, the excess dissipation is S_12; only the ellipse has a
        # long axis.
        numpy.testing.assert_allclose(rheology["dissipation"], rheology["s12"], rtol=1e-12)
        theta = table["theta"][table["body"] == 1]
        numpy.testing.assert_allclose(rheology["order_parameter"], numpy.cos(2 * theta), atol=1e-12)
        information = json.loads((folder / "run.json").read_text())
        self.assertEqual(information["exit_status"], 0)
        for origin in ("version", "compiler", "flags", "machine"):
            self.assertTrue(information[origin], origin)
        self.assertIn(information["machine"], pathlib.Path("/proc/cpuinfo").read_text())
        self.assertTrue(any("preconditioner" in line for line in information["plan"]))
        resolution = information["resolution"]
        self.assertEqual(resolution["first_nodes"], [48, 48])
        self.assertEqual(resolution["most_nodes"], [48, 48])
        self.assertGreaterEqual(resolution["velocity_error"], steps["velocity_error"].max())
        self.assertTrue((steps["step_error"] > 0.0).all())
        self.assertLessEqual(resolution["configuration_error"], steps["step_error"].sum() * (1 + 1e-12))
        self.assertEqual(set(resolution["field_errors"]), {"velocity", "pressure"})
        self.assertIn("error estimates of fields, relative to their largest values: pressure ", told)

    def test_the_error_of_steps_is_told_beside_that_of_velocities(self):
        """The error of Euler's steps is far larger than that of the velocities, 1e-5."""
        for method, least, most in (("euler", 3e-4, 0.01), ("rk4", 0.0, 1e-6)):
            result = self.run_scene("--out", method, "--set", f"time.method={method}")
            found = re.search(r"error estimates: of velocities, relative to their scale, (\S+); of positions in "
                              r"radii and angles, by all steps together, (\S+)\n", result.stdout)
            self.assertLess(float(found[1]), 1e-5)
            resolution = json.loads((self.folder / method / "run.json").read_text())["resolution"]
            self.assertAlmostEqual(float(found[2]) / resolution["configuration_error"], 1.0, delta=0.1)
            self.assertTrue(least < resolution["configuration_error"] < most)

    def test_a_free_velocity_at_infinity_is_told(self):
        held = PAIR.replace('semi_axes = [1.0, 0.6] }', 'semi_axes = [1.0, 0.6] }\nheld = true')
        arguments = ("--set", "time.t_final=0.1")
        result = self.run_scene("--out", "free", *arguments, text=held)
        told = json.loads((self.folder / "free" / "run.json").read_text())["uniform_velocity"]
        table = numpy.genfromtxt(self.folder / "free" / "rheology.csv", names=True, delimiter=",")
        self.assertEqual(told, [table["uniform_x"][-1], table["uniform_y"][-1]])
        self.assertIn("the fluid at infinity has the velocity (0.", result.stdout)
        result = self.run_scene("--out", "given", *arguments, "--set", "flow.gauge_length=50",
                                text=held)
        self.assertNotIn("uniform_velocity", (self.folder / "given" / "run.json").read_text())
        self.assertNotIn("infinity", result.stdout)

    def test_messages_show_no_control_characters_and_no_long_values(self):
        """Control characters are escaped, and a text of a megabyte is cut in the middle."""
        evil = "\x1b[2J\x07\nstokes: done\x7f"
        for text in (f"[flow]\nkind = {json.dumps(evil)}\n", f"{json.dumps(evil)} = 1\n"):
            message = self.run_scene(text=text, code=1).stderr
            self.assertTrue(message.removesuffix("\n").isprintable(), message)
            self.assertIn("stokes: done", message)
        title = self.run_scene("--dry-run", text=f"title = {json.dumps(evil)}\n" + PAIR).stdout
        self.assertTrue(title.startswith("\\x1b[2J"))
        for arguments in ((f"--set=time.dt={'x' * 10**5}",), ("--threads", "x" * 10**5), (evil,)):
            message = self.run_scene(*arguments, code=1).stderr
            self.assertLess(len(message), 2500)
            self.assertTrue(message.replace("\n", "").isprintable(), message)
        message = self.run_scene(text="[flow]\nkind = \"" + "x" * 10**6 + "\"\n", code=1).stderr
        self.assertIn("flow.kind", message)
        self.assertIn("must be one of", message)
        self.assertLess(len(message), 2500)

    def test_closed_standard_streams_leave_the_files_alone(self):
        def close_streams():
            for stream in range(3):
                os.close(stream)
        self.run_scene("--out", "told")
        run = subprocess.run([PROGRAM, "run", self.scene(), "--out", "closed"], cwd=self.folder,
                             preexec_fn=close_streams)
        self.assertEqual(run.returncode, 0)
        self.assertEqual(self.files("closed"), self.files("told"))
        self.assertNotIn(b"GMRES iterations", (self.folder / "closed" / "steps.csv").read_bytes())

    def test_a_terminal_shows_a_line_of_progress_every_tenth_of_a_second_at_most(self):
        """The 1000 steps take about a millisecond each; the last one is always shown."""
        command = [PROGRAM, "run", self.scene(), "--set", "time.dt=0.001", "--set",
                   "output.dt_write=1.0", "--set", "output.formats=['csv']"]
        terminal, end_of_program = os.openpty()
        start = time.monotonic()
        with subprocess.Popen(command, cwd=self.folder, stdout=end_of_program) as run:
            os.close(end_of_program)
            shown = b""
            try:
                while some := os.read(terminal, 65536):
                    shown += some
            except OSError:  # Linux reports the end of a terminal by an error
                pass
            os.close(terminal)
        seconds = time.monotonic() - start
        self.assertEqual(run.returncode, 0)
        lines = re.findall(rb"\r\x1b\[Kt = (\S+) of 1, ", shown)
        self.assertLessEqual(len(lines), 2 + 10 * seconds)
        self.assertEqual(lines[-1], b"1")

    def test_memory_is_that_which_the_system_counts(self):
        with subprocess.Popen([PROGRAM, "run", self.scene(), "--out", "run"], cwd=self.folder,
                              stdout=subprocess.DEVNULL) as run:
            _, status, usage = os.wait4(run.pid, 0)
            run.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(run.returncode, 0)
        told = json.loads((self.folder / "run" / "run.json").read_text())["peak_memory"]
        self.assertLessEqual(told, 1024 * usage.ru_maxrss)
        self.assertGreater(told, 0.9 * 1024 * usage.ru_maxrss)

    def test_contact_is_recorded_where_the_scene_has_it(self):
        totals = {"ncp_iterations", "contact_solves", "contact_seconds", "halved_by_contact",
                  "largest_force_imbalance", "largest_torque_imbalance", "energy_injected"}
        tables = {"contacts.csv", "contacts.pvd", "contacts_000000.vtp"}
        arguments = ("--set", "time.t_final=0.1", "--set", 'time.method="euler"')
        contact = ("--set", "contact.minimum_separation=0.01")
        for name, extra in (("without", ()), ("with", contact)):
            result = self.run_scene("--out", name, *arguments, *extra)
            folder = self.folder / name
            written = tables & {path.name for path in folder.iterdir()}
            reported = totals & json.loads((folder / "run.json").read_text())["totals"].keys()
            self.assertEqual(written, tables if extra else set())
            self.assertEqual(reported, totals if extra else set())
            self.assertEqual("\ncontact: " in result.stdout, bool(extra))
            self.assertEqual("[contact]" in (folder / "scene.toml").read_text(), bool(extra))
        header = (self.folder / "with" / "contacts.csv").read_text().splitlines()[0]
        self.assertEqual(header, "t,a,b,x,y,nx,ny,force,gap")
        refused = self.run_scene(*contact, code=1)
        self.assertIn("adams_bashforth2", refused.stderr)

    def test_estimates_above_the_tolerance_are_told(self):
        """Steps press an ellipse to a turning wall; few nodes resolve the flow, not the force."""
        text = """
            [[bodies]]
            shape = { kind = "ellipse", semi_axes = [0.8, 0.3] }
            position = [0.0, 1.677]
            n_nodes = %d
            [[walls]]
            role = "outer"
            shape = { kind = "circle", radius = 2.0 }
            motion = { kind = "rotating", omega = 1.0 }
            n_nodes = %d
            [solver]
            tolerance = 1e-3
            [contact]
            minimum_separation = 0.02
            [time]
            t_final = 0.2
            dt = 0.1
            method = "euler"
            [output]
            dt_write = 0.1"""
        for name, nodes in (("few", (40, 96)), ("enough", (48, 128))):
            result = self.run_scene("--out", name, text=text % nodes)
            steps = numpy.genfromtxt(self.folder / name / "steps.csv", names=True, delimiter=",")
            above = steps["velocity_error"].max() > 1e-3
            self.assertEqual(above, name == "few")
            self.assertEqual("above solver.tolerance = 0.001" in result.stderr, above)

    def test_automatic_nodes_follow_the_gap(self):
        """Circles are driven together: nodes grow, errors stay small, resuming changes nothing."""
        text = PAIR.replace("n_nodes = 48", 'n_nodes = "auto"').replace("-2.0, 0.4", "-2.0, 0.0")
        text = text.replace("2.0, -0.4", "2.0, 0.0").replace('"shear"', '"extensional"')
        text = text.replace("rate = 1.0", "rate = -1.0")
        self.run_scene("--out", "whole", "--set", "time.t_final=2.0", "--set", "solver.tolerance=1e-9",
                       text=text)
        folder = self.folder / "whole"
        resolution = json.loads((folder / "run.json").read_text())["resolution"]
        self.assertGreater(resolution["most_nodes"][0], resolution["first_nodes"][0])
        steps = numpy.genfromtxt(folder / "steps.csv", names=True, delimiter=",")
        self.assertTrue((steps["velocity_error"] <= 1e-9).all())
        self.assertIn('n_nodes = "auto"', (folder / "scene.toml").read_text())
        command = [PROGRAM, "run", self.scene(text), "--out", "killed", "--set", "time.t_final=2.0",
                   "--set", "solver.tolerance=1e-9"]
        process = subprocess.Popen(command, cwd=self.folder, stdout=subprocess.DEVNULL)
        while not (self.folder / "killed" / "checkpoint").exists():
            time.sleep(0.001)
        process.send_signal(signal.SIGKILL)
        process.wait()
        self.run_scene("--out", "killed", "--set", "time.t_final=2.0", "--set", "solver.tolerance=1e-9",
                       "--resume", text=text)
        self.assertEqual(self.files("whole"), self.files("killed"))

    def test_fields_have_their_times_and_pictures(self):
        self.run_scene("--out", "a", "--set", "time.t_final=0.3")
        folder = self.folder / "a"
        names = sorted(p.name for p in folder.glob("fields*"))
        self.assertEqual(names, ["fields.pvd", *(f"fields_{k:06}.vti" for k in range(4)),
                                 "fields_pressure.svg", "fields_velocity.svg"])
        entries = re.findall(r'timestep="(.*?)" file="(.*?)"', (folder / "fields.pvd").read_text())
        self.assertEqual([name for _, name in entries], names[1:5])
        times = [float(t) for t, _ in entries]
        numpy.testing.assert_allclose(times, numpy.arange(4) / 10, atol=1e-15)

    def test_fields_of_a_scene_that_ships(self):
        box = "output.fields.box=[-10.2, -10.2, 10.2, 10.2]"
        result = stokes("solve", SCENES / "couette.toml", "--out", self.folder / "a", "--set", box,
                        "--set", 'output.fields.quantities=["velocity", "dissipation"]')
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stdout, r"fields +200 x 200 points: velocity, dissipation")
        for quantity in ("velocity", "dissipation"):
            size = (self.folder / "a" / f"fields_{quantity}.svg").stat().st_size
            self.assertTrue(50_000 < size < 500_000, size)
        rheology = numpy.genfromtxt(self.folder / "a" / "rheology.csv", names=True, delimiter=",")
        self.assertAlmostEqual(float(rheology["torque_ratio"]), 1.10814, delta=2e-4)

    def test_the_saved_scene_runs_again_to_the_same_result(self):
        self.run_scene("--out", "a")
        again = stokes("run", self.folder / "a" / "scene.toml", "--out", self.folder / "b")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual(self.files("a"), self.files("b"))

    def test_threads_do_not_change_a_bit(self):
        contact = SCENES / "settling.toml", "--set", "time.t_final=2.0"
        fast_sum = (SCENES / "vortices.toml", "--set", "time.t_final=0.1", "--set", "fill.0.count=40",
                    "--set", 'solver.summation="fmm"')
        for name, arguments in ("pair", (self.scene(),)), ("contact", contact), ("fmm", fast_sum):
            runs = []
            for threads in (1, 2, 3):
                folder = self.folder / f"{name}{threads}"
                result = stokes("run", *arguments, "--out", folder, "--threads", threads)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertEqual(json.loads((folder / "run.json").read_text())["threads"], threads)
                runs.append(self.files(folder))
            with self.subTest(run=name):
                self.assertEqual(runs[0], runs[1])
                self.assertEqual(runs[0], runs[2])
        self.assertRegex(result.stdout, r"summation +fast")

    def test_a_directory_with_a_run_is_kept(self):
        self.run_scene("--set", "time.t_final=0.2")
        before = self.files("out/pair")
        refused = self.run_scene("--set", "time.t_final=0.2", code=3)
        self.assertIn("--overwrite", refused.stderr)
        self.assertEqual(self.files("out/pair"), before)
        self.run_scene("--set", "time.t_final=0.1", "--overwrite")
        self.assertNotEqual(self.files("out/pair"), before)

    def test_a_killed_run_resumes_bit_for_bit(self):
        fixed = PAIR.replace("t_final = 1.0", "t_final = 2.0")
        adapted = fixed.replace("adams_bashforth2", "dormand_prince54")
        self.assertNotEqual(fixed, adapted)
        for name, text in ("fixed", fixed), ("adapted", adapted):
            whole, killed = name + "_whole", name + "_killed"
            self.run_scene("--out", whole, text=text)
            process = subprocess.Popen([PROGRAM, "run", self.scene(text), "--out", killed],
                                       cwd=self.folder, stdout=subprocess.DEVNULL)
            while not (self.folder / killed / "checkpoint").exists():
                time.sleep(0.001)
            time.sleep(0.02)
            process.send_signal(signal.SIGKILL)
            process.wait()
            information = json.loads((self.folder / killed / "run.json").read_text())
            self.assertIsNone(information["exit_status"])
            self.assertTrue(information["plan"])
            self.run_scene("--out", killed, "--resume", text=text)
            self.assertEqual(self.files(whole), self.files(killed))
            columns = [0, 1, 2, 3, 6, 7, 8]  # all columns of steps.csv except wall times
            tables = [numpy.genfromtxt(self.folder / run / "steps.csv", delimiter=",",
                                       skip_header=1, usecols=columns) for run in (whole, killed)]
            numpy.testing.assert_array_equal(*tables)

    def test_a_run_killed_before_its_first_checkpoint_resumes_from_the_start(self):
        self.run_scene("--out", "whole", "--set", "time.t_final=0.2")
        self.run_scene("--out", "killed", "--set", "time.t_final=0.2")
        (self.folder / "killed" / "checkpoint").unlink()
        self.run_scene("--out", "killed", "--set", "time.t_final=0.2", "--resume")
        self.assertEqual(self.files("whole"), self.files("killed"))

    def test_files_of_the_user_stay(self):
        """Files of the user stay, new run or not, if they have names of the run's own files."""
        for names, flags in ((["scene.toml"], []), (["scene.toml"], ["--resume"]),
                             (["walls.csv", "animation.html"], ["--resume"])):
            with self.subTest(names=names, flags=flags):
                folder = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
                for name in names:
                    (folder / name).write_text("mine")
                refused = self.run_scene("--out", folder, *flags, code=3)
                self.assertIn("--overwrite", refused.stderr)
                self.assertEqual(self.files(folder), {name: b"mine" for name in names})

    def test_a_run_of_its_own_scene_is_begun_anew(self):
        """A kill before the first checkpoint of a run leaves such a folder."""
        self.run_scene("--out", "a", "--set", "time.t_final=0.2")
        whole = self.files("a")
        for flag in ("--resume", "--overwrite"):
            (self.folder / "a/checkpoint").unlink()
            result = stokes("run", "a/scene.toml", "--out", "a", flag, cwd=self.folder)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(self.files("a"), whole)

    def test_one_process_at_a_time_writes_a_folder(self):
        process = subprocess.Popen(
            [PROGRAM, "run", self.scene(), "--out", "a", "--set", "time.t_final=1000"],
            cwd=self.folder, stdout=subprocess.DEVNULL)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        while not (self.folder / "a/checkpoint").exists():
            time.sleep(0.001)
        for flag in ("--resume", "--overwrite"):
            refused = self.run_scene("--out", "a", "--set", "time.t_final=1000", flag, code=3)
            self.assertIn("is being written by another run", refused.stderr)
        self.assertIsNone(process.poll())

    def test_checkpoints_of_other_programs(self):
        """A checkpoint of another build is accepted if it has all data that this program reads."""
        def rewritten(text, pattern, replacement):
            body, count = re.subn(pattern, replacement, text[:text.rindex("checksum")])
            self.assertEqual(count, 1)
            checksum = 0xcbf29ce484222325
            for byte in body.encode():
                checksum = (checksum ^ byte) * 0x100000001b3 % 2**64
            return f"{body}checksum {checksum:016x}\n"
        self.run_scene("--out", "a")
        path = self.folder / "a/checkpoint"
        text = path.read_text()
        path.write_text(rewritten(text, r'"program":"\w+"', '"program":"0123456789abcdef"'))
        self.assertIn("another build", self.run_scene("--out", "a", "--resume").stderr)
        path.write_text(rewritten(text, r'"estimate":', '"guess":'))
        refused = self.run_scene("--out", "a", "--resume", code=3)
        self.assertEqual(refused.stderr,
                         "stokes: a/checkpoint: lacks data that this version requires to resume\n")

    def test_the_scene_is_not_written_over(self):
        self.scene(name="scene.toml")
        result = stokes("run", "scene.toml", "--out", ".", cwd=self.folder)
        self.assertEqual(result.returncode, 3)
        self.assertEqual((self.folder / "scene.toml").read_text(), PAIR)

    def test_a_refused_run_keeps_what_it_has(self):
        text = PAIR.replace('kind = "shear"\nrate = 1.0', 'kind = "extensional"\nrate = -1.0')
        text = text.replace("t_final = 1.0", "t_final = 20.0").replace("dt_write = 0.1", "dt_write = 0.05")
        text = text.replace("-2.0, 0.4", "-2.0, 0.0").replace("2.0, -0.4", "2.0, 0.0")
        refused = self.run_scene("--out", "a", text=text, code=2)
        self.assertRegex(refused.stderr, r"refused: t = [0-9.]+: .*body 0")
        table = numpy.genfromtxt(self.folder / "a" / "trajectory.csv", names=True, delimiter=",")
        self.assertTrue(0.05 < table["t"].max() < 20.0)
        information = json.loads((self.folder / "a" / "run.json").read_text())
        self.assertEqual(information["exit_status"], 2)
        self.assertIn("body 0", information["message"])

    def test_a_run_whose_contact_is_not_resolved_says_what_it_met(self):
        """A long last step drives slender ellipses through each other."""
        body = """
            [[bodies]]
            shape = { kind = "ellipse", semi_axes = [2.0, 0.3] }
            position = %s
            orientation = %s
            n_nodes = "auto\""""
        text = body % ("[-1.4, 0.3]", 0.7) + body % ("[1.4, -0.3]", 0.9) + """
            [flow]
            kind = "extensional"
            rate = -30.0
            reverse_at = [0.01, 0.02]
            [solver]
            tolerance = 1e-3
            [contact]
            minimum_separation = 0.05
            [time]
            t_final = 3.0
            dt = 0.3
            dt_min = 0.3
            method = "euler"
            """
        for flag in "--overwrite", "--resume":  # --resume tries the same step again
            refused = self.run_scene("--out", "a", flag, text=text, code=2)
            self.assertRegex(refused.stderr, r"refused: t = 0\.02: contact is not resolved: body 0 "
                             r"and body 1: .*a unit force .*time\.dt_min = 0\.3 do not help")
            self.assertEqual(refused.stderr.count("t = "), 1)
            steps = numpy.genfromtxt(self.folder / "a" / "steps.csv", names=True, delimiter=",")
            numpy.testing.assert_array_equal(steps["t"], [0.01, 0.02])
            table = numpy.genfromtxt(self.folder / "a" / "trajectory.csv", names=True, delimiter=",")
            numpy.testing.assert_array_equal(table["t"], [0.0, 0.0, 0.01, 0.01])

    def test_unwritable_directory(self):
        (self.folder / "file").write_text("")
        result = self.run_scene("--out", "file/out", code=3)
        self.assertIn("file/out", result.stderr)
        long = "a" * 300  # more letters than a name may have
        result = self.run_scene("--out", long, code=3)
        self.assertRegex(result.stderr, rf"^stokes: {long}.*: File name too long\n$")

    def test_solve_prints_and_records_one_frame(self):
        text = PAIR[:PAIR.index("[time]")]
        result = stokes("solve", self.scene(text), "--out", "a", cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        table = numpy.genfromtxt(self.folder / "a" / "trajectory.csv", names=True, delimiter=",")
        self.assertEqual(len(table), 2)
        self.assertIn(f"{table['omega'][1]:.10g}"[:9], result.stdout)

    def test_solve_writes_the_matrices_of_the_free_bodies(self):
        text = PAIR[:PAIR.index("[time]")].replace("rate = 1.0", "rate = 1.0\ngauge_length = 20.0")
        result = stokes("solve", self.scene(text), "--matrices", "--out", "a", cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        matrices = [numpy.loadtxt(self.folder / "a" / name, delimiter=",", skiprows=1,
                                  usecols=range(1, 7)) for name in ("resistance.csv", "mobility.csv")]
        numpy.testing.assert_allclose(matrices[0] @ matrices[1], numpy.eye(6), atol=1e-4)
        self.assertIn("asymmetry", result.stdout)
        result = stokes("solve", self.scene(PAIR), "--matrices", "--out", "b", cwd=self.folder)
        self.assertEqual(result.returncode, 2, result.stdout)
        self.assertIn("flow.gauge_length", result.stderr)

    def test_measure_writes_means_and_profiles(self):
        self.run_scene("--out", "a", "--set", "output.nodes=true")
        result = stokes("measure", "a", "--from", "0.2", "--box=-4,-2,4,2", "--across", "x",
                        "--bins", "8", "--out", "b", cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("means of 9 written times", result.stdout)
        rheology = numpy.genfromtxt(self.folder / "a" / "rheology.csv", names=True, delimiter=",")
        means = dict(line.split(",", 1) for line in
                     (self.folder / "b" / "means.csv").read_text().splitlines())
        stress = rheology["s12"][2:]
        mean = numpy.sum(numpy.diff(rheology["t"][2:]) * (stress[1:] + stress[:-1]) / 2.0) / 0.8
        self.assertAlmostEqual(float(means["s12"].split(",")[0]), mean, 12)
        profile = numpy.genfromtxt(self.folder / "b" / "profile.csv", names=True, delimiter=",")
        self.assertEqual(len(profile), 8)
        area = numpy.sum(profile["area_fraction"]) * 4.0
        self.assertAlmostEqual(area / (numpy.pi * 1.6), 1.0, 2)
        # The stresslets of the profile are sums over nodes.csv, those of rheology.csv the solver's.
        for stress, stresslet in ("normal", "s11"), ("shear", "s12"):
            total = numpy.sum(profile[f"particle_{stress}_stress"]) * 4.0
            self.assertAlmostEqual(total / float(means[stresslet].split(",")[0]), 1.0, 2)
        # The number of bins that --help names.
        result = stokes("measure", "a", "--box=-4,-2,4,2", "--out", "c", cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        default = numpy.genfromtxt(self.folder / "c" / "profile.csv", names=True, delimiter=",")
        self.assertEqual(len(default), 40)
        self.assertIn("[40]", stokes("measure", "--help").stdout)
        for name in ("pair_correlation_g", "neighbours_bodies", "orientations_density",
                     "profile_ux", "profile_particle_shear_stress"):
            xml.etree.ElementTree.parse(self.folder / "b" / f"{name}.svg")
        for arguments, code, words in ((["nowhere"], 3, "nowhere"),
                                       (["a", "--from", "9"], 3, "no written time"),
                                       (["a", "--across", "z"], 1, "--across")):
            result = stokes("measure", *arguments, cwd=self.folder)
            self.assertEqual(result.returncode, code, result.stderr)
            self.assertIn(words, result.stderr)


class ShippedScenes(Program):
    large = {"couette_dense", "couette_random", "crowded_cell", "vortices"}

    def test_every_scene_runs_but_the_large_ones(self):
        self.check_run(large=False)

    @full
    def test_the_large_scenes_run(self):
        self.check_run(large=True)

    def check_run(self, large):
        scenes = sorted(SCENES.parents[1].glob("*/scenes/*.toml"))
        self.assertLessEqual(self.large, {scene.stem for scene in scenes})
        for scene in (scene for scene in scenes if (scene.stem in self.large) == large):
            with self.subTest(scene=scene.name):
                result = stokes("run", scene, "--out", self.folder / scene.stem, "--quiet",
                                "--set", "time.t_final=0.2")
                self.assertEqual(result.returncode, 0, result.stderr)


if __name__ == "__main__":
    os.environ.setdefault("OMP_WAIT_POLICY", "passive")
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
