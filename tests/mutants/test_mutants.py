"""Checks which defects mutants.py plants, and how it interprets the results of the tests."""

import contextlib
import io
import json
import pathlib
import subprocess
import tempfile
import unittest

import defects
import mutants

ROOT = pathlib.Path(__file__).resolve().parents[2]


def planted(code):
    """Returns all defects of a function's body, as kind -> set of bodies with a defect planted."""
    text = f"void f() {{ {code} }}"
    found = {}
    for defect in defects.Source(text).defects():
        found.setdefault(defect.kind, set()).add(defect.planted(text)[11:-2])
    return found


class Kinds(unittest.TestCase):
    def check(self, code, **expected):
        found = planted(code)
        for kind, codes in expected.items():
            self.assertEqual(found.pop(kind, set()), set(codes), kind)
        return found

    def check_all(self, code, **expected):
        self.assertEqual(self.check(code, **expected), {})

    def test_signs(self):
        self.check("return -a + b;", sign=["return a + b;", "return -a - b;"])
        self.check("x -= y;", sign=["x += y;"])
        self.check("return {-1.0, f(-x)};", sign=["return {1.0, f(-x)};", "return {-1.0, f(x)};"])

    def test_factors(self):
        self.check_all("return 6;", factor=["return 12;", "return 3;"])
        self.check_all("return 0.5;", factor=["return 1.0;", "return 0.25;"])
        self.check_all("return 1e-14;", factor=["return 2e-14;", "return 5e-15;"])
        self.check_all("return 1;", factor=["return 2;", "return 0;"])
        self.check_all("return 0.0;", factor=["return 1.0;"])
        self.check_all("return 1024LL;", factor=["return 2048LL;", "return 512LL;"])
        self.check_all("return 1'000u;", factor=["return 2000u;", "return 500u;"])

    def test_operators(self):
        self.check("return a * b / c;", operator=["return a / b / c;", "return a * b * c;"])
        self.check("x *= y;", operator=["x /= y;"])

    def test_pointers_and_references_are_no_operators(self):
        self.check_all("const double* p = &x;")
        self.check_all("auto&& y = *p;")

    def test_comparisons(self):
        self.check_all("return a < b;", comparison=["return a <= b;", "return a > b;"])
        self.check_all("return a >= b;", comparison=["return a > b;", "return a <= b;"])
        self.check_all("return a == b;", comparison=["return a != b;"])

    def test_logic(self):
        self.check_all("return a && !b || c;", logic=[
            "return a || !b || c;", "return a && b || c;", "return a && !b && c;"])

    def test_indices(self):
        self.check_all("return x[i][j];", index=["return x[(i) + 1][j];", "return x[(i) - 1][j];",
                                                 "return x[i][(j) + 1];", "return x[i][(j) - 1];"])
        self.check_all("return m.col(i);",
                       index=["return m.col((i) + 1);", "return m.col((i) - 1);"])

    def test_captures_bindings_and_arrays_are_no_indices(self):
        for code in ["return [k](int i) { return i; };", "const auto& [a, b] = pair;",
                     "[[maybe_unused]] bool b;", 'return table["key"];']:
            self.assertNotIn("index", planted(code), code)
        self.check_all("double x[n];")

    def test_terms(self):
        self.check("return a * b + f(c - d);", term=[
            "return  f(c - d);", "return a * b ;", "return a * b + f(c );",
            "return a * b + f(- d);"])
        self.check("return x < a + b;", term=["return x < a ;", "return x <  b;"])
        self.check("y = static_cast<int>(a) + b;", term=["y = static_cast<int>(a) ;", "y =  b;"])

    def test_statements(self):
        for code in ["x = 3;", "x[i].y += f(z);", "a.b(c).d();", "std::swap(a, b);", "++i;",
                     "*p = q;", "out << text;", "this->x = y;", "g<int>(x);", "i++;"]:
            self.check(code, statement=["{}"])
            self.check(f"if (c) {code}", statement=["if (c) {}"])
            self.check(f"else {code}", statement=["else {}"])

    def test_declarations_and_jumps_are_not_dropped(self):
        for code in ["int x = 3;", "std::vector<int> x = f();", "const T& x = y;", "T& x = y;",
                     "T* x = y;", "T x{3};", "T x(3);", "T::U x;", "return f();", "throw f();",
                     "break;", "auto [a, b] = f();", "using T = U;", "for (;;) {}"]:
            self.assertNotIn("statement", planted(code), code)
        self.assertEqual(defects.Source("class A { A(int a); void f(int, int); };").defects(), [])
        text = "namespace n { int f(T a, U b); T x(U a, V b) {} }"
        self.assertEqual(defects.Source(text).defects(), [])

    def test_dropped_lines_stay_in_number(self):
        self.check("f(\na);", statement=["{}\n"])
        self.check("return a +\nb;", term=["return a \n;", "return \nb;"])

    def test_arguments(self):
        self.check("return f(a, g(b, c), a);", arguments=[
            "return f(g(b, c), a, a);", "return f(a, a, g(b, c));", "return f(a, g(c, b), a);"])
        self.check("return {a, b};", arguments=["return {b, a};"])
        self.check("T x{a, b};", arguments=["T x{b, a};"])
        self.check("return f(p<int, int>(x), y);", arguments=["return f(y, p<int, int>(x));"])
        self.check('return {{"a", b}, c};', arguments=[
            'return {c, {"a", b}};', 'return {{b, "a"}, c};'])
        self.check('return {{"a", b}, {"c", d}};', arguments=[
            'return {{b, "a"}, {"c", d}};', 'return {{"a", b}, {d, "c"}};'])
        for code in ["f(a, a);", "std::min(a, b);", "return T{.a = 1, .b = 2};", 'f("a", "b");',
                     "return [=](int i, int j) {};", "for (i = 0, j = 1; i < j;) {}"]:
            self.assertNotIn("arguments", planted(code), code)

    def test_functions(self):
        self.check("return std::sin(x);", function=["return std::cos(x);"])
        self.check("return std::min<int>(x, min);", function=["return std::max<int>(x, min);"])
        self.check("return z.real() + z.imag;", function=["return z.imag() + z.imag;"])

    def test_increments_and_truths(self):
        self.check("++i;", increment=["--i;"])
        self.check("return true;", truth=["return false;"])

    def test_nothing_where_no_code_is(self):
        for text in ["#include <a-1.hpp>", "#define X 1 \\\n + 2", "// x = 1 + 2;", "/* 1\n+ 2 */",
                     'const char* s = "1 + 2";', 'auto s = R"x(1 + 2 "))x";', "char c = '1';",
                     "static_assert(1 + 1 == 2);", "template <int n = 3> class A;",
                     "array<int, 3> a;", "A(int) = default;", "virtual void f() const = 0;",
                     "using T = A<1>;",
                     "enum class E { a, b };", "bool operator==(const A&, const A&);"]:
            self.assertEqual(defects.Source(text).defects(), [], text)
        self.assertEqual(planted('throw E("at " + to_string(a + 1));'), {})

    def test_all_of_src(self):
        for path, text in mutants.sources(ROOT).items():
            source = defects.Source(text)
            for i, token in enumerate(source.tokens):
                self.assertTrue(token.text not in set("()[]{}") or i in source.partner, path)
            for defect in source.defects():
                with self.subTest(path=path, defect=defect):
                    other = defect.planted(text)
                    self.assertNotEqual(other, text)
                    self.assertEqual(other.count("\n"), text.count("\n"))


