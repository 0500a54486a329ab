"""Tests that the program has no data races: runs parallel loops under the thread sanitizer.

Clang's OpenMP reports its barriers to the sanitizer (libarcher); GCC's does not, so this build uses
Clang. The sanitizer detects only accesses that a run has made in code of this project. It checks
neither libraries of the system nor loops that no scene here enters.
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM, CANARY, SCENES = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])


def run(*command):
    environment = os.environ | {"OMP_NUM_THREADS": "4", "OMP_WAIT_POLICY": "passive",
                                "TSAN_OPTIONS": "ignore_noninstrumented_modules=1 exitcode=66"}
    return subprocess.run(list(map(str, command)), capture_output=True, text=True, env=environment)


class Races(unittest.TestCase):
    def check(self, scene, *settings):
        with tempfile.TemporaryDirectory() as folder:
            settings = [part for setting in settings for part in ("--set", setting)]
            result = run(PROGRAM, "run", SCENES / scene, "--out", f"{folder}/out", "--quiet", *settings)
        self.assertEqual(result.returncode, 0, result.stderr[:3000])
        self.assertNotIn("ThreadSanitizer", result.stderr)

    def test_the_sanitizer_sees_a_race_and_barriers(self):
        self.assertIn("data race", run(CANARY, "race").stderr)
        ordered = run(CANARY)
        self.assertEqual((ordered.returncode, ordered.stderr), (0, ""))

    def test_direct_sums_with_contact_in_a_container(self):
        self.check("settling.toml", "time.t_final=3.0")

    def test_fast_sums_and_fields(self):
        self.check("vortices.toml", "time.t_final=0.05", "fill.0.count=40", "fill.0.n_nodes=32",
                   "solver.summation=fmm", "solver.tolerance=1e-3", 'output.formats=["svg", "vtk"]',
                   "output.fields={ box=[0, 0, 10, 10], resolution=20, quantities=['velocity', 'shear_stress'] }")

    def test_preconditioners(self):
        for preconditioner in ("clusters", "hierarchical", "direct", "block_diagonal"):
            self.check("two_disks.toml", "time.t_final=0.2", f"solver.preconditioner={preconditioner}")

    def test_near_sums_by_interpolation(self):
        self.check("three_shapes.toml", "time.t_final=0.05", "solver.near_singular=interpolation")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
