"""Tests stokes compare, plot, precision and run --verify, on Jeffery's orbit and on many scenes.

Usage: test_program.py PROGRAM SCENES [unittest arguments]
"""

import itertools
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parents[1]))
from tiers import full

PROGRAM, SCENES = sys.argv[1], pathlib.Path(sys.argv[2])

JEFFERY = """
[flow]
kind = "shear"
rate = 1.0
[[bodies]]
shape = { kind = "ellipse", semi_axes = [3.0, 1.0] }
n_nodes = "auto"
[time]
t_final = 20.0
[output]
dt_write = 0.5
"""

CELL = """
[flow]
kind = "shear"
rate = 1.0
[cell]
vectors = [[2.0, 0.0], [0.0, 2.0]]
[solver]
tolerance = 1e-6
[[bodies]]
shape = { kind = "ellipse", semi_axes = [0.5, 0.3] }
position = [0.5, 0.8]
n_nodes = "auto"
[[bodies]]
shape = { kind = "circle", radius = 0.3 }
position = [0.1, -0.2]
n_nodes = "auto"
[time]
t_final = 1.0
dt = 0.25
method = "heun"
"""

# Scenes and overrides for the search of settings, with the accuracy that is asked for. Containers
# and crowds are smaller than those of the shipped scenes, so that all settings can be tried.
SEARCHED = {
    "pair": ("two_disks.toml", 1e-3, ["time.t_final=12.0"]),
    "oscillation": ("two_disks.toml", 1e-3, [
        "time.t_final=12.0", "flow.reverse_at=[]",
        "flow.amplitude={kind = \"oscillation\", amplitude = 2.0, period = 12.0}"]),
    "rotors": ("rotors.toml", 1e-3, ["time.t_final=5.0", "output.dt_write=0.5"]),
    "nine": ("vortices.toml", 1e-3, ["fill.0.count=9", "fill.0.region.box=[0.0, 0.0, 7.0, 7.0]",
                                     "time.t_final=3.0", "output.dt_write=0.5"]),
    "couette": ("couette.toml", 1e-2, ["time.t_final=1.0", "output.dt_write=0.25"]),
    "settling": ("settling.toml", 1e-2, ["time.t_final=1.0", "output.dt_write=0.25"]),
    "extension": ("extension.toml", 1e-2, ["time.t_final=2.0", "output.dt_write=0.5"]),
}


def stokes(*arguments, code=0):
    result = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    if result.returncode != code:
        raise AssertionError(f"exit code {result.returncode}: {result.stdout}{result.stderr}")
    return result


def run(scene, out, *settings):
    """Runs a scene with settings, and returns its products with the operator."""
    overrides = itertools.chain.from_iterable(("--set", setting) for setting in settings)
    stokes("run", scene, "--out", out, "--quiet", "--overwrite", "--threads", 1, *overrides)
    return numpy.genfromtxt(out / "steps.csv", names=True, delimiter=",")["matvecs"].sum()


def configuration(out):
    """Returns x, y and theta of all bodies, in rows for all written times."""
    rows = numpy.genfromtxt(out / "trajectory.csv", names=True, delimiter=",")
    return numpy.array([rows[name] for name in ("x", "y", "theta")])


def jeffery_angle(t, ratio=3.0):
    """The angle of an ellipse that lies along the flow at t = 0, with whole turns."""
    phase = t * ratio / (ratio**2 + 1.0)
    return -numpy.arctan2(numpy.sin(phase) / ratio, numpy.cos(phase)) - 2.0 * numpy.pi * numpy.round(
        phase / (2.0 * numpy.pi))


def verified_error(output):
    return float(re.search(r"second run: (\S+) at the end", output)[1])


