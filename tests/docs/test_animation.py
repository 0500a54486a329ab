"""Opens the animation of a run in a browser and compares what it shows with the run's tables.

test_animation.py PROGRAM CHROMIUM
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import browser

PROGRAM = sys.argv.pop(1)
CHROMIUM = sys.argv.pop(1)

# A disk touches the turning wall, and a star floats.
SCENE = """
title = "Disk </script> & star"
[[walls]]
role = "outer"
shape = { kind = "circle", radius = 2.0 }
n_nodes = "auto"
motion = { kind = "rotating", omega = 0.3 }
[[bodies]]
shape = { kind = "circle", radius = 0.5 }
position = [0.0, -1.44]
force = [0.0, -60.0]
n_nodes = "auto"
[[bodies]]
shape = { kind = "star", radius = 0.45, amplitude = 0.2, arms = 5 }
position = [-0.3, 0.7]
n_nodes = "auto"
[solver]
tolerance = 1e-3
[time]
t_final = 1.0
dt = 0.1
method = "heun"
[contact]
minimum_separation = 0.05
[output]
formats = ["csv", "html"]
"""
# A sheared cell, whose reduced basis changes at t = 0.5.
CELL = """
[flow]
kind = "shear"
rate = 1.0
centre = [0.5, -0.25]
[cell]
vectors = [[3.0, 0.0], [0.0, 3.0]]
[[bodies]]
shape = { kind = "circle", radius = 0.5 }
position = [1.2, 0.9]
n_nodes = "auto"
[[bodies]]
shape = { kind = "ellipse", semi_axes = [0.6, 0.4] }
position = [-8.6, -0.8]
n_nodes = "auto"
[solver]
tolerance = 1e-3
[time]
t_final = 0.9
[output]
dt_write = 0.15
formats = ["csv", "html"]
"""
RADIUS, OMEGA = 2.0, 0.3  # radius and angular velocity of the wall
TIP = 0.45 * 1.2  # distance of the star's tip from its centre
SIZE = (900, 700)
# After two frames, the browser has drawn the current state of the page.
DRAWN = "new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))"
FRAME = '<script type="application/json" class="frame">'


def setUpModule():
    global folder, page, trajectory, contacts, chromium, tab
    folder = tempfile.TemporaryDirectory()
    place = pathlib.Path(folder.name).resolve()
    (place / "scene.toml").write_text(SCENE)
    subprocess.run([PROGRAM, "run", place / "scene.toml", "--out", place / "out", "--quiet"],
                   check=True)
    page = place / "out" / "animation.html"
    table = np.genfromtxt(place / "out" / "trajectory.csv", names=True, delimiter=",")
    trajectory = table.reshape(-1, 2)  # frames x bodies
    contacts = np.genfromtxt(place / "out" / "contacts.csv", names=True, delimiter=",", dtype=None,
                             encoding="ascii")
    chromium = browser.Browser(CHROMIUM)
    tab = chromium.tab()


def tearDownModule():
    chromium.__exit__()
    folder.cleanup()


def state(body):
    """Returns the state of a body in a row of the trajectory, in the page's form."""
    return [float(x) for x in body.tolist()[2:]]


