"""Reads the files of a run with the readers of their users and compares the contents with the
formulas of sample_run.cpp and outputs.cpp.

usage: read_outputs.py DIRECTORY
"""

import json
import re
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataReader

N_FRAMES = 3


def outline(n, a, b, amplitude):
    s = 2 * np.pi * np.arange(n) / n
    return (1 + amplitude * np.cos(5 * s)) * (a * np.cos(s) + 1j * b * np.sin(s))


BODIES = [outline(32, 1, 0.5, 0), outline(60, 1, 1, 0.3)]
OUTER, INNER = outline(64, 10, 10, 0), outline(16, 0.5, 0.5, 0)


def body(t, j):
    """Returns x, y, theta, ux, uy, omega, fx, fy and torque of a body."""
    return (3.0 * j - 1.0 + t / 3.0, 2.0 * j - t / 7.0, j + t, 1 / 3, -1 / 7, 1.0 + j / 3.0,
            j + t / 11.0, -t / 13.0, j / 17.0)


def wall(t, j):
    """Returns fx, fy and torque of a wall."""
    return t / 3.0, j + 1.0 / 9.0, -t


def contacts(k):
    """Returns a, b, x, y, nx, ny, force and gap of body 1 with body 0, then with the outer wall."""
    t = k / 7.0
    return [("body:1", ("body:0", "wall:0")[j], 1 / 3 + t, -t, 0.6, -0.8, j + t / 19, t / 23)
            for j in range(k)]


def read_table(path):
    table = np.genfromtxt(path, names=True, delimiter=",")
    return table.dtype.names, np.array(table.tolist())


def check_tables(directory):
    times = np.arange(N_FRAMES) / 7.0
    names, rows = read_table(directory / "trajectory.csv")
    assert names == ("t", "body", "x", "y", "theta", "ux", "uy", "omega", "fx", "fy", "torque")
    assert np.array_equal(rows, [(t, j, *body(t, j)) for t in times for j in range(2)])
    names, rows = read_table(directory / "walls.csv")
    assert names == ("t", "wall", "fx", "fy", "torque")
    assert np.array_equal(rows, [(t, j, *wall(t, j)) for t in times for j in range(2)])
    names, rows = read_table(directory / "rheology.csv")
    assert names == ("t", "dissipation", "torque_ratio", "order_parameter", "s11", "s12",
                     "uniform_x", "uniform_y")
    nan = np.full(N_FRAMES, np.nan)
    expected = np.column_stack([times, times / 3, nan, -times, nan, times, -times / 5, nan])
    expected[:, 4] = 1 / 7
    expected[:, 7] = 1 / 3
    assert np.array_equal(rows, expected, equal_nan=True)
    table = np.genfromtxt(directory / "contacts.csv", names=True, delimiter=",", dtype=None,
                          encoding="ascii")
    assert table.dtype.names == ("t", "a", "b", "x", "y", "nx", "ny", "force", "gap")
    assert table.tolist() == [(t, *row) for k, t in enumerate(times) for row in contacts(k)]
    names, rows = read_table(directory / "tracers.csv")
    assert names == ("t", "tracer", "x", "y")
    assert rows.tolist() == [[t, k, *tracers(t)[k]] for t in times for k in range(2)]
    names, rows = read_table(directory / "steps.csv")
    assert names == ("t", "dt", "gmres_iterations", "matvecs", "ncp_iterations", "contacts",
                     "min_gap", "residual", "velocity_error", "step_error", "seconds", "kkt_residual",
                     "force_imbalance", "torque_imbalance", "contact_power", "energy_injected")
    assert np.array_equal(rows, [(t, 1 / 7, 10 + k, 11 + k, 12 + k, 13 + k, 1e-3 / 3, 1e-9 / 3,
                                  1e-7 / 3, 1e-5 / 3, 0.1, 1e-6 / 3, 1e-15 / 3, 1e-16 / 3, -t, 1e-4 / 3)
                                 for k, t in enumerate(times)])


def area(points):
    return 0.5 * np.sum((np.conj(points) * np.roll(points, -1)).imag)


