"""Tests that the shipped scripts can read the files of a run.

Usage: test_views.py PROGRAM SUSPENSION [unittest arguments]
"""

import importlib.util
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml

from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataReader

PROGRAM, SUSPENSION = sys.argv[1], pathlib.Path(sys.argv[2])
VIEWS = SUSPENSION / "views"


def module(name):
    spec = importlib.util.spec_from_file_location(name, VIEWS / f"{name}.py")
    loaded = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(loaded)
    return loaded


class Views(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.run_folder = pathlib.Path(folder.name) / "run"
        subprocess.run(
            [PROGRAM, "run", SUSPENSION / "scenes/settling.toml", "--out", cls.run_folder, "--quiet",
             "--set", "time.t_final=0.4", "--set", "output.dt_write=0.2", "--set",
             "output.fields={ box = [-2.5, -2.5, 2.5, 2.5], resolution = 20 }"], check=True)

    def test_paraview_run_asks_for_what_a_run_has(self):
        script = module("paraview_run")
        for name, place, array, _ in (script.BODIES, script.CONTACTS, script.FIELDS[0]):
            collection = xml.parse(self.run_folder / name).getroot()
            first = self.run_folder / collection.find("Collection/DataSet").get("file")
            reader = (vtkXMLImageDataReader if first.suffix == ".vti" else vtkXMLPolyDataReader)()
            reader.SetFileName(str(first))
            reader.Update()
            data = reader.GetOutput()
            values = {"CELLS": data.GetCellData(), "POINTS": data.GetPointData()}[place]
            self.assertTrue(values.HasArray(array), f"{name}: {array}")
            if (name, place, array) == script.BODIES[:3]:
                self.assertEqual(values.GetArray(script.NUMBER).GetRange(), (-1, 4))
        quantities = {array for _, _, array, _ in script.FIELDS}
        self.assertEqual(quantities,
                         {"velocity", "pressure", "vorticity", "shear_stress", "dissipation"})

    def test_plot_means_draws_means_intervals_and_laws_to_scale(self):
        table, picture = (self.run_folder.parent / name for name in ("table.csv", "means.svg"))
        table.write_text('channel,speed,speed_interval\n"[2.0, 1.5]",4.0,0.5\n"[2.0, 0.5]",2.0,1.0\n'
                         '"[2.0, 1.0]",3.0,nan\n')
        subprocess.run([sys.executable, "-B", VIEWS / "plot_means.py", table, "--x", "channel[0] * channel[1]",
                        "--y", "speed", "--law", "1 + x", "--title", "3 < 4", "--out", picture], check=True)
        svg = xml.parse(picture).getroot()
        name = "{http://www.w3.org/2000/svg}"
        self.assertEqual(svg.find(f"{name}title").text, "3 < 4")
        means, law = (svg.find(f"{name}g[@class='{kind}']") for kind in ("line-0 means", "line-1"))
        marks = [(float(mark.get("cx")), float(mark.get("cy"))) for mark in means.iter(f"{name}circle")]
        lines = [[tuple(map(float, point.split())) for point in path.get("d")[1:].split("L")]
                 for group in (means, law) for path in group.iter(f"{name}path")]
        (x1, y1), (x2, y2), (x3, y3) = marks[:3]  # of the means 2, 3 and 4
        self.assertAlmostEqual(x2 - x1, x3 - x2, delta=0.02)
        self.assertAlmostEqual(y1 - y2, y2 - y3, delta=0.02)
        unit = y1 - y2
        bars = [line for line in lines[:6] if line[0][0] == line[1][0]]
        self.assertEqual([bar[0][0] for bar in bars], [x1, x3])
        for (bottom, top), y, half in zip(bars, (y1, y3), (1.0, 0.5)):
            self.assertAlmostEqual(bottom[1], y + half * unit, delta=0.02)
            self.assertAlmostEqual(top[1], y - half * unit, delta=0.02)
        for x, y in (marks[0], marks[2]):  # 1 + x is 2 at x = 1, and 4 at x = 3
            self.assertLess(min(abs(x - px) + abs(y - py) for px, py in lines[6]), 0.05)

    def test_plot_means_draws_tables_side_by_side_on_a_logarithmic_axis(self):
        tables = [self.run_folder.parent / f"{name}.csv" for name in ("first", "second")]
        tables[0].write_text("x,u,u_interval\n1,1.0,0.5\n2,10.0,1.0\n3,100.0,nan\n")
        tables[1].write_text("x,v,v_interval\n1,100.0,1.0\n3,10.0,1.0\n")
        picture = tables[0].with_suffix(".svg")
        arguments = [sys.executable, "-B", VIEWS / "plot_means.py", *tables, "--x", "x", "--y", "u", "--y", "v",
                     "--log", "--out", picture]
        subprocess.run([*arguments, "--label", "a", "--label", "b", "--law", "10**x"], check=True)
        svg = xml.parse(picture).getroot()
        name = "{http://www.w3.org/2000/svg}"
        first, second = ([(float(mark.get("cx")), float(mark.get("cy"))) for mark in group.iter(f"{name}circle")]
                         for group in svg.iter(f"{name}g") if "means" in group.get("class"))
        decade = first[0][1] - first[1][1]
        self.assertAlmostEqual(first[1][1] - first[2][1], decade, delta=0.02)
        for (x1, y1), (x2, y2) in ((first[0], second[1]), (first[2], second[0])):
            self.assertAlmostEqual(abs(x2 - x1), first[2][0] - first[0][0] + (7.0 if x1 < x2 else -7.0),
                                   delta=0.02)
            self.assertAlmostEqual(abs(y2 - y1), decade if x1 < x2 else 0.0, delta=0.02)
        texts = [text.text for text in svg.iter(f"{name}text")]
        for text in "a", "b", "10**x", "1", "2", "5", "500":
            self.assertIn(text, texts)
        for more, words in (([], "a different --label each"), (["--label", "a", "--label", "a"], "--label each"),
                            (["--label", "a", "--label", "b", "--law", "0 - x"], "above zero")):
            result = subprocess.run([*arguments, *more], capture_output=True, text=True)
            self.assertEqual(result.returncode, 2)
            self.assertIn(words, result.stderr)

    def test_plot_means_refuses_what_is_not_in_the_table(self):
        table = self.run_folder.parent / "few.csv"
        table.write_text("a,b,b_interval\n1,2,0.1\n1,3,0.1\n")
        for x, y, law, words in (("a", "c", "x", "'c'"), ("d", "b", "x", "name 'd'"),
                                 ("a", "a", "x", "'a_interval'"), ("b", "b", "x +", "syntax"),
                                 ("a", "b", "x", "all rows have a = 1.0")):
            result = subprocess.run([sys.executable, "-B", VIEWS / "plot_means.py", table, "--x", x, "--y", y,
                                     "--law", law, "--out", table.with_suffix(".svg")],
                                    capture_output=True, text=True)
            self.assertEqual(result.returncode, 2)
            self.assertIn(words, result.stderr)


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
