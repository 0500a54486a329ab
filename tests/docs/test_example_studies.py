"""Runs all commands of the page docs/example_studies.md as they are printed, and checks the answers.

Each answer is compared with a closed form, an identity or a bound.

Usage: test_example_studies.py PROGRAM ROOT [unittest arguments]
"""

import csv
import math
import pathlib
import sys
import tempfile
import unittest

PROGRAM, ROOT = map(pathlib.Path, sys.argv[1:3])
sys.path.insert(0, str(ROOT / "docs"))
import example_studies

PAGE = (ROOT / "docs/example_studies.md").read_text()
STUDIES = example_studies.studies(ROOT)


def rows_of(path):
    """Returns the rows of a table, with numbers where cells are numbers."""
    def cell(text):
        try:
            return float(text)
        except ValueError:
            return [float(x) for x in text.strip("[]").split(",")] if text[0] == "[" else text
    with open(path, newline="") as file:
        return [{name: cell(text) for name, text in row.items()} for row in csv.DictReader(file)]


def slow_part(omega, fastest):
    """Returns the mean angular velocity of a body whose largest torque turns it at `fastest`."""
    return omega if omega <= fastest else omega - math.sqrt(omega**2 - fastest**2)


def jeffery_angle(strain, ratio=3.0):
    """Returns the angle of an ellipse that lay along the flow; the strain is below half a turn."""
    phase = strain * ratio / (ratio**2 + 1.0)
    return -math.atan2(math.sin(phase) / ratio, math.cos(phase))


