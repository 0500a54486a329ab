"""Tests runs that go on: with a later end, with other settings, and as the start of other scenes.

Usage: test_continuation.py PROGRAM SCENES [unittest arguments]
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
position = [-1.5, 0.4]
n_nodes = 32
[[bodies]]
shape = { kind = "ellipse", semi_axes = [1.0, 0.6] }
position = [1.5, -0.4]
n_nodes = 32
[solver]
tolerance = 1e-3
[time]
t_final = 0.5
dt = 0.07
method = "heun"
[output]
dt_write = 0.2
"""
ADAPTED = PAIR.replace("dt = 0.07\n", "").replace('"heun"', '"dormand_prince54"')
CONTACT = PAIR.replace("0.07", "0.05").replace('method = "heun"', 'tolerance = 1e-2') + """
[contact]
minimum_separation = 0.9
allow_close = true
"""

# An ellipse between a circle and an ellipse that turn, far from both.
CELL = """
[[walls]]
role = "outer"
shape = { kind = "circle", radius = 6.0 }
n_nodes = 64
motion = { kind = "rotating", omega = 1.0 }
[[walls]]
role = "inner"
shape = { kind = "ellipse", semi_axes = [1.2, 1.0] }
n_nodes = 32
motion = { kind = "rotating", omega = -0.5 }
[[bodies]]
shape = { kind = "ellipse", semi_axes = [0.6, 0.4] }
position = [3.5, 0.0]
n_nodes = 32
[solver]
tolerance = 1e-3
[time]
t_final = 0.4
dt = 0.1
method = "heun"
[output]
dt_write = 0.2
"""

# Two bodies in a cell that is sheared by more than half a period; one of them crosses an edge.
LATTICE = PAIR.replace("[[bodies]]", """[cell]
vectors = [[4.0, 0.0], [0.5, 4.0]]
[[bodies]]""", 1).replace("-1.5, 0.4", "1.7, 1.0").replace("1.5, -0.4", "-0.6, -0.9")


def sets(**values):
    """Returns the options that set keys: time_dt=0.1 sets time.dt."""
    return [word for key, value in values.items()
            for word in ("--set", f"{key.replace('_', '.', 1)}={value}")]


class GoingOn(unittest.TestCase):
    def setUp(self):
        # In memory if possible: a disk takes longer to store a checkpoint than a step takes.
        place = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
        folder = tempfile.TemporaryDirectory(dir=place)
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def command(self, out, text, *arguments):
        (self.folder / "scene.toml").write_text(text)
        return [PROGRAM, "run", "scene.toml", "--out", out, *map(str, arguments)]

    def run_scene(self, out, text, *arguments, code=0):
        result = subprocess.run(self.command(out, text, *arguments), cwd=self.folder, text=True,
                                capture_output=True)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result

    def kill_at_work(self, out, text, *arguments, frames=0):
        """Kills a run after its first checkpoint with more frames than given."""
        with subprocess.Popen(self.command(out, text, *arguments), cwd=self.folder,
                              stdout=subprocess.DEVNULL) as process:
            checkpoint = self.folder / out / "checkpoint"
            while (not checkpoint.exists()  # the list of frames begins with its count
                   or json.loads(checkpoint.read_text().splitlines()[1])["frames"][0] <= frames):
                self.assertIsNone(process.poll())
                time.sleep(0.001)
            process.send_signal(signal.SIGKILL)
        self.assertIsNone(json.loads((self.folder / out / "run.json").read_text())["exit_status"])

    def table(self, out, name="trajectory"):
        return numpy.genfromtxt(self.folder / out / f"{name}.csv", names=True, delimiter=",")

    def solves(self, out):
        return json.loads((self.folder / out / "run.json").read_text())["totals"]["solves"]

    def files(self, out):
        """Returns the files of a run without measured seconds, cost, and lengths that depend on them."""
        files = {path.name: path.read_bytes() for path in (self.folder / out).iterdir()}
        names, *rows = [row.split(b",") for row in files["steps.csv"].splitlines()]
        seconds = names.index(b"seconds")
        files["steps.csv"] = [row[:seconds] + row[seconds + 1:] for row in rows]
        for name in files.keys() & {"checkpoint", "checkpoint_before_end"}:
            files[name] = re.sub(rb'"steps\.csv":\d+|\nchecksum \w+\n$', b"", files[name])
        information = json.loads(files.pop("run.json"))
        return files | {"run.json": [information[key] for key in ("plan", "resolution", "exit_status")]}

    def check_equal(self, out, whole):
        found, expected = self.files(out), self.files(whole)
        self.assertEqual(sorted(found), sorted(expected))
        for name in expected:
            self.assertTrue(found[name] == expected[name], f"{out}: {name} differs")