class Program(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.jeffery = self.folder / "jeffery.toml"
        self.jeffery.write_text(JEFFERY)

    def test_error_of_jeffery_s_orbit(self):
        for settings in (["time.tolerance=1e-2"], ["time.tolerance=1e-5"],
                         ["time.method=rk4", "time.dt=0.5"], ["time.method=euler", "time.dt=0.1"]):
            overrides = itertools.chain.from_iterable(("--set", setting) for setting in settings)
            out = self.folder / "out"
            output = stokes("run", self.jeffery, "--out", out, "--overwrite", *overrides,
                            "--verify", "--bound", "1e-3").stdout
            rows = numpy.genfromtxt(out / "trajectory.csv", names=True, delimiter=",")
            errors = abs(rows["theta"] - jeffery_angle(rows["t"]))
            ratio = verified_error(output) / errors[-1]
            self.assertTrue(0.2 < ratio < 4.0, f"{settings}: {ratio}")
            self.assertIn("does not grow exponentially", output)
            late = rows["t"][errors > 1e-3]
            found = re.search(r"above 0.001 first at t = (\S+)", output)
            self.assertEqual(found is None, late.size == 0 or settings[-1] == "time.dt=0.5", output)

    def test_compare_and_plot(self):
        first, second = self.folder / "first", self.folder / "second"
        run(self.jeffery, first)
        same = stokes("compare", first, first, "--out", self.folder / "same").stdout
        self.assertIn("41 common times of 41 and 41", same)
        for line in same.splitlines()[2:]:
            self.assertEqual(line.split()[1], "0", line)
        xml.parse(self.folder / "same" / "comparison.svg")
        # A planted difference: x at t = 10 by 0.003, which is 0.001 radii.
        shutil.copytree(first, second)
        lines = (second / "trajectory.csv").read_text().splitlines()
        cells = lines[1 + 20].split(",")
        self.assertEqual(float(cells[0]), 10.0)
        cells[2] = str(float(cells[2]) + 0.003)
        lines[1 + 20] = ",".join(cells)
        (second / "trajectory.csv").write_text("\n".join(lines) + "\n")
        found = stokes("compare", second, first).stdout
        self.assertRegex(found, r"positions +0\.001 +10 +0 +3\n")
        for line in found.splitlines()[3:]:
            self.assertEqual(line.split()[1], "0", line)
        # Fewer written times: only common ones are compared.
        run(self.jeffery, second, "output.dt_write=2.5")
        self.assertIn("9 common times of 9 and 41", stokes("compare", second, first).stdout)

        pictures = stokes("plot", first, "--bodies", 0).stdout.splitlines()
        self.assertIn(str(first / "paths.svg"), pictures)
        for name in pictures[:-1]:
            xml.parse(name)
        self.assertIn("there is no body 1", stokes("plot", first, "--bodies", "0,1", code=1).stderr)
        self.assertIn("must be the folder of a run", stokes("plot", self.folder, code=3).stderr)

    def test_a_periodic_cell(self):
        (self.folder / "cell.toml").write_text(CELL)
        out = self.folder / "cell"
        run(self.folder / "cell.toml", out)
        rows = numpy.genfromtxt(out / "trajectory.csv", names=True, delimiter=",")
        # Wrapped places are images, of which no other one is nearer to the origin.
        t, shift_y = rows["t"], rows["y"] - rows["wrapped_y"]
        k = shift_y / 2
        j = (rows["x"] - rows["wrapped_x"] - k * 2 * t) / 2
        numpy.testing.assert_allclose([j, k], numpy.round([j, k]), atol=1e-12)
        self.assertTrue(numpy.any(j != 0) or numpy.any(k != 0))
        wrapped = rows["wrapped_x"] + 1j * rows["wrapped_y"]
        for a, b in itertools.product(range(-3, 4), repeat=2):
            other = wrapped + 2 * a + 2 * b * (t + 1j)
            self.assertTrue(numpy.all(abs(wrapped) <= abs(other) + 1e-12))
        rheology = numpy.genfromtxt(out / "rheology.csv", names=True, delimiter=",")
        numpy.testing.assert_allclose(rheology["normal_stress_difference"],
                                      rheology["stress_11"] - rheology["stress_22"])
        numpy.testing.assert_allclose(rheology["viscosity"], rheology["stress_12"])  # no torques
        numpy.testing.assert_allclose(rheology["viscosity"], 1 + rheology["dissipation"] / 4)
        numpy.testing.assert_allclose(rheology["dissipation_by_traction"], rheology["dissipation"],
                                      rtol=1e-5)
        self.assertIn("viscosity", stokes("compare", out, out).stdout)
        self.assertIn(f"{out / 'particle_pressure.svg'}\n", stokes("plot", out).stdout)
        measured = stokes("measure", out, "--longest", 3).stdout
        self.assertIn("on the mean a periodic cell is the same everywhere", measured)
        means = (out / "means.csv").read_text()
        self.assertRegex(means, "\nnormal_stress_difference,")
        self.assertRegex(means, "\nnematic_order,")
        for name in "pair_correlation", "neighbours", "orientations":
            self.assertTrue((out / f"{name}.csv").exists())
        self.assertFalse((out / "profile.csv").exists())
        refused = stokes("measure", out, "--box=0,0,1,1", code=3).stderr
        self.assertIn("all bodies and images count: remove --box", refused)
        solved = stokes("solve", self.folder / "cell.toml", "--out", self.folder / "once").stdout
        printed = dict(re.findall(r"([a-z12]+(?: [a-z]+)*) ([-+.e0-9]+)(?:,| from|\n)",
                                  solved[solved.index("mean stress"):]))
        columns = {"11": "stress_11", "12": "stress_12", "21": "stress_21", "22": "stress_22",
                   "viscosity": "viscosity", "particle pressure": "particle_pressure",
                   "first normal stress difference": "normal_stress_difference"}
        for name, column in columns.items():
            self.assertAlmostEqual(float(printed[name]), rheology[column][0], 8)
        self.assertIn("from tractions\n", solved)

    def test_refusals(self):
        out = self.folder / "out"
        refused = stokes("precision", self.jeffery, "--budget", "1e-3", "--out", out, code=2)
        self.assertIn("no reference within half of the budget", refused.stderr)
        again = stokes("precision", self.jeffery, "--out", out, code=3)
        self.assertIn("trials: has the runs of another search", again.stderr)
        unknown = stokes("precision", self.jeffery, "--quantity", "gaps", "--out", self.folder / "2",
                         code=1)
        self.assertIn("must be one that the scene defines: positions, angles", unknown.stderr)
        effort = stokes("run", self.jeffery, "--verify", "--out", out, "--set", "time.method=euler",
                        "--set", "time.dt=0.1", "--set", "time.effort={few=1, many=2}", code=1)
        self.assertIn("time.effort", effort.stderr)
        self.assertFalse((out / "run.json").exists())

    def test_the_plan_names_the_tolerance_of_steps_that_follows(self):
        for solver, plan in (("1e-2", "tolerance of 0.0001 to t = 20; solver.tolerance = 0.01 admits no"),
                             ("1e-5", "tolerance of 1e-06 to t = 20; solver.tolerance = 1e-05 is larger"),
                             ("1e-6", "tolerance of 1e-06 to t = 20\n")):
            self.assertIn(plan, stokes("run", self.jeffery, "--dry-run", "--set",
                                       f"solver.tolerance={solver}").stdout)

    @full
    def test_precision_of_jeffery_s_orbit(self):
        for accuracy in 1e-2, 1e-3, 1e-5:
            out = self.folder / str(accuracy)
            stokes("precision", self.jeffery, "--accuracy", accuracy, "--out", out)
            run(out / "recommended.toml", out / "run")
            rows = numpy.genfromtxt(out / "run" / "trajectory.csv", names=True, delimiter=",")
            error = abs(rows["theta"] - jeffery_angle(rows["t"])).max()
            self.assertTrue(accuracy / 3.0 < error < 1.05 * accuracy, f"{accuracy}: {error}")

    @full
    def test_chaos_has_the_rate_of_a_small_shift(self):
        """Five rotors: the error of a run grows like the effect of a shift of one rotor."""
        rotors = [(1.2, 0.1), (0.0, 1.1), (-1.3, 0.2), (0.1, -1.2), (0.3, 0.1)]

        def scene(shift):
            bodies = "".join(
                f'[[bodies]]\nshape = {{ kind = "circle", radius = 0.3 }}\nn_nodes = "auto"\n'
                f"position = [{x + (shift if k == 0 else 0.0)}, {y}]\n"
                f"torque = {-3.0 if k == 4 else 6.0}\n" for k, (x, y) in enumerate(rotors))
            path = self.folder / f"rotors_{shift}.toml"
            path.write_text(bodies + "[solver]\ntolerance = 1e-8\n[time]\nt_final = 60.0\n"
                            "tolerance = 1e-8\n[output]\ndt_write = 0.5\n")
            return path

        output = stokes("run", scene(0.0), "--out", self.folder / "run", "--verify").stdout
        rate = float(re.search(r"grows like exp\((\S+) t\)", output)[1])
        run(scene(1e-6), self.folder / "shifted")
        shift = configuration(self.folder / "shifted") - configuration(self.folder / "run")
        distance = numpy.maximum.accumulate(
            abs(shift).max(axis=0).reshape(-1, len(rotors)).max(axis=1))
        t = 0.5 * numpy.arange(len(distance))
        expected = numpy.polyfit(t[1:], numpy.log(distance[1:]), 1)[0]
        print(f"rate {rate:.3f}, of a shift {expected:.3f}", flush=True)
        self.assertTrue(0.5 < rate / expected < 2.0)

    def search(self, name):
        """Searches for the settings of a scene, and tries all settings of a grid."""
        scene, accuracy, settings = SEARCHED[name]
        scene = SCENES / scene
        overrides = list(itertools.chain.from_iterable(("--set", s) for s in settings))
        out = self.folder / name
        stokes("precision", scene, "--accuracy", accuracy, "--budget", 2000, "--out", out, *overrides)
        recommended = out / "recommended.toml"
        contact = "[contact]" in recommended.read_text()
        best = run(recommended, out / "best")
        finest = ["time.method=heun" if contact else "time.method=prince_dormand87",
                  f"time.tolerance={1e-4 * accuracy}", f"solver.tolerance={1e-4 * accuracy}"]
        run(recommended, out / "finest", *finest)
        reference = configuration(out / "finest")
        radius = max(map(float, re.findall(r"(?:radius = |semi_axes = \[)([0-9.]+)",
                                           recommended.read_text().split("[[bodies]]", 1)[1])))

        def error(folder):
            difference = configuration(folder) - reference
            return max(numpy.hypot(*difference[:2]).max() / radius, abs(difference[2]).max())

        steps = [("heun", "tolerance", accuracy * 4.0**k) for k in range(-2, 4)] if contact else [
            (method, "tolerance", accuracy * 4.0**k) for k in range(-2, 4)
            for method in ("dormand_prince54", "bogacki_shampine32", "prince_dormand87")]
        dt_write = float(re.search(r"dt_write = (\S+)", recommended.read_text())[1])
        fixed = ("euler", "heun") if contact else ("euler", "heun", "rk4", "adams_bashforth2")
        steps += [(m, "dt", dt_write / n) for m in fixed for n in (1, 2, 4, 8, 16, 32)]
        least = best
        for (method, key, step), solver in itertools.product(steps, (1e-1, 1.0, 10.0)):
            if key == "tolerance" and not accuracy * solver <= 100.0 * step <= 10.0:
                continue
            text = recommended.read_text()
            table = f'[time]\nt_final = {re.search("t_final = (.*)", text)[1]}\nmethod = "{method}"\n'
            table += f"{key} = {step}\n" + (f"dt = {dt_write}\n" if contact and key != "dt" else "")
            text = re.sub(r"\[time\]\n(.+\n)*", table, text)
            other = out / "other.toml"
            other.write_text(text)
            try:
                products = run(other, out / "other", f"solver.tolerance={min(0.1, accuracy * solver)}")
            except AssertionError:
                continue  # refused: steps so long lead to an overlap
            if error(out / "other") <= accuracy:
                least = min(least, products)
        print(f"{name}: error {error(out / 'best'):.2e} for {accuracy}, {best} products, at least "
              f"{least}", flush=True)
        self.assertLess(error(out / "best"), 3.0 * accuracy)
        self.assertGreater(error(out / "best"), accuracy / 3.0)
        self.assertLess(best, 2.0 * least)

    @full
    def test_search_of_all_scenes(self):
        # The Couette cell of 80 bodies takes an hour; the variable includes it.
        for name in SEARCHED:
            if name != "couette" or os.environ.get("STOKESBOOK_LONG"):
                with self.subTest(name):
                    self.search(name)

    @full
    def test_verified_errors(self):
        """Three ellipses in shear, with random shapes, places, methods and tolerances."""
        count = 60
        chance = random.Random(7)
        near = 0
        for _ in range(count):
            bodies = "".join(
                f'[[bodies]]\nshape = {{ kind = "ellipse", semi_axes = [{chance.uniform(0.7, 1.3)}, 0.6] }}\n'
                f'position = [{3.5 * k}, {chance.uniform(-1.0, 1.0)}]\n'
                f'orientation = {chance.uniform(0.0, 3.0)}\nn_nodes = "auto"\n' for k in range(-1, 2))
            scene = self.folder / "scene.toml"
            scene.write_text('[flow]\nkind = "shear"\nrate = 1.0\n' + bodies +
                             "[time]\nt_final = 6.0\n[output]\ndt_write = 0.5\n")
            tolerance = 10.0 ** chance.uniform(-6.0, -2.0)
            settings = chance.choice([
                ["time.method=dormand_prince54", f"time.tolerance={tolerance}"],
                ["time.method=bogacki_shampine32", f"time.tolerance={tolerance}"],
                ["time.method=rk4", f"time.dt={chance.choice([0.5, 0.25, 0.1])}"],
                ["time.method=adams_bashforth2", f"time.dt={chance.choice([0.1, 0.05])}"],
                ["time.method=euler", f"time.dt={chance.choice([0.1, 0.05])}"]])
            settings += [f"solver.tolerance={tolerance * 10.0 ** chance.uniform(-3.0, 1.0)}"]
            out = self.folder / "out"
            overrides = itertools.chain.from_iterable(("--set", setting) for setting in settings)
            output = stokes("run", scene, "--out", out, "--overwrite", "--threads", 1, "--verify",
                            *overrides).stdout
            run(scene, self.folder / "finest", "time.method=prince_dormand87",
                "time.tolerance=1e-10", "solver.tolerance=1e-10")
            difference = configuration(out)[:, -3:] - configuration(self.folder / "finest")[:, -3:]
            radius = max(map(float, re.findall(r"semi_axes = \[([0-9.]+)", scene.read_text())))
            error = max(numpy.hypot(*difference[:2]).max() / radius, abs(difference[2]).max())
            ratio = verified_error(output) / error
            print(f"{settings}: {ratio:.2f} of the error {error:.1e}", flush=True)
            near += 0.1 <= ratio <= 10.0
        self.assertGreaterEqual(near, 0.95 * count)


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
