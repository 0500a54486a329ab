"""Tests that ten thousand steps take no more memory than one thousand.

Usage: test_long_run.py PROGRAM [unittest arguments]
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv[1]

SETTINGS = """
[solver]
tolerance = 0.05
[time]
t_final = 1.0
dt = 1e-3
method = "euler"
[output]
dt_write = 0.1
"""

FREE = SETTINGS + """
[flow]
kind = "shear"
rate = 1.0
[[bodies]]
shape = { kind = "ellipse", semi_axes = [1.0, 0.5] }
n_nodes = 32
[[bodies]]
shape = { kind = "circle", radius = 0.5 }
position = [-3.0, 0.0]
n_nodes = 32
"""

# A disk rolls along the wall on which it is pressed.
CONTACT = SETTINGS + """
[[walls]]
role = "outer"
shape = { kind = "circle", radius = 2.0 }
n_nodes = 48
[[bodies]]
shape = { kind = "circle", radius = 0.5 }
position = [0.0, -1.4]
force = [1.0, -10.0]
n_nodes = 24
[contact]
minimum_separation = 0.1
"""


class LongRuns(unittest.TestCase):
    def run_scene(self, text, steps):
        """Returns the run.json of a run with the given number of steps."""
        with tempfile.TemporaryDirectory() as name:
            scene, out = pathlib.Path(name) / "scene.toml", pathlib.Path(name) / "out"
            scene.write_text(text)
            subprocess.run([PROGRAM, "run", scene, "--out", out, "--quiet",
                            "--set", f"time.t_final={steps * 1e-3}"], check=True)
            information = json.loads((out / "run.json").read_text())
        self.assertEqual(information["totals"]["steps"], steps)
        return information

    def check(self, text):
        short, long = self.run_scene(text, 1000), self.run_scene(text, 10_000)
        # A leak of a hundred bytes a step would add a megabyte.
        self.assertLess(long["peak_memory"], short["peak_memory"] + 1_000_000)
        return long["totals"]

    def test_free_bodies(self):
        self.check(FREE)

    def test_contact(self):
        self.assertGreater(self.check(CONTACT)["contact_solves"], 9000)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