class Campaigns(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        (self.root / "src").mkdir()
        (self.root / "src/a.cpp").write_text("int f(int x) {\n  return 3 * x + 4;\n}\n")
        (self.root / "src/b.hpp").write_text("inline int g(int x) {\n  return x < 5 ? -x : x;\n}\n")
        self.file = self.root / "out/results.jsonl"

    def campaign(self, count, only=()):
        return mutants.Campaign(mutants.sources(self.root), 1, count, self.file, only)

    def test_draws_are_the_seed_s(self):
        texts = mutants.sources(self.root)
        one, same, other = (list(mutants.draws(texts, seed)) for seed in (1, 1, 2))
        self.assertEqual(one, same)
        self.assertNotEqual(one, other)
        self.assertEqual(sorted(one), sorted(other))
        self.assertEqual(len(set(one)), len(one))

    def finish(self, campaign, taken, result):
        number, draw = taken
        with contextlib.redirect_stdout(io.StringIO()):
            campaign.finish(number, draw, (result, "", ""), 0.0)

    def test_a_discarded_defect_is_replaced(self):
        campaign = self.campaign(2)
        first, second = campaign.take(), campaign.take()
        self.finish(campaign, second, "not compiled")
        third = campaign.take()
        self.finish(campaign, third, "caught")
        self.finish(campaign, first, "survived")
        self.assertIsNone(campaign.take())
        self.assertEqual([first[0], second[0], third[0]], [0, 1, 2])

    def test_a_later_run_continues(self):
        campaign = self.campaign(1)
        self.finish(campaign, campaign.take(), "caught")
        self.assertIsNone(self.campaign(1).take())
        self.assertEqual(self.campaign(2).take()[0], 1)

    def test_chosen_ones_are_tried_again(self):
        campaign = self.campaign(3)
        for result in ("survived", "caught", "survived"):
            self.finish(campaign, campaign.take(), result)
        campaign = self.campaign(3, [2])
        self.finish(campaign, campaign.take(), "caught")
        self.assertIsNone(campaign.take())
        self.assertEqual([self.campaign(3).results[i]["result"] for i in range(3)],
                         ["survived", "caught", "caught"])

    def test_results_of_another_src_are_refused(self):
        self.campaign(1)
        (self.root / "src/a.cpp").write_text("int f() { return 1; }\n")
        with self.assertRaises(SystemExit):
            self.campaign(1)

    def test_summary(self):
        campaign = self.campaign(3)
        for result in ("survived", "equivalent", "caught", "caught"):
            self.finish(campaign, campaign.take(), result)
        text = mutants.summary(list(campaign.results.values()))
        self.assertIn("drawn 4: not compiled 0, equivalent 1, caught 2, survived 1", text)
        self.assertIn("caught: 66.7 % (95 % interval: 20.8 to 93.9 %)", text)
        self.assertEqual(text.count("\n@@ "), 1)


class Answers(unittest.TestCase):
    def reason(self, script, **properties):
        with tempfile.TemporaryDirectory() as folder:
            test = mutants.Test({"name": "t", "command": ["sh", "-c", script], "properties": [
                {"name": name, "value": value} for name, value in properties.items()]},
                pathlib.Path(folder))
            test.slack = (1, 2)
            test.seconds = [0, 0]
            return test.reason_to_fail(pathlib.Path(folder) / "scratch")

    def test_passed_or_failed(self):
        self.assertEqual(self.reason("exit 0"), "")
        self.assertEqual(self.reason("echo why; exit 3"), "exit code 3: why")
        self.assertEqual(self.reason('test "$A" = b', ENVIRONMENT=["A=b"]), "")
        self.assertEqual(self.reason('test "$PWD" = /', WORKING_DIRECTORY="/"), "")

    def test_output(self):
        self.assertEqual(self.reason("echo good; exit 1", PASS_REGULAR_EXPRESSION=["go+d"]), "")
        self.assertEqual(self.reason("echo bad", PASS_REGULAR_EXPRESSION=["go+d"]), "other output")

    def test_the_first_error_ends_it(self):
        line = 'a.cpp(3): error: in "suite/case": check x == 1 has failed'
        self.assertEqual(self.reason(f"echo '{line}'; sleep 60"), line)

    def test_too_long(self):
        self.assertEqual(self.reason("while :; do :; done"), "takes too long")
        self.assertEqual(self.reason("sleep 60"), "takes too long")

    def test_unknown_properties_are_refused(self):
        with self.assertRaises(SystemExit):
            self.reason("exit 0", WILL_FAIL=True)


class SmallTree(unittest.TestCase):
    """A tree of one library and one test, which CMake builds in the same way as the book."""

    FILES = {
        "CMakeLists.txt": """
            cmake_minimum_required(VERSION 3.25)
            project(small LANGUAGES CXX)
            set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
            enable_testing()
            add_library(room src/room/f.cpp)
            target_include_directories(room PUBLIC src/room)
            add_executable(test_room test.cpp)
            target_link_libraries(test_room room)
            add_test(NAME room COMMAND test_room)
            add_test(NAME no_program COMMAND true)
            set_tests_properties(room no_program PROPERTIES LABELS as_shipped)""",
        "CMakePresets.json": json.dumps({"version": 6, "configurePresets": [{
            "name": "mutants", "generator": "Ninja", "binaryDir": "${sourceDir}/build/mutants",
            "cacheVariables": {"BUILD_SHARED_LIBS": "ON", "CMAKE_LINK_DEPENDS_NO_SHARED": "ON"}}]}),
        "src/room/f.hpp": "int f(int x);\ninline int g(int x) { return x + 1; }\n",
        "src/room/f.cpp": "int f(int x) {\n  if (x > 100) return 7;\n  return 2 * x;\n}\n",
        "test.cpp": '#include "f.hpp"\nint main() { return f(g(3)) == 8 ? 0 : 1; }\n',
        ".gitignore": "/build/\n"}

    def test_results(self):
        with tempfile.TemporaryDirectory() as name:
            root = pathlib.Path(name)
            for file, text in self.FILES.items():
                (root / file).parent.mkdir(parents=True, exist_ok=True)
                (root / file).write_text(text)
            subprocess.run(["git", "init", "-q", root], check=True)
            copy = mutants.Copy(root, root / "build/mutants/0")
            with contextlib.redirect_stdout(io.StringIO()):
                seconds = copy.prepare(1, None)
            self.assertEqual([test.name for test in copy.tests], ["room"])
            for file, old, new, expected in [
                    ("f.cpp", "2 * x", "3 * x", "caught"),
                    ("f.cpp", "100", "50", "survived"),
                    ("f.cpp", "2 * x", "2  * x", "equivalent"),
                    ("f.cpp", "2 * x", "2 * y", "not compiled"),
                    ("f.hpp", "+ 1", "- 1", "caught"),
                    ("f.hpp", "f(int x)", "f(int y)", "equivalent")]:
                start = self.FILES[f"src/room/{file}"].index(old)
                defect = defects.Defect("", start, start + len(old), new)
                self.assertEqual(copy.result(f"src/room/{file}", defect)[0], expected, new)
                self.assertEqual((copy.tree / "src/room" / file).read_text(),
                                 self.FILES[f"src/room/{file}"])
            self.assertIn("no work to do", mutants.run(["ninja", "-C", copy.build]))
            # A second preparation has nothing to build, and keeps the measured seconds.
            self.assertEqual(mutants.Copy(root, copy.folder).prepare(1, None), seconds)


if __name__ == "__main__":
    unittest.main()