def triangulated_area(polydata):
    """Returns the area that VTK fills when it draws the polygons."""
    triangles = vtkTriangleFilter()
    triangles.PassLinesOff()
    triangles.SetInputData(polydata)
    triangles.Update()
    mesh = triangles.GetOutput()
    x = vtk_to_numpy(mesh.GetPoints().GetData())
    corners = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return sum(0.5 * np.cross(x[b] - x[a], x[c] - x[a])[2] for a, b, c in corners)


def read_vtk(reader, path):
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append(path))
    reader.AddObserver("WarningEvent", lambda *_: errors.append(path))
    reader.SetFileName(str(path))
    reader.Update()
    assert not errors
    return reader.GetOutput()


def cell_points(polydata, k):
    ids = polydata.GetCell(k).GetPointIds()
    points = [polydata.GetPoint(ids.GetId(i)) for i in range(ids.GetNumberOfIds())]
    assert all(z == 0 for _, _, z in points)
    return np.array([x + 1j * y for x, y, _ in points])


def check_polydata(path, t):
    polydata = read_vtk(vtkXMLPolyDataReader(), path)
    states = [body(t, j) for j in range(2)]
    placed = [x + 1j * y + np.exp(1j * theta) * points
              for points, (x, y, theta, *_) in zip(BODIES, states)]
    placed_inner = -5 + np.exp(1j / 9) * INNER
    # The outer wall is a closed line; bodies and then inner walls are polygons.
    assert polydata.GetNumberOfLines() == 1 and polydata.GetNumberOfPolys() == 3
    assert polydata.GetNumberOfPoints() == 64 + 32 + 60 + 16
    expected = [np.append(OUTER, OUTER[0]), *placed, placed_inner]
    for k, points in enumerate(expected):
        np.testing.assert_allclose(cell_points(polydata, k), points, rtol=0, atol=1e-13)
    filled = sum(map(area, expected[1:]))
    np.testing.assert_allclose(triangulated_area(polydata), filled, rtol=1e-12)

    data = polydata.GetCellData()
    array = lambda name: vtk_to_numpy(data.GetArray(name))
    walls = [wall(t, j) for j in range(2)]
    assert array("id").tolist() == [-1, 0, 1, -2]
    assert array("theta").tolist() == [0, states[0][2], states[1][2], 1 / 9]
    assert array("velocity").tolist() == [[0, 0, 0], *[[1 / 3, -1 / 7, 0]] * 2, [0, 0, 0]]
    assert array("omega").tolist() == [0, states[0][5], states[1][5], 0]
    forces = [walls[0][:2], states[0][6:8], states[1][6:8], walls[1][:2]]
    assert array("force").tolist() == [[x, y, 0] for x, y in forces]
    assert array("torque").tolist() == [walls[0][2], states[0][8], states[1][8], walls[1][2]]


def check_network(path, t):
    """Lines go from one centre through the contact point to the other centre or the wall."""
    polydata = read_vtk(vtkXMLPolyDataReader(), path)
    expected = contacts(round(7 * t))
    assert polydata.GetNumberOfCells() == polydata.GetNumberOfLines() == len(expected)
    if not expected:
        return
    centres = [complex(*body(t, j)[:2]) for j in range(2)]
    for k, (_, b, x, y, *_) in enumerate(expected):
        end = centres[0] if b == "body:0" else x + 1j * y
        assert cell_points(polydata, k).tolist() == [centres[1], x + 1j * y, end]
    data = polydata.GetCellData()
    array = lambda name: vtk_to_numpy(data.GetArray(name)).tolist()
    assert array("a") == [1 for _ in expected]
    assert array("b") == [{"body:0": 0, "wall:0": -1}[b] for _, b, *_ in expected]
    assert array("normal") == [[nx, ny, 0] for *_, nx, ny, _, _ in expected]
    assert array("force") == [force for *_, force, _ in expected]
    assert array("gap") == [gap for *_, gap in expected]


def tracers(t):
    return [[1 / 3 + t, -3], [-7, t]]