class Animation(unittest.TestCase):
    def open(self, path=None, **look):
        tab.look(*SIZE, **{"still": True, **look})
        self.assertEqual(tab.open((path or page).as_uri()), [])
        tab.evaluate(DRAWN)
        self.addCleanup(lambda: self.assertEqual(tab.errors(), []))

    def run_js(self, code):
        value = tab.evaluate(code)
        tab.evaluate(DRAWN)
        return value

    def shown(self, id):
        return tab.evaluate(f"document.getElementById('{id}').innerText")

    def mouse(self, kind, x, y, **more):
        left, top = tab.evaluate("(({left, top}) => [left, top])"
                                 "(document.getElementById('canvas').getBoundingClientRect())")
        tab.send("Input.dispatchMouseEvent", type=kind, x=left + x, y=top + y, **more)
        tab.evaluate(DRAWN)

    def key(self, key):
        for kind in ["keyDown", "keyUp"]:
            tab.send("Input.dispatchKeyEvent", type=kind, key=key)
        tab.evaluate(DRAWN)

    def pixel_of(self, point):
        """Returns the pixel of a point: the container is centred and takes most of the space."""
        size = tab.evaluate("(canvas => [canvas.clientWidth, canvas.clientHeight])"
                            "(document.getElementById('canvas'))")
        scale = 0.94 * min(size) / (2 * RADIUS)
        return size[0] / 2 + scale * point["x"], size[1] / 2 - scale * point["y"]

    def colour_at(self, x, y):
        return tab.evaluate("[...document.getElementById('canvas').getContext('2d')"
                            f".getImageData({round(x)}, {round(y)}, 1, 1).data]")

    def test_frames_and_times_are_those_of_the_table(self):
        self.open()
        self.assertEqual(tab.evaluate("player.frames.length"), len(trajectory))
        self.assertEqual(self.shown("title"), "Disk </script> & star")
        for k, bodies in enumerate(trajectory):
            self.run_js(f"player.seek({k})")
            time = re.fullmatch(r"t = (\d+\.\d+)", self.shown("time"))
            self.assertAlmostEqual(float(time[1]), bodies["t"][0], delta=1e-3)
            self.assertEqual(self.shown("count"), f"frame {k} of {len(trajectory) - 1}")

    def test_bodies_are_where_the_table_says(self):
        self.open()
        for k, bodies in enumerate(trajectory):
            shown = self.run_js(f"player.seek({k}), player.state.bodies")
            np.testing.assert_allclose(shown, [state(body) for body in bodies], rtol=1e-5)

    def test_bodies_of_a_cell_are_images_next_to_its_centre(self):
        place = page.parent.parent / "cell"
        (place.parent / "cell.toml").write_text(CELL)
        subprocess.run([PROGRAM, "run", place.parent / "cell.toml", "--out", place, "--quiet"],
                       check=True)
        paths = np.genfromtxt(place / "trajectory.csv", names=True, delimiter=",").reshape(-1, 2)
        self.open(place / "animation.html")
        self.assertEqual(tab.evaluate("player.frames.length"), len(paths))
        centre, numbers = np.array([0.5, -0.25]), np.arange(-9, 10)
        outside = 0
        for at in np.arange(0, len(paths) - 0.5, 0.5):
            k, part = int(at), at % 1
            first, second = paths[k], paths[min(k + 1, len(paths) - 1)]
            t, *path = ((1 - part) * first[name] + part * second[name] for name in ("t", "x", "y"))
            shown = self.run_js(f"player.place = {at}, player.show(), player.state.bodies")
            vectors = np.array([(3 * i + 3 * t[0] * j, 3 * j) for i in numbers for j in numbers])
            for body, x, y in zip(shown, *path):
                images = np.array([x, y]) + vectors - centre
                expected = centre + images[np.argmin(np.hypot(*images.T))]
                np.testing.assert_allclose(body[:2], expected, atol=1e-4)
                if part == 0:  # U - G w with the vector w from the image to the path
                    number = shown.index(body)
                    exact = [first["ux"][number] - (y - expected[1]), first["uy"][number]]
                    np.testing.assert_allclose(body[3:5], exact, atol=1e-4)
                outside += np.hypot(*(expected - (x, y))) > 1
            corners = self.run_js("player.state.lattice.corners()") - centre
            self.assertEqual(len(corners), 6)
            for corner in corners:  # as far from the centre as from two other vectors, and from none nearer
                distances = np.sort(np.hypot(*(vectors - corner).T)) - np.hypot(*corner)
                np.testing.assert_allclose(distances[:3], 0, atol=1e-9)
        self.assertGreater(outside, len(paths))

    def test_contacts_in_a_cell_join_the_images_that_touch(self):
        """A rod longer than the cell touches a disk and its own image; other images are nearer."""
        still = [0] * 6
        frame = [0, [[2, 6, 0.8, *still], [-3.4, 1.6, 0, *still]], [still],
                 [[0, 1, 3.5, 7.5, 1, 0, 7, 1], [0, 0, 3.7, 7.2, 1, 0, 1, 0]], [0, 0, 1, 0, 0, 6]]
        text = page.read_text()
        touching = page.with_name("touching.html")
        touching.write_text(text[:text.index(FRAME)] + FRAME + json.dumps(frame) + "</script>")
        self.open(touching)
        # Middles of lines from (0, 0) and (1.6, 1.6) to (1.5, 1.5), and from (0, 0) and (1, 0) to
        # (1.7, 1.2).
        middles = [[0.75, 0.75], [1.55, 1.55], [0.85, 0.6], [1.35, 0.6]]
        pixels = tab.evaluate(f"{middles}.map(point => player.view.toPixel(...point))")
        found = tab.evaluate(f"{pixels}.map(pixel => "
                             "player.view.pick(player.state, ...pixel, true))")
        self.assertEqual([part.get("contact") for part in found], [0, 0, 1, 1])
        shown = [self.colour_at(*pixel) for pixel in pixels]
        self.run_js("document.getElementById('contacts').click()")
        for pixel, colour in zip(pixels, shown):
            self.assertNotEqual(self.colour_at(*pixel), colour)

    def test_walls_turn(self):
        self.open()
        turned = self.run_js("player.seek(7), player.state.walls[0][2]")
        self.assertAlmostEqual(turned, OMEGA * trajectory[7]["t"][0], delta=1e-5)

    def test_states_between_frames_are_linear(self):
        self.open()
        shown = self.run_js("player.place = 3.25, player.show(), player.state.bodies")
        expected = [0.75 * np.array(state(a)) + 0.25 * np.array(state(b))
                    for a, b in zip(trajectory[3], trajectory[4])]
        np.testing.assert_allclose(shown, expected, rtol=1e-4, atol=1e-5)

    def test_drawing(self):
        """Compares the colours at a body's centre, in the fluid and outside, in both styles."""
        seen = {}
        for dark in [False, True]:
            self.open(dark=dark)
            self.run_js("player.seek(0)")
            x, y = self.pixel_of(trajectory[0][1])
            radius = tab.evaluate("0.7 * player.view.scale")
            seen[dark] = [self.colour_at(*at) for at in [(x, y), (x + radius, y), (3, 3)]]
            self.assertEqual(len({tuple(colour) for colour in seen[dark]}), 3, seen)
        self.assertEqual(seen[False][0], seen[True][0])     # both show the colour of a speed
        self.assertGreater(sum(seen[False][1]), sum(seen[True][1]) + 200)
        self.assertEqual(seen[False][2], seen[True][2])     # nothing is drawn there

    def test_marks_turn_with_bodies(self):
        """The star's mark lies along its direction 1, halfway to its tip and further."""
        self.open()
        self.key("End")
        star = trajectory[-1][1]
        self.assertGreater(star["theta"], 0.2)

        def colour_along(angle):
            return self.colour_at(*self.pixel_of({"x": star["x"] + 0.6 * TIP * np.cos(angle),
                                                  "y": star["y"] + 0.6 * TIP * np.sin(angle)}))
        fill = colour_along(-star["theta"])
        self.assertEqual(fill, self.colour_at(*self.pixel_of(star)))
        self.assertGreater(np.abs(np.subtract(colour_along(star["theta"]), fill)).max(), 80)

    def test_hovering_shows_numbers(self):
        for dark in [False, True]:
            self.open(dark=dark)
            self.run_js("player.seek(4)")
            self.assertTrue(tab.evaluate("document.getElementById('numbers').hidden"))
            for k, body in enumerate(trajectory[4]):
                # The mouse points beside the centre, where the lines of contact begin.
                x, y = self.pixel_of(body)
                self.mouse("mouseMoved", x + 20, y)
                numbers = self.shown("numbers").replace("\u2212", "-")
                self.assertIn(f"body {k}", numbers)
                found = [float(x) for x in re.findall(r"-?\d+(?:\.\d+)?(?:e-?\d+)?", numbers)[1:]]
                np.testing.assert_allclose(found, state(body), rtol=2e-4, atol=1e-12)
            self.mouse("mouseMoved", 3, 3)
            self.assertIn("wall 0", self.shown("numbers"))

    def test_hovering_a_contact_shows_its_force(self):
        self.open()
        self.key("End")
        found = contacts[contacts["t"] == trajectory[-1]["t"][0]]
        self.assertEqual([(c["a"], c["b"]) for c in found], [("body:0", "wall:0")])
        x, y = self.pixel_of(found[0])
        centre = self.pixel_of(trajectory[-1][0])
        self.mouse("mouseMoved", 0.5 * (x + centre[0]), 0.5 * (y + centre[1]))
        numbers = self.shown("numbers")
        self.assertIn("contact of body 0 and wall 0", numbers)
        force = float(re.search(r"force\s+(\S+)", numbers)[1])
        self.assertAlmostEqual(force, found[0]["force"], delta=1e-3 * force)
        self.click(0.5 * (x + centre[0]), 0.5 * (y + centre[1]))
        self.mouse("mouseMoved", *self.pixel_of(trajectory[0][1]))
        self.mouse("mouseMoved", *self.pixel_of({"x": 1.2, "y": 0.0}))
        self.assertIn("contact", self.shown("numbers"))
        self.key("Home")
        self.assertTrue(tab.evaluate("document.getElementById('numbers').hidden"))
        self.key("End")
        self.mouse("mouseMoved", 0.5 * (x + centre[0]), 0.5 * (y + centre[1]))
        self.run_js("document.getElementById('contacts').click()")
        self.assertIn("body 0\n", self.shown("numbers"))

    def test_colours(self):
        self.open()
        x, y = self.pixel_of(trajectory[0][1])
        seen = set()
        for colour in ["speed", "spin", "orientation"]:
            self.run_js(f"(choice => {{ choice.value = '{colour}'; "
                        "choice.dispatchEvent(new Event('change')); })"
                        "(document.getElementById('colour'))")
            seen.add(tuple(self.colour_at(x, y)))
            self.assertGreater(
                tab.evaluate("document.getElementById('legend').offsetHeight"), 0)
            if colour == "spin":
                top = np.abs([[body["omega"] for body in bodies] for bodies in trajectory]).max()
                self.assertAlmostEqual(float(self.shown("high")), top, delta=5e-3 * top)
        self.assertEqual(len(seen), 3)

    def click(self, x, y):
        self.mouse("mouseMoved", x, y)
        for kind in ["mousePressed", "mouseReleased"]:
            self.mouse(kind, x, y, button="left", clickCount=1)

    def test_a_click_keeps_numbers(self):
        self.open()
        x, y = self.pixel_of(trajectory[0][1])
        self.click(x, y)
        self.mouse("mouseMoved", x + 1.2 * tab.evaluate("player.view.scale"), y)
        self.assertIn("body 1", self.shown("numbers"))
        self.key("Escape")
        self.assertTrue(tab.evaluate("document.getElementById('numbers').hidden"))

    def test_controls(self):
        self.open()
        last = len(trajectory) - 1
        for key, frame in [("ArrowRight", 1), ("ArrowRight", 2), ("ArrowLeft", 1), ("End", last),
                           ("ArrowRight", last), ("Home", 0), ("ArrowLeft", 0)]:
            self.key(key)
            self.assertEqual(tab.evaluate("player.place"), frame, key)
        self.run_js("(scrub => { scrub.value = 6.2; scrub.dispatchEvent(new Event('input')); })"
                    "(document.getElementById('scrub'))")
        self.assertEqual(self.shown("count"), f"frame 6 of {last}")
        for body in ["body 0", "body 1", "body 0"]:
            self.key("]")
            self.assertIn(body, self.shown("numbers"))

    def test_playing_goes_to_the_end(self):
        self.open()
        self.assertFalse(tab.evaluate("player.playing"))  # the reader prefers less motion
        self.run_js("document.getElementById('speed').value = '4'")
        self.key(" ")
        self.assertTrue(tab.evaluate("player.playing"))
        places = tab.evaluate("""(async () => {
          const places = [];
          while (player.playing) {
            places.push(player.place);
            await new Promise(requestAnimationFrame);
          }
          return [...places, player.place];
        })()""")
        self.assertEqual(places, sorted(places))
        self.assertGreater(len(set(places)), len(trajectory))  # between frames too
        self.assertEqual(places[-1], len(trajectory) - 1)

    def test_it_plays_by_itself_where_motion_is_welcome(self):
        self.open(still=False)
        self.assertTrue(tab.evaluate("player.playing"))

    def test_wheel_drag_and_fit(self):
        self.open()
        before = tab.evaluate("[player.view.scale, ...player.view.toPoint(300, 200)]")
        self.mouse("mouseWheel", 300, 200, deltaX=0, deltaY=-240)
        after = tab.evaluate("[player.view.scale, ...player.view.toPoint(300, 200)]")
        self.assertGreater(after[0], 1.2 * before[0])
        np.testing.assert_allclose(after[1:], before[1:], rtol=1e-9)
        self.mouse("mousePressed", 300, 200, button="left", buttons=1)
        self.mouse("mouseMoved", 340, 230, button="left", buttons=1)
        self.mouse("mouseReleased", 340, 230, button="left")
        np.testing.assert_allclose(tab.evaluate("player.view.toPoint(340, 230)"), before[1:],
                                   rtol=1e-9)
        self.key("0")
        self.assertAlmostEqual(tab.evaluate("player.view.scale"), before[0])

    def test_pixels_are_those_of_the_screen(self):
        self.open(scale=2)
        self.assertEqual(*tab.evaluate("(canvas => [canvas.width, 2 * canvas.clientWidth])"
                                       "(document.getElementById('canvas'))"))

    def test_a_page_that_was_cut_anywhere(self):
        text = page.read_text()
        cut = page.with_name("cut.html")
        start = text.rindex(FRAME)
        end = text.rindex("</script>")
        for length, is_whole in [(start + 5, False), (start + len(FRAME), False),
                                 (start + 200, False), (end - 1, False), (end, True),
                                 (end + 4, False), (len(text) - 1, True)]:
            cut.write_text(text[:length])
            self.open(cut)
            self.assertEqual(tab.evaluate("player.frames.length"),
                             len(trajectory) - (0 if is_whole else 1), length - start)
        first = text.index(FRAME)
        cut.write_text(text[:text.index("\n", first)])
        self.open(cut, still=False)
        self.assertEqual(self.shown("count"), "frame 0 of 0")
        self.assertFalse(tab.evaluate("player.playing"))
        self.assertTrue(tab.evaluate("document.getElementById('play').disabled"))
        cut.write_text(text[:first])
        self.open(cut)
        self.assertIn("no frame", self.shown("title"))

    def test_every_control_has_a_name(self):
        self.open()
        tree = tab.send("Accessibility.getFullAXTree")["nodes"]
        roles = {"button", "slider", "combobox", "checkbox", "image", "img"}
        controls = [(node["role"]["value"], node.get("name", {}).get("value", ""))
                    for node in tree if not node["ignored"] and node["role"]["value"] in roles]
        self.assertGreater(len(controls), 8)
        self.assertEqual([control for control in controls if not control[1]], [])


if __name__ == "__main__":
    unittest.main()