class Extensions(GoingOn):
    def check_extensions(self, name, text, ends):
        self.run_scene(f"{name}_whole", text, *sets(time_t_final=ends[-1]))
        for k, end in enumerate(ends):
            self.run_scene(name, text, *sets(time_t_final=end), *(["--resume"] if k else []))
        self.check_equal(name, f"{name}_whole")

    def test_a_run_extended_twice_is_one_undisturbed_run(self):
        """The ends are written times, or lie between two; contact begins before the second one."""
        formats = PAIR + 'formats = ["csv", "vtk", "svg", "html"]\n'
        self.check_extensions("fixed", formats, (0.4, 0.7, 0.8))
        self.check_extensions("adapted", ADAPTED, (0.4, 0.5, 0.8))
        self.check_extensions("contact", CONTACT, (0.4, 0.7, 1.0))
        self.assertGreater(self.table("contact", "steps")["contacts"].max(), 0)

    @full
    def test_extensions_by_all_methods(self):
        field = "fields = { box = [-3, -2, 3, 2], resolution = 9 }\n"
        for name, text in ("field", PAIR + field), ("every_step", PAIR.replace("dt_write = 0.2", "")), (
                "reversed", PAIR.replace("rate = 1.0", "rate = 1.0\nreverse_at = [0.3, 0.5, 0.7]")), (
                "adapted_reversed", ADAPTED.replace("rate = 1.0", "rate = 1.0\nreverse_at = [0.3, 0.5]")), (
                "short", PAIR.replace("0.07", "0.6")), (
                "effort", PAIR.replace('"heun"', '"euler"\neffort = { few = 8, many = 12 }')):
            self.check_extensions(name, text, (0.4, 0.5, 1.1))
        for method in ("euler", "adams_bashforth2", "rk4", "bogacki_shampine32", "prince_dormand87"):
            self.check_extensions(method, PAIR.replace("heun", method), (0.4, 0.7, 1.1))
        self.check_extensions("contact_euler", CONTACT.replace("tolerance = 1e-2", 'method = "euler"'),
                              (0.4, 0.7, 1.1))
        self.check_extensions("contact_every_step", CONTACT.replace("dt_write = 0.2", ""), (0.3, 0.5, 0.7))
        settling = (SCENES / "settling.toml").read_text()
        self.check_extensions("settling", settling, (1.0, 1.3, 2.0))

    def test_only_the_steps_that_depended_on_the_end_are_taken_again(self):
        self.run_scene("a", PAIR, *sets(time_t_final=1.0))
        told = self.run_scene("a", PAIR, "--resume", *sets(time_t_final=1.2)).stdout
        self.assertIn("the run goes on at t = 0.6 with time.t_final = 1.2 (so far 1.0)\n", told)
        again = self.solves("a")
        self.run_scene("whole", PAIR, *sets(time_t_final=1.2))
        self.assertLess(again, 0.6 * self.solves("whole"))
        self.run_scene("b", ADAPTED)
        told = self.run_scene("b", ADAPTED, "--resume", *sets(time_t_final=0.6)).stdout
        self.assertIn("the run begins again, since all of its steps depended on its end, with", told)

    def test_killed_extensions_resume(self):
        end = sets(time_t_final=8.0)
        self.run_scene("whole", PAIR, *end)
        self.run_scene("a", PAIR)
        self.kill_at_work("a", PAIR, *end, "--resume", frames=4)
        self.run_scene("a", PAIR, *end, "--resume")
        self.check_equal("a", "whole")
        self.run_scene("b", PAIR, *end, "--overwrite")
        # A kill before the first new checkpoint.
        for name in ("checkpoint", "checkpoint_before_end"):
            self.assertTrue((self.folder / "b" / name).exists())
        (self.folder / "b/checkpoint").write_bytes((self.folder / "b/checkpoint_before_end").read_bytes())
        self.run_scene("b", PAIR, *sets(time_t_final=8.5), "--resume")
        self.run_scene("longer", PAIR, *sets(time_t_final=8.5))
        self.check_equal("b", "longer")


