"""Tests runs with contact that are killed, meet a full disk, or have no writable folder.

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
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataReader

sys.path.insert(0, str(pathlib.Path(__file__).parents[1]))
from tiers import full

PROGRAM, SCENES, KILLS = sys.argv[1], pathlib.Path(sys.argv[2]), int(sys.argv[3])

# Stars settle on the floor of a container: contacts begin and end.
RUN = [SCENES / "settling.toml", "--set", "time.t_final=2.0", "--set", "output.dt_write=0.2",
       "--set", 'output.formats=["csv", "vtk", "svg", "html"]', "--set",
       "output.fields={ box = [-2.5, -2.5, 2.5, 2.5], resolution = 30 }"]


# With many bodies, a written time fills several pages of trajectory.csv; little is computed.
CROWD = """
[flow]
kind = "shear"
rate = 1.0
[solver]
tolerance = 0.1
summation = "direct"
[time]
t_final = 0.1
dt = 0.005
method = "euler"
[output]
dt_write = 0.01
formats = ["csv", "vtk", "html"]
""" + "".join(f"""
[[bodies]]
shape = {{ kind = "circle", radius = 0.2 }}
position = [{k % 10}.0, {k // 10}.0]
n_nodes = 8
""" for k in range(80))


def start(folder, *arguments, run=RUN, **options):
    return subprocess.Popen([PROGRAM, "run", *map(str, run), "--out", folder, "--quiet", *arguments],
                            stderr=subprocess.PIPE, text=True, **options)


def finish(process):
    """Returns the exit code and the message of a process that has ended."""
    message = process.communicate()[1]
    return process.returncode, message


def without_wall_times(path):
    """Returns a file of a run without the wall times of steps and what depends on their length."""
    text = path.read_bytes()
    if path.name == "steps.csv":
        names, *rows = [row.split(b",") for row in text.splitlines()]
        seconds = names.index(b"seconds")
        return [row[:seconds] + row[seconds + 1:] for row in [names, *rows]]
    if path.name.startswith("checkpoint"):
        return re.sub(rb'"steps\.csv":\d+|\nchecksum \w+\n$', b"", text)
    return text


def without_cost(information):
    """Returns run.json with the totals of the whole run, without the work since the last start."""
    whole_run = ("steps", "largest_force_imbalance", "largest_torque_imbalance", "energy_injected")
    totals = {name: information["totals"].get(name) for name in whole_run}
    return {**information, "totals": totals, "wall_seconds": None, "peak_memory": None}


def contents(folder):
    """Returns all files of a run, without what an interruption may change."""
    files = {path.name: without_wall_times(path)
             for path in folder.iterdir() if path.name != "run.json"}
    return {**files, "run.json": without_cost(json.loads((folder / "run.json").read_text()))}


def rows_of(path):
    """Returns the rows that NumPy reads from a table; a damaged table raises an error."""
    return numpy.atleast_1d(numpy.genfromtxt(path, names=True, delimiter=",", dtype=None,
                                             encoding="ascii"))


def vtk_reads(reader, path):
    """Returns whether VTK reads a file without an error or a warning."""
    complaints = []
    for event in ("ErrorEvent", "WarningEvent"):
        reader.AddObserver(event, lambda *_: complaints.append(path))
    reader.SetFileName(str(path))
    reader.Update()
    return not complaints and reader.GetOutput().GetNumberOfPoints() > 0


def checkpoint_of(folder):
    """Returns the time and the number of written times, or -inf and 0 without a checkpoint."""
    if not (folder / "checkpoint").exists():
        return -numpy.inf, 0
    saved = json.loads((folder / "checkpoint").read_text().splitlines()[1])
    return saved["t"], saved["frames"][0]


class Interruptions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        # The folder is in memory if possible: on a disk, most kills would hit a process that waits.
        place = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
        folder = tempfile.TemporaryDirectory(dir=place)
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        begin = time.monotonic()
        assert finish(start(cls.folder / "whole")) == (0, "")
        cls.seconds = time.monotonic() - begin
        cls.whole = contents(cls.folder / "whole")
        steps = rows_of(cls.folder / "whole/steps.csv")
        assert steps["contacts"].max() > 0, "a run without contact"

    def check_readable(self, folder):
        """Checks the properties of the files on which a reader relies at any moment."""
        for path in folder.iterdir():
            with self.subTest(file=path.name):
                if path.suffix == ".csv":
                    self.assertTrue(path.read_bytes().endswith(b"\n"))
                    if path.read_bytes().count(b"\n") > 1:
                        rows_of(path)
                elif path.suffix in (".vtp", ".vti"):
                    reader = {".vtp": vtkXMLPolyDataReader, ".vti": vtkXMLImageDataReader}[path.suffix]
                    if not path.name.startswith("contacts"):  # this file may be empty
                        self.assertTrue(vtk_reads(reader(), path))
                elif path.suffix == ".svg":
                    xml.parse(path)
                elif path.suffix == ".pvd":
                    for entry in xml.parse(path).iter("DataSet"):
                        self.assertTrue((folder / entry.get("file")).exists())
                elif path.suffix == ".html":
                    text = path.read_text()
                    self.assertTrue(text.endswith("</script>\n"))
                    for block in re.findall(r'class="(?:run|frame)">(.*)</script>\n', text):
                        json.loads(block)
                elif path.suffix == ".json":
                    json.loads(path.read_text())

    def check_loss(self, folder, bodies, dt_write):
        """Checks that the checkpoint is at most a written interval old, and matches tables."""
        t, frames = checkpoint_of(folder)
        for name, rows_a_frame in (("trajectory.csv", bodies), ("rheology.csv", 1)):
            if not (folder / name).exists():
                continue
            rows = (folder / name).read_bytes().count(b"\n") - 1
            self.assertIn(rows, (frames * rows_a_frame, (frames + 1) * rows_a_frame), name)
        if (folder / "steps.csv").exists():
            # Rows that a reader does not see yet show how far the run was.
            for path in folder.glob("steps.csv*"):
                *rows, _ = path.read_text().split("\n")
                reached = [float(row.split(",")[0]) for row in rows[1:]]
                self.assertLessEqual(max(reached, default=-numpy.inf), t + dt_write * (1 + 1e-12))

    def check_resumes(self, folder, whole, *arguments, run=RUN):
        self.assertEqual(finish(start(folder, "--resume", *arguments, run=run)), (0, ""))
        resumed = contents(folder)
        self.assertEqual(sorted(resumed), sorted(whole))
        for name, text in whole.items():
            self.assertTrue(resumed[name] == text, f"{name} differs")

    def check_kills(self, run, whole, seconds, dt_write):
        """Kills a run of the given duration at random moments, and resumes it."""
        bodies = len(numpy.unique(rows_of(whole / "trajectory.csv")["body"]))
        moments = random.Random(1)
        killed = at_work = 0
        while killed < KILLS:
            folder = self.folder / f"{whole.name}_killed{killed}"
            process = start(folder, run=run)
            time.sleep(moments.uniform(0.0, seconds))
            process.send_signal(signal.SIGKILL)
            code, _ = finish(process)
            if code == 0:  # the kill came too late
                subprocess.run(["rm", "-r", folder], check=True)
                continue
            killed += 1
            at_work += (folder / "checkpoint").exists()
            with self.subTest(kill=killed):
                if folder.exists():
                    self.check_readable(folder)
                    self.check_loss(folder, bodies, dt_write)
                self.check_resumes(folder, contents(whole), run=run)
        self.assertGreater(at_work, KILLS // 4)  # otherwise most kills came too early

    def test_killed_at_random_moments(self):
        self.check_kills(RUN, self.folder / "whole", self.seconds, dt_write=0.2)

    def test_killed_with_many_bodies(self):
        (self.folder / "crowd.toml").write_text(CROWD)
        run, whole = [self.folder / "crowd.toml"], self.folder / "crowd"
        begin = time.monotonic()
        self.assertEqual(finish(start(whole, run=run)), (0, ""))
        seconds = time.monotonic() - begin
        self.assertGreater((whole / "trajectory.csv").stat().st_size / 11, 2 * 4096)
        self.check_kills(run, whole, seconds, dt_write=0.01)

    def check_full_disks(self, sizes, formats, whole):
        """Returns the names of the files that disks of these sizes refuse.

        A limit on the size of files simulates a disk that takes only a part of a file. No limit is
        below 1024 bytes, because Clang's OpenMP writes a file of this size.
        """
        refused = set()
        for size in sizes:
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
        return refused

    def test_a_full_disk(self):
        self.assertEqual(len(self.check_full_disks([25_000], (), self.whole)), 1)

    @full
    def test_disks_that_are_full_at_other_sizes(self):
        without_page = "--set", 'output.formats=["csv", "vtk"]'  # else the page is refused first
        self.assertEqual(finish(start(self.folder / "pageless", *without_page)), (0, ""))
        refused = self.check_full_disks([1100, 2000, 25_000, 45_000], without_page,
                                        contents(self.folder / "pageless"))
        self.assertGreater(len(refused), 2, refused)  # files of several kinds

    def test_no_place_to_write(self):
        (self.folder / "file").write_text("")
        blocked = self.folder / "blocked"
        (blocked / "checkpoint.partial" / "in_the_way").mkdir(parents=True)
        places = [(self.folder / "file/out", "file/out"), ("/dev/null", "/dev/null"),
                  ("/proc/out", "/proc/out"), (blocked, "blocked/checkpoint.partial")]
        if os.geteuid() != 0:  # root may write everywhere
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
        """The output of the program may be lost; the run continues and writes its files."""
        with open("/dev/full", "w") as full:
            process = subprocess.run([PROGRAM, "run", *map(str, RUN), "--out", self.folder / "mute"],
                                     stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual((process.returncode, process.stderr),
                         (3, "stokes: standard output: could not be written completely\n"))
        self.assertEqual(contents(self.folder / "mute"), self.whole)


if __name__ == "__main__":
    os.environ["OMP_NUM_THREADS"] = "1"
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
