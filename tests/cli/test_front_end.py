"""Tests the script ./stokes on a system other than Debian, with programs that only print their
arguments.

Usage: test_front_end.py SCRIPT [unittest arguments]
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(sys.argv[1])
TOOLS = ("awk cat cut date dirname flock getconf grep head id mkdir mktemp readlink rm sed sh").split()


class FrontEnd(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve() / "book"
        self.tools = self.root.parent / "tools"
        for path in self.root, self.tools:
            path.mkdir()
        shutil.copy(SCRIPT, self.root)
        for tool in TOOLS:
            if found := shutil.which(tool):
                (self.tools / tool).symlink_to(found)
        self.program(self.tools / "cmake", f'echo "$@" >>{self.root}/asked; '
                     'echo "ninja: no work to do."')

    def program(self, path, lines):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f"#!/bin/sh\n{lines}\n")
        path.chmod(0o755)

    def configure(self, source):
        """Makes a build folder that was configured from the given source path."""
        build = self.root / "build" / "release"
        self.program(build / "bin" / "stokes", 'echo "ran $*"')
        (build / "build.ninja").touch()
        (build / "CMakeCache.txt").write_text(f"CMAKE_HOME_DIRECTORY:INTERNAL={source}\n")

    def stokes(self, *arguments, code=0):
        result = subprocess.run([self.root / "stokes", *arguments], capture_output=True, text=True,
                                env={"PATH": str(self.tools), "HOME": str(self.root)})
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result

    def test_what_cmake_has_found_is_not_asked_for(self):
        self.assertIn("  libeigen3-dev ", self.stokes("run", code=1).stderr)
        self.configure(self.root)
        self.assertEqual(self.stokes("run", "a.toml").stdout, "ran run a.toml\n")

    def test_what_else_is_missing_is_named(self):
        self.configure(self.root)
        for command, missing in ("docs", "doxygen"), ("test", "chromium"), ("exercise", "python3"):
            errors = self.stokes(command, code=1).stderr
            self.assertRegex(errors, rf"^stokes: not installed yet:\n(  .*\n)*  {missing} ")
            self.assertNotIn("libeigen3-dev", errors)

    def test_only_a_local_sweep_needs_gnu_parallel(self):
        self.configure(self.root)
        errors = self.stokes("sweep", "a.toml", "--jobs", "2", code=1).stderr
        self.assertRegex(errors, r"^stokes: not installed yet:\n  parallel +runs the tasks ")
        for arguments in (["--plan"], ["--out", "b", "--collect"], ["--task", "7"], ["--task=7"],
                          ["--help"]):
            self.stokes("sweep", "a.toml", *arguments)
        self.stokes("run", "sweep")

    def test_a_build_that_was_configured_is_kept(self):
        link = self.root.parent / "link"
        link.symlink_to(self.root)
        for source in self.root, link:
            self.configure(source)
            self.stokes("run")
        self.assertNotIn("--fresh", (self.root / "asked").read_text())
        self.configure(self.root.parent / "other")  # the source tree has moved
        self.stokes("run")
        self.assertIn("--fresh", (self.root / "asked").read_text())

    def test_help(self):
        for command in "test", "docs":
            self.assertIn("./stokes exercise [03] ", self.stokes(command, "--help").stdout)
        self.program(self.tools / "python3", 'echo "python3 $@"')
        tool = f"python3 -B {self.root}/chapters/exercises.py"
        self.assertEqual(self.stokes("exercise", "--help").stdout, f"{tool} exercise --help\n")
        self.assertEqual(self.stokes("check", "--help").stdout, f"{tool} check none --help\n")

    def test_check_configures_where_it_compiles(self):
        self.program(self.tools / "python3", 'echo "$@"')
        self.configure(self.root)
        for arguments, build in [((), "none"), (("01.1",), self.root / "build/release"),
                                 (("--dir", "class"), self.root / "build/release")]:
            self.assertIn(f" check {build}", self.stokes("check", *arguments).stdout)

    def install_all(self):
        for tool in ("doxygen", "python3", "git", "chromium", "slurmctld", "parallel", "clang++",
                     "c++"):
            self.program(self.tools / tool, "exit 0")
        self.configure(self.root)

    def test_bad_usage(self):
        self.install_all()
        self.assertIn("requires a name", self.stokes("test", "--preset", code=1).stderr)

    def test_tiers(self):
        self.install_all()
        self.program(self.tools / "ctest", f'echo "ctest $@" >>{self.root}/asked')
        builds = self.root / "build"

        def asked(*arguments):
            (self.root / "asked").unlink(missing_ok=True)
            report = self.stokes("test", *arguments).stderr
            lines = (self.root / "asked").read_text().splitlines()
            return report, [re.sub("^ctest .*-j [0-9]+ ?|( -- -n)$",
                                   lambda part: "" if part[1] else "ctest ", line)
                            for line in lines if line.startswith(("ctest", "--build"))]

        report, commands = asked()
        self.assertEqual(commands, [f"--build {builds}/release --target as_shipped",
                                    "ctest -L as_shipped",
                                    f"--build {builds}/asan --target sanitized",
                                    "ctest -L sanitized"])
        self.assertRegex(report, r"^(.*\n)*stokes: release, building: \d+ CPU seconds\n"
                         r"stokes: release, testing: \d+ CPU seconds\n(.*\n)*"
                         r"stokes: asan, building: \d+ CPU seconds\n"
                         r"stokes: asan, testing: \d+ CPU seconds\n"
                         r"stokes: total: \d+ CPU seconds\n$")
        self.assertEqual(asked("--full")[1], [f"--build {builds}/release --target all", "ctest ",
                                              f"--build {builds}/asan --target all",
                                              "ctest -LE full",
                                              f"--build {builds}/tsan --target races",
                                              "ctest -R ^races$"])
        self.assertEqual(asked("--preset", "debug", "-R", "fmm")[1],
                         [f"--build {builds}/debug --target all", "ctest -R fmm"])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