class Changes(GoingOn):
    def test_other_settings_from_now_on(self):
        """The second part is that of a scene that begins where the first part ends."""
        euler = PAIR.replace("heun", "euler").replace("t_final = 0.5", "t_final = 0.4")
        self.run_scene("a", euler)
        scene_before = (self.folder / "a/scene.toml").read_bytes()
        first = (self.folder / "a/trajectory.csv").read_bytes()
        other = sets(time_dt=0.02, solver_tolerance=1e-4, output_dt_write=0.1)
        self.run_scene("rest", euler, *other, "--from", "a")
        told = self.run_scene("a", euler, *other, "--resume", *sets(time_t_final=0.8)).stdout
        self.assertIn("the run goes on at t = 0.4 with output.dt_write = 0.1 (so far 0.2), solver.tolerance = "
                      "1e-04 (so far 0.001), time.dt = 0.02 (so far 0.07), time.t_final = 0.8 (so far 0.4)\n",
                      told)
        self.assertTrue((self.folder / "a/trajectory.csv").read_bytes().startswith(first))
        self.assertEqual((self.folder / "a/scene_until_frame_000002.toml").read_bytes(), scene_before)
        rows, rest = self.table("a"), self.table("rest")
        rows = rows[rows["t"] > 0.4]
        numpy.testing.assert_allclose(rows["t"][::2], [0.5, 0.6, 0.7, 0.8], rtol=1e-12)
        for column in ("x", "y", "theta", "omega"):
            numpy.testing.assert_allclose(rows[column], rest[rest["t"] > 0.0][column], atol=1e-10)

    def test_more_output_from_now_on(self):
        self.run_scene("a", PAIR)
        field = 'output.fields={ box = [-3, -2, 3, 2], resolution = 9, quantities = ["velocity"] }'
        formats = 'output.formats=["csv", "vtk", "svg", "html"]'
        self.run_scene("a", PAIR, "--resume", "--set", field, "--set", formats, *sets(time_t_final=0.8))
        for kind, extension in (("bodies", "vtp"), ("fields", "vti")):
            listed = re.findall(r'timestep="(.*?)" file="(.*?)"',
                                (self.folder / f"a/{kind}.pvd").read_text())
            self.assertEqual([float(t) for t, _ in listed], [3 * 0.2, 0.8])
            for _, name in listed:
                self.assertTrue((self.folder / "a" / name).exists())
            self.assertEqual([name for _, name in listed], [f"{kind}_00000{k}.{extension}" for k in (4, 5)])
        self.assertEqual((self.folder / "a/animation.html").read_text().count('class="frame">['), 2)
        numpy.testing.assert_allclose(self.table("a")["t"][::2], [0.0, 0.2, 0.4, 0.5, 0.6, 0.8], rtol=1e-12)

    def test_killed_continuations_resume(self):
        other = sets(time_dt=0.05, time_t_final=8.0)
        for name in "whole", "a":
            self.run_scene(name, PAIR)
        self.run_scene("whole", PAIR, *other, "--resume")
        self.kill_at_work("a", PAIR, *other, "--resume", frames=4)
        self.run_scene("a", PAIR, *other, "--resume")
        self.check_equal("a", "whole")

    def test_another_separation(self):
        self.run_scene("a", CONTACT, *sets(time_t_final=1.0))
        wider = sets(time_t_final=1.2, contact_minimum_separation=1.2)
        refused = self.run_scene("a", CONTACT, *wider, *sets(contact_allow_close="false"), "--resume", code=2)
        self.assertIn("contact.minimum_separation = 1.2: body 0 and body 1 are ", refused.stderr)
        before = self.table("a", "steps")["min_gap"].min()
        self.run_scene("a", CONTACT, *wider, "--resume")
        steps = self.table("a", "steps")
        self.assertGreater(steps["min_gap"][steps["t"] > 1.1].min(), before)

    def test_what_may_not_differ_is_refused_by_its_key(self):
        self.run_scene("a", PAIR + 'formats = ["csv", "vtk"]\n')
        files = self.files("a")
        later = sets(time_t_final=1.0)
        for changed, messages in (
                (sets(flow_rate=2.0, fluid_viscosity=3.0),
                 ["a: the run cannot go on with ", "flow.rate = 2.0 (so far 1.0): the motion so far depends on",
                  "fluid.viscosity = 3.0 (so far 1.0)", "--from begins another run"]),
                (["--set", "bodies.1.n_nodes=40"], ["bodies[1].n_nodes = 40 (so far 32)"]),
                (["--set", 'output.formats=["csv"]'],
                 ['output.formats = ["csv"] (so far ["csv", "vtk"]): a run keeps its formats']),
                (sets(contact_minimum_separation=0.1),
                 ["contact.minimum_separation = 0.1 (so far none): contact cannot begin or end"]),
                (sets(seed=3), ["seed = 3 (so far 0)"])):
            refused = self.run_scene("a", PAIR, "--set", 'output.formats=["csv", "vtk"]', *later, *changed,
                                     "--resume", code=1)
            for message in messages:
                self.assertIn(message, refused.stderr)
        for end in (0.5, 0.3):
            refused = self.run_scene("a", PAIR, *sets(time_t_final=end, time_dt=0.1), "--set",
                                     'output.formats=["csv", "vtk"]', "--resume", code=1)
            self.assertIn(f"a: time.t_final = {end}: must be later than t = 0.5, which the run has reached",
                          refused.stderr)
        self.assertEqual(self.files("a"), files)
        with open(self.folder / "a/scene.toml", "a") as scene:
            scene.write("# mine\n")
        refused = self.run_scene("a", PAIR, *later, "--resume", code=3)
        self.assertIn("a/scene.toml: is not the scene of the checkpoint", refused.stderr)