class Studies(unittest.TestCase):
    def study(self, name):
        """Runs all commands of a study, and returns the folder of its results."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = pathlib.Path(folder.name)
        for commands in STUDIES[name]:
            example_studies.run(commands, ROOT, PROGRAM, path)
        self.assertTrue((path / f"out/{name}_means.svg").exists())
        return path / "out"

    def test_every_study_is_checked(self):
        tested = {name.removeprefix("test_study_") for name in dir(self) if name.startswith("test_study_")}
        self.assertEqual(tested, set(STUDIES))
        self.assertEqual(len(STUDIES), 6)

    def test_study_viscosity(self):
        out = self.study("viscosity")
        rows = rows_of(out / "viscosity/results.csv")
        inner, outer, radius, clearance = 2.0, 4.0, 0.2, 0.02
        # The power is the torque on the inner cylinder times the angular velocity of the outer one.
        empty = 4.0 * math.pi * inner**2 * outer**2 / (outer**2 - inner**2)
        for row in rows:
            self.assertAlmostEqual(row["dissipation"] / row["torque_ratio"] / empty, 1.0, delta=1e-3)
        r1, r2 = inner + radius + clearance, outer - radius - clearance
        slope = 2.0 * (inner * outer / (r1 * r2))**2
        few = rows[0]
        excess = few["torque_ratio"] - 1.0 - slope * few["area_fraction"]
        self.assertLess(abs(excess), few["torque_ratio_interval"] + 8.0 * few["area_fraction"]**2)
        for row in rows[1:]:
            least = row["torque_ratio"] - row["torque_ratio_interval"]
            self.assertGreater(least, 1.0 + 2.0 * row["area_fraction"])
        means = {row["quantity"]: row for row in rows_of(out / "turning/means.csv")}
        turning = means["torque_ratio"]
        self.assertLess(abs(turning["mean"] - few["torque_ratio"]),
                        turning["interval"] + few["torque_ratio_interval"])

    def test_study_bulk(self):
        out = self.study("bulk")
        disks, ellipses, wide, narrow = (rows_of(out / name / "results.csv") for name in (
            "random_disks", "random_ellipses", "viscosity", "narrow_gap"))
        for rows in disks, ellipses:
            self.assertEqual([row["runs"] for row in rows], [5.0] * 6)
            few = rows[0]
            excess = few["viscosity"] - 1.0 - 2.0 * few["area_fraction"]
            self.assertLess(abs(excess), few["viscosity_interval"] + 4.0 * few["area_fraction"]**2)
            half = rows[4]
            self.assertGreater(half["viscosity"], 2.0 * (1.0 + 2.0 * half["area_fraction"]))
        for one, other in zip(disks[:5], ellipses):
            self.assertLess(abs(one["viscosity"] - other["viscosity"]),
                            one["viscosity_interval"] + other["viscosity_interval"])
        means = [[row[column] for row in rows if row["area_fraction"] in (0.1, 0.2, 0.3)]
                 for rows, column in ((disks, "viscosity"), (wide, "torque_ratio"), (narrow, "torque_ratio"))]
        for without, in_wide, in_narrow in zip(*means):
            self.assertLess(without, min(in_wide, in_narrow))
        self.assertGreater(narrow[0]["torque_ratio"] - narrow[0]["torque_ratio_interval"],
                           disks[0]["viscosity"] + disks[0]["viscosity_interval"])
        # The suspension flows with about the viscosity of random placements, without other stresses.
        found = {row["quantity"]: row for row in rows_of(out / "sheared_cell/means.csv")}
        at_random = disks[2]
        self.assertEqual(at_random["area_fraction"], 0.3)
        self.assertLess(abs(found["viscosity"]["mean"] - at_random["viscosity"]),
                        found["viscosity"]["interval"] + at_random["viscosity_interval"])
        for name in "normal_stress_difference", "particle_pressure":
            self.assertLess(abs(found[name]["mean"]), found[name]["interval"] + 0.1)

    def test_study_settling(self):
        out = self.study("settling")
        s = 0.25  # radius over half the width of the channel
        faxen = 0.1 / (4.0 * math.pi) * (math.log(1.0 / s) - 0.9157 + 1.7244 * s**2 - 1.7302 * s**4
                                         + 2.4056 * s**6 - 4.5913 * s**8)
        lone = rows_of(out / "lone/trajectory.csv")[0]
        self.assertAlmostEqual(-lone["uy"] / faxen, 1.0, delta=1e-3)
        rows = rows_of(out / "settling/results.csv")
        self.assertEqual([row["runs"] for row in rows], [10.0] * 6)
        speeds = [row["dissipation"] for row in rows]
        self.assertEqual(speeds, sorted(speeds, reverse=True))
        self.assertLess(speeds[0], faxen)
        self.assertGreater(speeds[0] + 1.2 * rows[0]["dissipation_interval"], faxen)
        self.assertLess(speeds[3] + rows[3]["dissipation_interval"], 0.6 * faxen)
        # The dissipation is the mean speed.
        for run in sorted((out / "settling/runs").iterdir()):
            bodies = rows_of(run / "trajectory.csv")
            mean = -sum(body["uy"] for body in bodies) / len(bodies)
            self.assertAlmostEqual(rows_of(run / "rheology.csv")[0]["dissipation"] / mean, 1.0, delta=1e-9)

    def test_study_squirmer(self):
        out = self.study("squirmer")
        step, c = 0.01, 0.0  # the midpoint rule; the integrand is 3/2 at k = 0
        for j in range(3000):
            k = step * (j + 0.5)
            c += step * k * (k - math.exp(-k) * math.sinh(k)) / (math.sinh(k) * math.cosh(k) - k)
        self.assertIn(f"{c:.4f}", PAGE)
        for row in rows_of(out / "squirmer/results.csv"):
            h = row["channel"][1]
            self.assertLess(abs(row["ux"] - 1.0 + c / h**2), row["ux_interval"] + 1.5 / h**4)
        # c = h^2 (1 - U) + O(h^-2) for both widths.
        first, second = (h**2 * (1.0 - rows_of(out / f"middle_{h}/trajectory.csv")[0]["ux"])
                         for h in (3.0, 6.0))
        self.assertAlmostEqual((4.0 * second - first) / 3.0, c, delta=0.01)
        self.assertGreater(c - second, 0.02)

    def test_study_rod(self):
        out = self.study("rod")
        rows = rows_of(out / "rod/orientations.csv")
        self.assertEqual(len(rows), 20)

        def share(theta):  # of all times at which the angle is between 0 and theta
            return math.atan2(3.0 * math.sin(theta), math.cos(theta)) / math.pi
        for row in rows:
            half = 0.5 * math.pi / len(rows)
            density = (share(row["theta"] + half) - share(row["theta"] - half)) / (2.0 * half)
            self.assertLess(abs(row["density"] - density), row["density_interval"])
            self.assertAlmostEqual(row["density"] / density, 1.0, delta=0.1)
        means = {row["quantity"]: row["mean"] for row in rows_of(out / "rod/means.csv")}
        self.assertAlmostEqual(means["order_parameter"], 0.5, delta=1e-3)
        turning = rows_of(out / "oscillation/trajectory.csv")
        for row in turning:
            strain = 10.0 / (2.0 * math.pi) * math.sin(2.0 * math.pi * row["t"] / 10.0)
            self.assertAlmostEqual(row["theta"], jeffery_angle(strain), delta=1e-3)
        self.assertEqual(turning[-1]["t"], 20.0)

    def test_study_rotor(self):
        out = self.study("rotor")
        rows = rows_of(out / "rotor/results.csv")
        for row in rows:
            error = abs(row["omega"] - slow_part(2.0 * math.pi * row["frequency"], 1.0))
            self.assertLess(error, min(row["omega_interval"] + 1e-4, 0.02))
        follows = [row["omega_interval"] < 1e-3 for row in rows]
        self.assertEqual(follows, [2.0 * math.pi * row["frequency"] < 1.0 for row in rows])
        angles = {row["t"]: row["theta"] for row in rows_of(out / "ellipse/trajectory.csv")}
        mean = (angles[200.0] - angles[20.0]) / 180.0
        omega, fastest = 0.2 * math.pi, 4.0 / (2.0 * (1.5**2 + 1.0))
        self.assertGreater(omega, fastest)
        self.assertAlmostEqual(mean, slow_part(omega, fastest), delta=0.02)


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
