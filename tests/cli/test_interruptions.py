"""Runs with contact that are killed, meet a full disk, or have no place to write.

Usage: test_interruptions.py PROGRAM SCENES KILLS [unittest arguments]
"""

import json
import os
import pathlib
import random
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree as xml

import numpy

PROGRAM, SCENES, KILLS = sys.argv[1], pathlib.Path(sys.argv[2]), int(sys.argv[3])

# Stars that settle on the floor of a container: contacts come and go.
RUN = [SCENES / "settling.toml", "--set", "time.t_final=2.0", "--set", "output.dt_write=0.2",
       "--set", 'output.formats=["csv", "vtk", "svg", "html"]', "--set",
       "output.fields={ box = [-2.5, -2.5, 2.5, 2.5], resolution = 30 }"]


def start(folder, *arguments, **options):
    return subprocess.Popen([PROGRAM, "run", *map(str, RUN), "--out", folder, "--quiet", *arguments],
                            stderr=subprocess.PIPE, text=True, **options)


def finish(process):
    """Exit code and message."""
    message = process.communicate()[1]
    return process.returncode, message


def without_wall_times(path):
    """A file of a run but for the seconds that steps took, and what follows from their length."""
    text = path.read_bytes()
    if path.name == "steps.csv":
        names, *rows = [row.split(b",") for row in text.splitlines()]
        seconds = names.index(b"seconds")
        return [row[:seconds] + row[seconds + 1:] for row in [names, *rows]]
    if path.name == "checkpoint":
        return re.sub(rb"\nsteps\.csv \d+\n|\nchecksum \w+\n$", b"\n", text)
    return text


def contents(folder):
    """All files of a run but run.json, whose totals are those of the last start."""
    return {path.name: without_wall_times(path)
            for path in folder.iterdir() if path.name != "run.json"}


class Interruptions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        # In memory, where there is a place: on a disk most kills would hit a process that waits.
        place = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
        folder = tempfile.TemporaryDirectory(dir=place)
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        begin = time.monotonic()
        assert finish(start(cls.folder / "whole")) == (0, "")
        cls.seconds = time.monotonic() - begin
        cls.whole = contents(cls.folder / "whole")
        steps = numpy.genfromtxt(cls.folder / "whole/steps.csv", names=True, delimiter=",")
        assert steps["contacts"].max() > 0, "a run without contact"

    def check_readable(self, folder):
        """What a reader relies on at any moment."""
        for path in folder.iterdir():
            with self.subTest(file=path.name):
                if path.suffix == ".csv" and path.stat().st_size > 0:
                    names, *rows = path.read_text().splitlines(keepends=True)
                    for row in rows:
                        self.assertEqual(row.count(","), names.count(","))
                        self.assertTrue(row.endswith("\n"))
                elif path.suffix in (".vtp", ".vti", ".svg"):
                    xml.parse(path)
                elif path.suffix == ".pvd":
                    for entry in xml.parse(path).iter("DataSet"):
                        self.assertTrue((folder / entry.get("file")).exists())
                elif path.suffix == ".html" and path.stat().st_size > 0:
                    self.assertTrue(path.read_text().endswith("</script>\n"))
                elif path.suffix == ".json":
                    json.loads(path.read_text())

    def check_resumes(self, folder, whole, *arguments):
        self.assertEqual(finish(start(folder, "--resume", *arguments)), (0, ""))
        resumed = contents(folder)
        self.assertEqual(sorted(resumed), sorted(whole))
        for name, text in whole.items():
            self.assertTrue(resumed[name] == text, f"{name} differs")

    def test_killed_at_random_moments(self):
        moments = random.Random(1)
        killed = at_work = 0
        while killed < KILLS:
            folder = self.folder / f"killed{killed}"
            process = start(folder)
            time.sleep(moments.uniform(0.0, self.seconds))
            process.send_signal(signal.SIGKILL)
            code, _ = finish(process)
            if code == 0:  # too late
                subprocess.run(["rm", "-r", folder], check=True)
                continue
            killed += 1
            at_work += (folder / "checkpoint").exists()
            with self.subTest(kill=killed):
                if folder.exists():
                    self.check_readable(folder)
                self.check_resumes(folder, self.whole)
        self.assertGreater(at_work, KILLS // 4)  # else most kills came before the first step

    def test_a_full_disk(self):
        """A limit on the size of files stands for a disk that takes a part of a file only.

        No limit is below 1024 bytes: Clang's OpenMP has a file of its own of this size.
        """
        without_page = "--set", 'output.formats=["csv", "vtk"]'  # the page would be the first refused
        self.assertEqual(finish(start(self.folder / "pageless", *without_page)), (0, ""))
        pageless = contents(self.folder / "pageless")
        refused = set()
        for size, formats, whole in ((1100, without_page, pageless), (2000, without_page, pageless),
                                     (25_000, without_page, pageless), (45_000, without_page, pageless),
                                     (25_000, (), self.whole)):
            folder = self.folder / f"full{len(formats)}_{size}"
            limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
            code, message = finish(start(folder, *formats, preexec_fn=limit))
            with self.subTest(size=size, message=message):
                self.assertEqual(code, 3)
                self.assertEqual(message.count("\n"), 1)
                named = re.fullmatch(rf"stokes: {folder}/(\S+): writing.*File too large\n", message)
                self.assertIsNotNone(named)
                refused.add(re.sub(r"\d+", "", named[1]))
                self.check_readable(folder)
                self.check_resumes(folder, whole, *formats)
        self.assertGreater(len(refused), 3, refused)  # files of several kinds

    def test_no_place_to_write(self):
        (self.folder / "file").write_text("")
        blocked = self.folder / "blocked"
        (blocked / "checkpoint.partial" / "in_the_way").mkdir(parents=True)
        places = [(self.folder / "file/out", "file/out"), ("/dev/null", "/dev/null"),
                  ("/proc/out", "/proc/out"), (blocked, "blocked/checkpoint.partial")]
        if os.geteuid() != 0:  # who may write everywhere
            (self.folder / "closed").mkdir(mode=0o555)
            places.append((self.folder / "closed", "closed/"))
        for place, named in places:
            with self.subTest(place=place):
                code, message = finish(start(place))
                self.assertEqual(code, 3)
                self.assertIn(named, message)
        subprocess.run(["rm", "-r", blocked / "checkpoint.partial"], check=True)
        self.check_resumes(blocked, self.whole)

    def test_a_full_disk_for_what_is_printed(self):
        """It may get lost; the run and its files do not."""
        with open("/dev/full", "w") as full:
            process = subprocess.run([PROGRAM, "run", *map(str, RUN), "--out", self.folder / "mute"],
                                     stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual((process.returncode, process.stderr),
                         (3, "stokes: standard output: not all of it could be written\n"))
        self.assertEqual(contents(self.folder / "mute"), self.whole)


if __name__ == "__main__":
    os.environ["OMP_NUM_THREADS"] = "1"
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
