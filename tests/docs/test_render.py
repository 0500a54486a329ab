"""Renders the pages of this build in a browser, and checks that planted faults are found.

test_render.py FOLDER-OF-PAGES CHROMIUM
"""

import pathlib
import shutil
import sys
import tempfile
import unittest

import browser
import render

sys.path[:0] = [str(pathlib.Path(__file__).parents[1]), str(pathlib.Path(__file__).parents[2] / "docs")]
import print_book
from tiers import full

SITE = pathlib.Path(sys.argv.pop(1)).resolve()
CHROMIUM = sys.argv.pop(1)


class ThisBuild(unittest.TestCase):
    maxDiff = None

    def test_every_tenth_page(self):
        pages = render.pages_of(SITE)[::10]
        self.assertGreater(len(pages), 20)
        self.assertEqual(render.render_all(pages, CHROMIUM), [])

    @full
    def test_every_page(self):
        self.assertEqual(render.render_all(render.pages_of(SITE), CHROMIUM), [])

    def test_search_finds_sections(self):
        wanted = {  # query -> the section that is first or second
            "lubrication": "chapter_00.html#chapter_00_gaps",
            "jump relation": "chapter_02.html#chapter_02_jump",
            "Goursat": "chapter_06.html#chapter_06_goursat",
            "null space": "chapter_04.html",
            "stresslet": "chapter_07.html#",
            "Stokes' paradox": "chapter_00.html#chapter_00_paradox",
            "reversibility": "chapter_00.html#chapter_00_linear",
            "no-slip": "chapter_00.html#chapter_00_no_slip",
            "Reynolds number": "chapter_00.html#chapter_00_reynolds",
            "alias": "chapter_01.html#chapter_01_aliasing",
            "curvature": "chapter_01.html#chapter_01_curve",
            "fredholm": "chapter_02.html#chapter_02_second_kind",
            "completed double layer": "chapter_02.html#chapter_02_completion",
            "mobility matrix": "chapter_00.html#chapter_00_forces",
            "resistance": "chapter_00.html#chapter_00_forces",
            "gauge length": "chapter_02.html#chapter_02_stokeslet",
            "net flux": "chapter_04.html#chapter_04_flux",
            "preconditioner": "chapter_05.html#chapter_05_blocks",
            "Arnoldi": "chapter_05.html#chapter_05_arnoldi",
            "barycentric": "chapter_06.html#chapter_06_barycentric",
            "near correction": "chapter_06.html#chapter_06_corrections",
            "Jeffery": "chapter_00.html#chapter_00_suspensions",
            "multipole expansion": "chapter_08.html#chapter_08_goursat",
            "Adams-Bashforth": "chapter_09.html#chapter_09_steps",
            "space-time interference": "chapter_10.html#chapter_10_gap",
            "complementarity": "chapter_11.html#chapter_11_problem",
            "Lemke": "chapter_11.html#chapter_11_lemke_path",
            "dissipation": "chapter_00.html#chapter_00_energy",
            "contact forces": "chapter_12.html#chapter_12_contact",
            "error estimate": "chapter_12.html#chapter_12_system",
            "automatic nodes": "chapter_12.html#chapter_12_nodes",
            "ParaView": "runs.html#runs_paraview",
            "stresslet()": "group__double__layer.html#",
            "null_space_velocity": "group__null__space.html#"}
        with browser.Browser(CHROMIUM) as chromium:
            tab = chromium.tab()
            for words, address in wanted.items():
                found = render.search_results(tab, SITE / "index.html", words)
                self.assertTrue(any(hit.startswith(address) for hit in found[:2]), (words, found))
            self.assertEqual(render.search_results(tab, SITE / "index.html", "nosuchword"), [])

    def test_search_by_keys(self):
        with browser.Browser(CHROMIUM) as chromium:
            tab = chromium.tab()
            tab.open((SITE / "index.html").as_uri())
            at = tab.evaluate("""(async () => {
                const press = key => document.activeElement.dispatchEvent(
                    new KeyboardEvent("keydown", {key, bubbles: true, cancelable: true}));
                const [field, list] = document.getElementById("book-search").children;
                press("/");
                while (!window.searchIndex) await new Promise(done => setTimeout(done, 50));
                document.activeElement.value = "trapezoid";
                field.dispatchEvent(new Event("input"));
                const links = [...list.querySelectorAll("a")];
                const at = ["ArrowDown", "ArrowDown", "ArrowUp"].map(key => {
                    press(key);
                    return links.indexOf(document.activeElement);
                });
                press("Escape");
                return [...at, list.childElementCount];
            })()""")
        self.assertEqual(at, [0, 1, 0, 0])

    def test_paper_shows_whole_formulas_and_open_tables(self):
        with browser.Browser(CHROMIUM) as chromium:
            tab = chromium.tab()
            tab.look(*render.DESKTOP)
            tab.open((SITE / "chapter_03.html").as_uri())
            tab.evaluate("new Promise(done => MathJax.Hub.Queue(done))")
            tab.send("Emulation.setDeviceMetricsOverride", width=718, height=1000, deviceScaleFactor=1,
                     mobile=False)
            tab.send("Emulation.setEmulatedMedia", media="print")
            formulas, cut, folded = tab.evaluate("""(() => {
                dispatchEvent(new Event("beforeprint"));
                const formulas = [...document.querySelectorAll(".MathJax_SVG_Display svg")];
                const cut = formulas.filter(svg => svg.getBoundingClientRect().right > 718);
                return [formulas.length, cut.length,
                        document.querySelectorAll("figure details:not([open])").length];
            })()""")
        self.assertGreater(formulas, 10)
        self.assertEqual((cut, folded), (0, 0))

    @full
    def test_printed_book_fits_on_its_paper_and_folds_nothing(self):
        with print_book.one_page(SITE) as page, browser.Browser(CHROMIUM) as chromium:
            tab = chromium.tab()
            tab.send("Emulation.setDeviceMetricsOverride", width=604, height=1000, deviceScaleFactor=1,
                     mobile=False)  # 160 mm
            tab.send("Emulation.setEmulatedMedia", media="print")
            errors = tab.open(page.as_uri())
            tab.evaluate("new Promise(done => MathJax.Hub.Queue(done))")
            width, details, folded, broken = tab.evaluate("""(() => {
                dispatchEvent(new Event("beforeprint"));
                const is_broken = output => {
                    const rows = output.textContent.replace(/\\n$/, "").split("\\n");
                    const style = getComputedStyle(output);
                    const height = output.clientHeight - 2 * parseFloat(style.paddingTop);
                    const fits = Math.max(...rows.map(row => row.length)) <= 100;
                    return fits && height > (rows.length + 0.5) * parseFloat(style.lineHeight);
                };
                return [document.documentElement.scrollWidth, document.querySelectorAll("details").length,
                        document.querySelectorAll("details:not([open])").length,
                        [...document.querySelectorAll("pre.fragment")].filter(is_broken).map(
                            output => output.textContent.slice(0, 40))];
            })()""")
        self.assertEqual(errors, [])
        self.assertLessEqual(width, 604)  # a wider page would be printed smaller as a whole
        self.assertGreater(details, 5)
        self.assertEqual(folded, 0)
        self.assertEqual(broken, [])  # rows of a table that take two lines

    def test_paper_keeps_hints_folded(self):
        with browser.Browser(CHROMIUM) as chromium:
            tab = chromium.tab()
            tab.open((SITE / "exercise_01_1.html").as_uri())
            opened, folded = tab.evaluate("""(() => {
                dispatchEvent(new Event("beforeprint"));
                return ["[open]", ":not([open])"].map(
                    state => document.querySelectorAll("details" + state).length);
            })()""")
        self.assertEqual(opened, 0)
        self.assertGreater(folded, 0)

    def test_claims_are_filtered_and_sorted(self):
        with browser.Browser(CHROMIUM) as chromium:
            tab = chromium.tab()
            tab.open((SITE / "claims.html").as_uri())
            shown, laws, ids = tab.evaluate("""(() => {
                const [field, label] = document.querySelector(".claim-filter").children;
                const texts = what => [...document.querySelectorAll(".claim:not([hidden]) " + what)]
                                        .map(element => element.textContent);
                field.value = "eigenvalues collocation";
                field.dispatchEvent(new Event("input", {bubbles: true}));
                const shown = texts("p");
                field.value = "";
                label.firstChild.click();
                const laws = texts("summary").map(text => text.split(" ")[0]);
                label.firstChild.click();
                return [shown, laws, texts(".badge").map(text => text.split(/[.:]/).slice(0, 2).join(" "))];
            })()""")
        self.assertTrue(shown and all("eigenvalues" in text for text in shown), shown)
        self.assertGreater(len(laws), 300)
        self.assertGreater(laws.index("value"), laws.index("error"))
        chapters = [int(name.split()[0]) for name in ids]
        self.assertEqual(chapters, sorted(chapters))


