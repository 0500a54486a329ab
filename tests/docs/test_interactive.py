"""Compares the numbers of the interactive figures with those of the libraries, and uses their controls.

test_interactive.py PROGRAM CHROMIUM
"""

import collections
import json
import re
import subprocess
import sys
import tempfile
import unittest

import browser
import interactive

PROGRAM = sys.argv.pop(1)
CHROMIUM = sys.argv.pop(1)
NUMBER = re.compile(r"-?\d+\.?\d*")


class Figures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        printed = subprocess.run([PROGRAM], check=True, capture_output=True, text=True).stdout
        cls.cases = [json.loads(line) for line in printed.splitlines()]
        cls.names = interactive.names()
        cls.folder = tempfile.TemporaryDirectory()
        cls.page = interactive.write_page(cls.folder.name, cls.names)
        cls.chromium = browser.Browser(CHROMIUM)
        cls.tab = cls.chromium.tab()

    @classmethod
    def tearDownClass(cls):
        cls.chromium.__exit__()
        cls.folder.cleanup()

    def setUp(self):
        self.tab.look(1000, 800)
        self.assertEqual(self.tab.open(self.page.as_uri()), [])

    def tearDown(self):
        self.assertEqual(self.tab.errors(), [])

    def test_the_libraries_know_every_figure_at_three_settings(self):
        counts = collections.Counter(case["figure"] for case in self.cases)
        self.assertEqual(sorted(counts), self.names)
        self.assertEqual(sorted(self.tab.evaluate("figures.names()")), self.names)
        self.assertGreaterEqual(min(counts.values()), 3)
        settings = {json.dumps([case["figure"], case["settings"]]) for case in self.cases}
        self.assertEqual(len(settings), len(self.cases))

    def test_numbers_equal_those_of_the_libraries(self):
        for case in self.cases:
            with self.subTest(figure=case["figure"], settings=case["settings"]):
                self.assertEqual(interactive.show(self.tab, case["figure"], case["settings"]),
                                 interactive.texts(self.tab, case["numbers"]))

    def test_a_wrong_digit_is_found(self):
        for case in self.cases:
            numbers = {name: value for name, value in case["numbers"].items() if value}
            wrong = {name: 1.001 * value for name, value in numbers.items()}
            shown = interactive.texts(self.tab, numbers)
            self.assertFalse(shown.items() & interactive.texts(self.tab, wrong).items())

    def test_stills_are_what_scripts_draw_first(self):
        for name, parts in interactive.stills(self.tab).items():
            kept = interactive.STILL.findall((interactive.FIGURES / f"{name}_figure.html").read_text())
            self.assertEqual(len(kept), 2)
            for drawn, still in zip(parts, kept):
                with self.subTest(figure=name):
                    self.assertEqual(NUMBER.sub("#", drawn), NUMBER.sub("#", still), "write the stills again")
                    for here, there in zip(NUMBER.findall(drawn), NUMBER.findall(still)):
                        self.assertAlmostEqual(float(here), float(there), delta=0.21)

    def press(self, key):
        for kind in ("rawKeyDown", "keyUp"):
            self.tab.send("Input.dispatchKeyEvent", type=kind, key=key, code=key,
                          windowsVirtualKeyCode={"ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39}[key])

    def shown(self, name):
        """Returns the drawing and the numbers that a figure shows."""
        return interactive.stills(self.tab)[name]

    def test_keys_move_sliders_and_handles(self):
        for name in self.names:
            count = self.tab.evaluate(f"""(window.controls = [...document.querySelectorAll(
                '[data-figure="{name}"] :is(input, button[aria-pressed="false"], .handle)')]).length""")
            self.assertGreater(count, 0)
            for k in range(count):
                with self.subTest(figure=name, control=k):
                    before = self.shown(name)
                    self.tab.evaluate(f"controls[{k}].focus()")
                    if self.tab.evaluate(f"controls[{k}].tagName") == "BUTTON":
                        self.tab.evaluate(f"controls[{k}].click()")
                    else:
                        for key in ("ArrowLeft", "ArrowUp"):
                            self.press(key)
                    if self.shown(name) == before:  # the control stood at its end
                        self.press("ArrowRight")
                    self.assertNotEqual(self.shown(name), before)

    def test_mouse_and_finger_drag_handles(self):
        for name in self.names:
            handles = self.tab.evaluate(f"""(window.handles = [...document.querySelectorAll(
                '[data-figure="{name}"] .handle')]).length""")
            for k in range(handles):
                for pointer in ("mouse", "touch"):
                    with self.subTest(figure=name, handle=k, pointer=pointer):
                        x, y = self.tab.evaluate(f"""(() => {{
                            handles[{k}].scrollIntoView({{block: "center"}});
                            const box = handles[{k}].lastChild.getBoundingClientRect();
                            return [box.x + box.width / 2, box.y + box.height / 2];
                        }})()""")
                        before = self.shown(name)
                        self.drag(pointer, [(x, y), (x + 9, y - 11), (x + 16, y - 21)])
                        self.assertNotEqual(self.shown(name), before)

    def drag(self, pointer, points):
        if pointer == "mouse":
            for kind, (x, y) in zip(["mousePressed", "mouseMoved", "mouseReleased"], points):
                self.tab.send("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", buttons=1, clickCount=1)
        else:
            for kind, (x, y) in zip(["touchStart", "touchMove"], points):
                self.tab.send("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": x, "y": y}])
            self.tab.send("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])


if __name__ == "__main__":
    unittest.main()