def check_tracers(path, t):
    polydata = read_vtk(vtkXMLPolyDataReader(), path)
    assert polydata.GetNumberOfVerts() == polydata.GetNumberOfCells() == 2
    assert [polydata.GetPoint(k) for k in range(2)] == [(x, y, 0) for x, y in tracers(t)]
    assert vtk_to_numpy(polydata.GetCellData().GetArray("id")).tolist() == [0, 1]


def check_image(path, t):
    """Every quantity equals the formula of sample_run.cpp exactly, and is NaN in the unit disk."""
    image = read_vtk(vtkXMLImageDataReader(), path)
    assert image.GetDimensions() == (25, 17, 1)
    points = np.array([complex(*image.GetPoint(i)[:2]) for i in range(25 * 17)])
    columns, rows = np.meshgrid(np.arange(25), np.arange(17))
    np.testing.assert_allclose(points, -4 - 2.5j + (columns + 1j * rows).ravel() / 3, rtol=1e-15)
    data = image.GetPointData()
    array = lambda name: vtk_to_numpy(data.GetArray(name))
    fluid = abs(points) >= 1
    assert array("in_fluid").tolist() == fluid.astype(int).tolist() and not fluid.all()
    velocity = np.column_stack([points.real / 3 + t, -points.imag / 3])
    np.testing.assert_allclose(array("velocity")[fluid, :2], velocity[fluid], rtol=0, atol=1e-15)
    assert np.isnan(array("velocity")[~fluid, :2]).all() and (array("velocity")[:, 2] == 0).all()
    pressure = np.where(fluid, points.real / 7, np.nan)
    np.testing.assert_allclose(array("pressure"), pressure, rtol=0, atol=1e-15)
    for name, values in (("vorticity", points.imag / 11), ("shear_stress", abs(points) / 13),
                         ("dissipation", abs(points)**2 / 17)):
        np.testing.assert_allclose(array(name), values, rtol=0, atol=1e-14)


def check_collection(path, check_file):
    collection = xml.parse(path).getroot()
    assert collection.tag == "VTKFile" and collection.get("type") == "Collection"
    entries = collection.findall("Collection/DataSet")
    assert [float(entry.get("timestep")) for entry in entries] == [k / 7.0 for k in range(N_FRAMES)]
    for entry in entries:
        check_file(path.parent / entry.get("file"), float(entry.get("timestep")))


def check_picture(path):
    """Bodies are drawn at their positions, with y upwards, inside the viewBox."""
    svg = "{http://www.w3.org/2000/svg}"
    picture = xml.parse(path).getroot()
    assert picture.tag == svg + "svg"
    assert picture.find(svg + "title").text == "A < B & C"
    _, _, width, height = map(float, picture.get("viewBox").split())
    walls, bodies, contacts = picture.findall(svg + "g")
    curves = []
    for path_element in [*walls, *bodies, *contacts]:
        numbers = re.findall(r"[-.\d]+", path_element.get("d"))
        points = np.array(numbers, float).reshape(-1, 2)
        assert (points >= 0).all() and (points <= [width, height]).all()
        curves.append(points[:, 0] - 1j * points[:, 1])
    t = (N_FRAMES - 1) / 7.0
    scale = np.ptp(curves[0].real) / 20
    centre = curves[0].mean()
    for j in range(2):
        x, y, theta, *_ = body(t, j)
        expected = x + 1j * y + np.exp(1j * theta) * BODIES[j]
        np.testing.assert_allclose((curves[2 + j] - centre) / scale, expected, rtol=0, atol=1e-3)
    dots, = (path for path in picture.findall(svg + "path") if path.get("stroke") == "#e0218a")
    ends = np.array(re.findall(r"[-.\d]+", dots.get("d")), float).reshape(-1, 2) @ [1, -1j]
    expected = np.repeat([x + 1j * y for x, y in tracers(t)], 2)
    np.testing.assert_allclose((ends - centre) / scale, expected, rtol=0, atol=1e-3)


