"""Tests that programs let their waiting threads sleep, unless the user has chosen otherwise.

Usage: test_waiting_threads.py PROGRAM...
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAMS = sys.argv[1:]
CHOICES = "OMP_WAIT_POLICY", "GOMP_SPINCOUNT", "KMP_BLOCKTIME"


class WaitingThreads(unittest.TestCase):
    def policies(self, program, **choice):
        """Returns the policy that OpenMP reports each time the program is loaded."""
        environment = {k: v for k, v in os.environ.items() if k not in CHOICES}
        with tempfile.TemporaryDirectory() as folder:
            argument = folder if "chapter" in program.rpartition("/")[2] else "--help"
            result = subprocess.run([program, argument], text=True, check=True,
                                    env={**environment, "OMP_DISPLAY_ENV": "true", **choice},
                                    stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        return re.findall(r"OMP_WAIT_POLICY *= *'(\w+)'", result.stderr)

    def test_threads_sleep(self):
        for program in PROGRAMS:
            with self.subTest(program):
                self.assertEqual(self.policies(program)[1:], ["PASSIVE"])

    def test_the_choice_of_the_user_is_kept(self):
        for program in PROGRAMS:
            with self.subTest(program):
                self.assertEqual(self.policies(program, OMP_WAIT_POLICY="active"), ["ACTIVE"])
                for name in CHOICES[1:]:
                    self.assertEqual(len(self.policies(program, **{name: "1000"})), 1)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
