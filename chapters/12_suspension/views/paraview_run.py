"""Opens a run in ParaView: bodies by speed, walls, contacts by force, tracers, a field of the fluid.

paraview --script=paraview_run.py      in the folder of the run; or File, Load State
pvpython paraview_run.py FOLDER PNG    writes a picture of the last time

A run has these files with the format "vtk" (bodies, contacts, tracers) and with [output] fields.
"""

import pathlib
import sys

# The files of a run that are shown, if they are there, the array each is coloured by, and its map.
BODIES = ("bodies.pvd", "CELLS", "velocity", "Viridis (matplotlib)")
CONTACTS = ("contacts.pvd", "CELLS", "force", "Black-Body Radiation")
TRACERS = ("tracers.pvd",)
FIELDS = [("fields.pvd", "POINTS", name, "Cool to Warm")  # the first that the run has
          for name in ("pressure", "vorticity", "shear_stress", "dissipation", "velocity")]
NUMBER = "id"  # of a body; walls count down from -1


def coloured(simple, source, view, place, name, colours):
    """Shown by a map of its own: velocities of bodies and fluid have different ranges."""
    display = simple.Show(source, view)
    simple.ColorBy(display, (place, name), True)
    display.RescaleTransferFunctionToDataRangeOverTime()
    simple.GetColorTransferFunction(name, display, True).ApplyPreset(colours, True)
    display.SetScalarBarVisibility(view, True)
    return display


def reader_of(simple, path):
    return simple.PVDReader(registrationName=path.name, FileName=str(path))


def show_components(simple, path, view):
    """Bodies in colour, walls in grey."""
    reader = reader_of(simple, path)
    # Filled polygons are drawn as if they were convex; triangles are what they are.
    triangles = simple.Triangulate(Input=reader)
    numbers = reader.CellData[NUMBER].GetRange()

    def part(name, low, high):
        return simple.Threshold(registrationName=name, Input=triangles,
                                Scalars=["CELLS", NUMBER], LowerThreshold=low, UpperThreshold=high)

    coloured(simple, part("bodies", 0, max(numbers[1], 0)), view, *BODIES[1:])
    if numbers[0] < 0:
        walls = simple.Show(part("walls", numbers[0], -1), view)
        simple.ColorBy(walls, None)
        walls.DiffuseColor = walls.AmbientColor = [0.4, 0.4, 0.4]
        walls.LineWidth = 3


def show_contacts(simple, path, view):
    coloured(simple, reader_of(simple, path), view, *CONTACTS[1:]).LineWidth = 4


def show_tracers(simple, path, view):
    points = simple.Show(reader_of(simple, path), view)
    simple.ColorBy(points, None)
    points.DiffuseColor = points.AmbientColor = [0.88, 0.13, 0.54]
    points.PointSize = 4


def show_field(simple, path, view):
    """The first quantity that the run has, behind the bodies; none where there is no fluid."""
    reader = reader_of(simple, path)
    _, place, name, colours = next(f for f in FIELDS if f[2] in reader.PointData.keys())
    display = coloured(simple, reader, view, place, name, colours)
    simple.GetColorTransferFunction(name, display, True).NanOpacity = 0.0
    display.Position = [0.0, 0.0, -1e-3]


def show_run(folder):
    from paraview import simple
    if not (folder / BODIES[0]).exists():
        raise SystemExit(f'{folder / BODIES[0]} is not there: run the scene with the format "vtk", '
                         "and start ParaView in the folder of the run")
    view = simple.GetActiveViewOrCreate("RenderView")
    view.InteractionMode = "2D"
    for (name, *_), show in ((BODIES, show_components), (CONTACTS, show_contacts),
                             (TRACERS, show_tracers), (FIELDS[0], show_field)):
        if (folder / name).exists():
            show(simple, folder / name, view)
    simple.GetAnimationScene().GoToLast()
    simple.ResetCamera(view)
    simple.Render(view)
    return simple, view


if __name__ in ("__main__", "__vtkconsole__"):
    is_batch = len(sys.argv) == 3
    simple, view = show_run(pathlib.Path(sys.argv[1] if is_batch else "."))
    if is_batch:
        view.ViewSize = [1200, 900]
        simple.SaveScreenshot(sys.argv[2], view)
