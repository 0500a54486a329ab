"""Checks this tree against the rules of the house, and the checks against planted violations."""

import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

import house

ROOT = pathlib.Path(__file__).resolve().parents[2]
README = (ROOT / "README.md").read_text()


class ThisTree(unittest.TestCase):
    maxDiff = None

    def test_uses(self):
        self.assertEqual(house.use_violations(ROOT), [])
        self.assertEqual(house.folder_violations(ROOT), [])
        self.assertEqual(house.chapter_violations(ROOT), [])

    @unittest.skipUnless((ROOT / ".git").exists(), "not a git checkout")
    def test_files(self):
        self.assertEqual(house.file_violations(ROOT), [])

    def test_readme_names_what_exists(self):
        methods = re.findall(r"^\| \d\d \| `(\w+)` \|", README, re.MULTILINE)
        self.assertEqual(len(methods), 14)
        for method in methods:
            self.assertTrue((ROOT / "src" / method).is_dir(), method)

    def test_readme_shows_code_that_is_tested(self):
        project = ROOT / "tests/consumer/project"
        tested = {line.strip() for name in ["CMakeLists.txt", "one_library.cpp"]
                  for line in (project / name).read_text().splitlines()}
        whole, *parts = re.findall(r"^```(?:cmake|cpp)\n(.*?)^```", README,
                                   re.MULTILINE | re.DOTALL)
        self.assertEqual(whole, (project / "mobility.cpp").read_text())
        self.assertEqual(len(parts), 2)
        for line in "".join(parts).splitlines():
            self.assertIn(line.strip(), tested)


@unittest.skipUnless(shutil.which("git"), "needs git")
class PlantedTree(unittest.TestCase):
    """A small checkout that obeys the rules; every test breaks a single rule."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        subprocess.run(["git", "init", "--quiet", self.root], check=True)
        self.plant("src/trapezoid/curve.hpp", "#include <vector>\n")
        self.plant("src/trapezoid/curve.cpp", '#include "trapezoid/curve.hpp"\n')
        self.plant("src/trapezoid/CMakeLists.txt",
                   "stokesbook_library(trapezoid\n  SOURCES curve.cpp\n  LINKS GSL::gsl)\n")
        self.plant("src/double_layer/sum.cpp", '#include "trapezoid/curve.hpp"\n')
        self.plant("src/double_layer/CMakeLists.txt",
                   "stokesbook_library(double_layer\n  SOURCES sum.cpp\n  USES trapezoid)\n")

    def plant(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def test_obedient_tree_passes(self):
        self.assertEqual(house.use_violations(self.root), [])
        self.assertEqual(house.file_violations(self.root), [])

    def test_upward_include(self):
        self.plant("src/trapezoid/curve.cpp", '#include "double_layer/sum.hpp"\n')
        self.assertIn("src/trapezoid/curve.cpp includes from double_layer, "
                      "which trapezoid may not use", house.use_violations(self.root))

    def test_upward_link(self):
        self.plant("src/trapezoid/CMakeLists.txt",
                   "stokesbook_library(trapezoid SOURCES curve.cpp USES double_layer)\n")
        self.assertIn("src/trapezoid/CMakeLists.txt links double_layer, "
                      "which trapezoid may not use", house.use_violations(self.root))

    def test_include_without_link(self):
        self.plant("src/double_layer/CMakeLists.txt",
                   "stokesbook_library(double_layer SOURCES sum.cpp)\n")
        self.assertEqual(house.use_violations(self.root),
                         ["src/double_layer includes from trapezoid, but its CMakeLists.txt does not "
                          "list trapezoid in USES"])

    def test_link_without_include(self):
        self.plant("src/double_layer/sum.cpp", "")
        self.assertEqual(house.use_violations(self.root),
                         ["src/double_layer/CMakeLists.txt lists trapezoid in USES, but nothing is "
                          "included from trapezoid"])

    def test_include_without_room(self):
        self.plant("src/trapezoid/curve.cpp", '#include "curve.hpp"\n')
        self.assertEqual(house.use_violations(self.root),
                         ['src/trapezoid/curve.cpp includes a file without its room; write '
                          '"room/file.hpp"'])

    def test_unknown_room(self):
        self.plant("src/attic/box.hpp", "")
        self.assertEqual(house.use_violations(self.root),
                         ["src/attic is not in the table of rooms, MAY_USE"])

    def test_order_of_chapters(self):
        said = "**Builds on:** @ref chapter_01. **Library:** @ref x."
        for name in ["01_fmm", "02_suspension", "03_preconditioning"]:
            self.plant(f"chapters/{name}/chapter.md", said.replace("_01", "_00") if "01" in name else said)
        self.assertEqual(house.chapter_violations(self.root), [])
        self.plant("chapters/02_suspension/chapter.md", said.replace("_01", "_01 to @ref chapter_03"))
        self.assertEqual(house.chapter_violations(self.root),
                         ["02_suspension builds on chapter 03, which is not earlier"])
        self.plant("chapters/02_suspension/chapter.md", said)
        self.plant("chapters/04_krylov/chapter.md", said)
        self.assertEqual(house.chapter_violations(self.root),
                         ["suspension may use krylov, whose chapter is read later",
                          "preconditioning may use krylov, whose chapter is read later"])

    def test_folders_of_suspension(self):
        self.plant("src/suspension/nodes/fill.cpp", '#include "suspension/nodes/random_fill.hpp"\n'
                                                    '#include "suspension/bodies/gaps.hpp"\n'
                                                    '#include "stiv/near_pairs.hpp"\n')
        self.assertEqual(house.folder_violations(self.root), [])
        self.plant("src/suspension/nodes/random_fill.hpp", '#include "suspension/solver/solver.hpp"\n')
        self.plant("src/suspension/plan.hpp", "")
        for k in range(21):
            self.plant(f"src/suspension/motion/step_{k}.cpp", "")
        self.assertEqual(house.folder_violations(self.root), [
            "src/suspension/nodes/random_fill.hpp includes suspension/solver/solver.hpp, "
            "which nodes may not use",
            "src/suspension/plan.hpp is in suspension, which is not in FOLDERS_OF_SUSPENSION",
            "src/suspension/motion has 21 files, more than 20"])

    def test_machine_path(self):
        for folder in ["work", "root", "home", "tmp"]:
            path = "/" + folder + "/scene.toml"  # in pieces: the check also reads this file
            self.plant("src/trapezoid/curve.cpp", f'// \n const char* scene = "{path}";\n')
            self.assertEqual(house.file_violations(self.root),
                             [f"src/trapezoid/curve.cpp:2 contains a path of one machine, {path[:-5]}"])

    def test_paths_of_no_machine(self):
        self.plant("README.md", "https://example.org/home/page out/work/x ${prefix}/tmp/x\n")
        self.assertEqual(house.file_violations(self.root), [])

    def test_build_output(self):
        for name in ["build/release/build.ninja", "src/trapezoid/curve.o",
                     "tests/house/__pycache__/house.pyc", "CMakeCache.txt"]:
            self.plant(name, "")
            self.assertEqual(house.file_violations(self.root),
                             [f"{name} is a build output, which must not be committed"])
            (self.root / name).unlink()

    def test_program(self):
        self.plant("stokes", "\x7fELF\x02\x01\x01")
        self.assertEqual(house.file_violations(self.root),
                         ["stokes is a build output, which must not be committed"])


if __name__ == "__main__":
    unittest.main()