def check_field_picture(path):
    """Checks the dashes of colour in their rows, also right of the unit disk."""
    svg = "{http://www.w3.org/2000/svg}"
    picture = xml.parse(path).getroot()
    window = picture.find(svg + "svg")
    assert window.get("viewBox") == "0 0 25 17"
    colours = window.find(f"{svg}g/{svg}g")
    level_of = np.full((17, 25), -1)
    for level, dashes in enumerate(colours.findall(svg + "path")):
        for dash in dashes.get("d").split("M")[1:]:
            start, length = dash.split("h")
            column, row = map(int, start.split())
            level_of[16 - row, column:column + int(length)] = level
    # The grid reaches from -4 to 4: colours rise along x, and only the core of the disk is blank.
    assert (np.diff(level_of[-1]) >= 0).all() and level_of[-1, 0] == 0
    blank = {(int(row), int(column)) for row, column in np.argwhere(level_of < 0)}
    points = lambda row, column: complex(-4 + column / 3, -2.5 + row / 3)
    assert blank and all(abs(points(*at)) < 0.6 for at in blank)


def check_animation(path):
    """Returns the data blocks of the page, as a browser reads them."""
    blocks = re.findall(r'<script type="application/json" class="(\w+)">(.*?)</script>',
                        path.read_text())
    assert [kind for kind, _ in blocks] == ["run"] + N_FRAMES * ["frame"]
    run, *frames = [json.loads(block) for _, block in blocks]
    assert run["title"] == "A < B & C"
    assert run["encloses"] == [True, False]
    shapes = [run["shapes"][k] for k in run["bodies"] + run["walls"]]
    for shape, points in zip(shapes, [*BODIES, OUTER, INNER], strict=True):
        written = np.array(shape) @ [1, 1j]
        np.testing.assert_allclose(written, points, rtol=0, atol=1e-5 * abs(points).max())
    for k, (t, bodies, walls, network) in enumerate(frames):
        np.testing.assert_allclose(t, k / 7, rtol=1e-11)
        np.testing.assert_allclose(bodies, [body(k / 7, j) for j in range(2)], rtol=1e-5)
        places = [(0, 0, 0), (-5, 0, 1 / 9)]
        np.testing.assert_allclose(walls, [places[j] + wall(k / 7, j) for j in range(2)], rtol=1e-5)
        expected = [(1, {"body:0": 0, "wall:0": -1}[b], x, y, force, gap)
                    for _, b, x, y, _, _, force, gap in contacts(k)]
        np.testing.assert_allclose(network, expected, rtol=1e-5)


def check_run_info(path):
    assert json.loads(path.read_text()) == {
        "version": "0.1.0", "git_hash": "abc", "compiler": 'GNU "12"', "flags": "-O3",
        "machine": "x86\\64", "threads": 2, "plan": ["no walls: no N_0", "direct sum"],
        "totals": {"steps": 1, "rejected_steps": 5, "solves": 2, "gmres_iterations": 3,
                   "matvecs": 4000000000, "ncp_iterations": 6, "contact_solves": 7,
                   "contact_seconds": 0.5, "halved_by_contact": 8,
                   "largest_force_imbalance": 1e-16, "largest_torque_imbalance": 2e-16,
                   "energy_injected": -0.25},
        "resolution": {"first_nodes": [32, 64], "most_nodes": [48, 64],
                       "velocity_error": 2.5e-9, "configuration_error": 1.5e-3,
                       "field_errors": {"pressure": 0.25}},
        "uniform_velocity": [0.25, -3.0], "wall_seconds": 1.5, "peak_memory": 5000000000, "exit_status": 2,
        "message": "overlap in caf\ufffd"}


def main():
    directory = Path(sys.argv[1])
    check_tables(directory)
    check_collection(directory / "bodies.pvd", check_polydata)
    check_collection(directory / "contacts.pvd", check_network)
    check_collection(directory / "tracers.pvd", check_tracers)
    check_collection(directory / "fields.pvd", check_image)
    check_picture(directory / "configuration.svg")
    check_field_picture(directory / "fields_pressure.svg")
    check_animation(directory / "animation.html")
    check_run_info(directory / "run.json")


main()