class Starts(GoingOn):
    def test_a_scene_begins_at_any_written_state(self):
        """Runge and Kutta's steps need no memory: the path is that of the whole run."""
        text = PAIR.replace("heun", "rk4").replace("1e-3", "1e-9").replace("32", "64")
        self.run_scene("a", text, *sets(time_t_final=0.8))
        self.run_scene("b", text, *sets(time_t_final=0.4), "--from", "a", "--time", 0.4)
        self.run_scene("c", text, *sets(time_t_final=0.4), "--from", "a")
        whole, rest, beyond = (self.table(name) for name in "abc")
        for column in ("x", "y", "theta"):
            numpy.testing.assert_array_equal(rest[column][:2], whole[column][4:6])
            numpy.testing.assert_allclose(rest[column][-2:], whole[column][-2:], atol=1e-8)
            numpy.testing.assert_array_equal(beyond[column][:2], whole[column][-2:])
        self.assertEqual(rest["t"][0], 0.0)
        solve = [PROGRAM, "solve", "scene.toml", "--from", "a", "--time", "0.2", "--out", "solved"]
        self.assertEqual(subprocess.run(solve, cwd=self.folder, stdout=subprocess.DEVNULL).returncode, 0)
        for column in ("x", "y", "theta", "ux", "uy", "omega"):
            numpy.testing.assert_allclose(self.table("solved")[column], whole[column][2:4], atol=1e-8)
        other = text.replace("rate = 1.0", "rate = -1.0")  # settings are those of the scene
        self.run_scene("d", other, *sets(time_t_final=0.8), "--from", "a")
        for k, x in enumerate((-1.5, 1.5)):
            self.assertAlmostEqual(self.table("d")["x"][-2:][k], x, delta=1e-6)
        again = [PROGRAM, "run", "b/scene.toml", "--out", "e"]
        self.assertEqual(subprocess.run(again, cwd=self.folder, stdout=subprocess.DEVNULL).returncode, 0)
        self.assertEqual((self.folder / "e/trajectory.csv").read_bytes(),
                         (self.folder / "b/trajectory.csv").read_bytes())

    def test_a_lattice_begins_where_it_was(self):
        """The new run begins with the reduced lattice of the state, and the paths of its bodies."""
        text = (LATTICE.replace("heun", "rk4").replace("1e-3", "1e-8").replace("0.07", "0.05")
                .replace("32", "64").replace("0.2", "0.1"))
        self.run_scene("a", text, *sets(time_t_final=0.6))
        self.run_scene("b", text, *sets(time_t_final=0.2), "--from", "a", "--time", 0.4)
        whole, rest = self.table("a"), self.table("b")
        for column in ("x", "y", "theta"):
            numpy.testing.assert_array_equal(rest[column][:2], whole[column][8:10])
            numpy.testing.assert_allclose(rest[column][-2:], whole[column][-2:], atol=1e-7)
        scene = (self.folder / "b/scene.toml").read_text()
        vectors = [float(x) for x in re.findall(r"-?\d[.\de-]*", re.search("vectors = (.*)", scene)[1])]
        # a2 = (0.5 + 4 * 0.4, 4) and a2 - a1
        numpy.testing.assert_allclose(vectors, [4.0, 0.0, -1.9, 4.0], atol=1e-12)
        # The lattice of a run that began with a moved lattice is carried on, too.
        self.run_scene("c", text, *sets(time_t_final=0.1), "--from", "b", "--time", 0.1)
        for column in ("x", "y", "theta"):
            numpy.testing.assert_allclose(self.table("c")[column][-2:], whole[column][-2:], atol=1e-7)
        for other, message in (
                (PAIR, "--from a: has a [cell] of the area 16, and the scene one of 0, where 0 means none: "
                 "give the cell.vectors of the run"),
                (text.replace("[0.5, 4.0]", "[0.5, 5.0]"), "--from a: has a [cell] of the area 16, and the "
                 "scene one of 20, where 0 means none: give the cell.vectors of the run")):
            self.assertIn(message, self.run_scene("d", other, "--from", "a", code=1).stderr)

    def test_extensions_in_a_cell(self):
        tracers = "[[tracers]]\npoints = [[0.5, 3.5], [-3.0, -1.0]]\n"
        Extensions.check_extensions(self, "cell", LATTICE + tracers, [0.3, 0.55])

    def test_walls_begin_where_they_were(self):
        self.run_scene("a", CELL)
        self.run_scene("b", CELL, "--from", "a")
        scene = (self.folder / "b/scene.toml").read_text()
        turned = [float(x) for x in re.findall(r"\norientation = (\S+)\n", scene)]
        numpy.testing.assert_allclose(turned[:2], [0.4, -0.2], rtol=1e-12)
        refused = self.run_scene("c", CELL, "--from", "a", "--time", 0.2, code=1)
        self.assertIn("--from a: walls[1] has moved, and its place is known only at the last state, t = 0.4",
                      refused.stderr)
        round_wall = CELL.replace('"ellipse", semi_axes = [1.2, 1.0]', '"circle", radius = 1.0')
        self.run_scene("d", round_wall)
        self.run_scene("e", round_wall, "--from", "d", "--time", 0.2)

    def test_what_cannot_be_a_start(self):
        self.run_scene("a", PAIR)
        self.run_scene("tableless", PAIR + 'formats = ["vtk"]\n')
        for text, arguments, message in (
                (PAIR, ("--from", "a", "--time", 0.3), "--from a: has not written t = 0.3; the nearest written "
                 "time is 0.2"),
                (PAIR.replace("0.6]", "0.5]"), ("--from", "a"), "--from a: has 2 bodies, and the scene 2: number, "
                 "order and shapes must be the same"),
                (CELL, ("--from", "a"), "--from a: has 2 bodies, and the scene 1"),
                (PAIR, ("--time", 0.3), "--time requires --from")):
            self.assertIn(message, self.run_scene("b", text, *arguments, code=1).stderr)
        for folder in ("none", "tableless"):
            self.assertIn(folder + ": must be the folder of a run whose output.formats contain",
                          self.run_scene("b", PAIR, "--from", folder, code=3).stderr)
        self.assertFalse((self.folder / "b").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