class PlantedFaults(unittest.TestCase):
    """A page with formulas, into which each test plants one fault."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.page = pathlib.Path(cls.folder.name).resolve() / "page.html"
        shutil.copytree(SITE / "mathjax", cls.page.parent / "mathjax")
        cls.chromium = browser.Browser(CHROMIUM)
        cls.tab = cls.chromium.tab()
        head = (SITE / "conventions.html").read_text().partition("<body>")[0]
        start = head.index("<script type=\"text/x-mathjax-config\">")
        cls.mathjax = head[start:head.index("MathJax.js\"></script>") + len("MathJax.js\"></script>")]

    @classmethod
    def tearDownClass(cls):
        cls.chromium.__exit__()
        cls.folder.cleanup()

    def problems(self, body):
        self.page.write_text(
            "<!DOCTYPE html><html><head><meta charset='utf-8'><meta name='viewport' "
            f"content='width=device-width'>{self.mathjax}</head><body>"
            f"<div class='contents'>{body}</div></body></html>")
        return " ".join(render.render(self.tab, self.page))

    def test_a_good_page(self):
        self.assertEqual(self.problems(
            r"<p>\( \frac12 \)</p><svg width='99' height='99'></svg><code>\(</code>"), "")

    def test_unknown_macro(self):
        self.assertIn("a formula is wrong", self.problems(r"<p>\( \nosuchmacro \)</p>"))

    def test_unbalanced_brace(self):
        self.assertIn("a formula is wrong", self.problems(r"<p>\( \frac{1 \)</p>"))

    def test_unknown_equation(self):
        self.assertIn("not on its page", self.problems(r"<p>\( \eqref{none} \)</p>"))

    def test_formula_that_is_left_alone(self):
        self.assertIn("TeX shows", self.problems(r"<p>\( x</p>"))

    def test_missing_picture(self):
        self.assertIn("a picture is missing", self.problems("<img src='none.svg' width=99 height=99>"))

    def test_picture_without_size(self):
        self.assertIn("a picture has no size", self.problems("<svg width='0' height='9'></svg>"))

    def test_console_error(self):
        self.assertIn("said so", self.problems("<script>console.error('said so')</script>"))

    def test_exception(self):
        self.assertIn("nosuchname", self.problems("<script>nosuchname()</script>"))

    def test_missing_script(self):
        self.assertIn("ERR_FILE_NOT_FOUND", self.problems("<script src='none.js'></script>"))

    def test_too_wide(self):
        self.assertIn("wider than the screen",
                      self.problems("<div style='width:500px'>a wide thing</div>"))


if __name__ == "__main__":
    unittest.main()
