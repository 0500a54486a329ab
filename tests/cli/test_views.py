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


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
