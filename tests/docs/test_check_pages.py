"""Tests the checks of the pages: they must find planted faults, and pass the book."""

import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs"))
import check_pages  # noqa: E402
import glossary  # noqa: E402
import make_pages  # noqa: E402
import number_pages  # noqa: E402
import print_book  # noqa: E402
import search_index  # noqa: E402

TITLE = "# A title {#chapter_01}\n\n"


def chapter(text):
    return check_pages.chapter_violations("chapter.md", TITLE + text)


class ThisBook(unittest.TestCase):
    """The build of the pages checks the same, but only the full tier builds them."""

    def test_sources(self):
        self.assertEqual(check_pages.source_violations(ROOT), [])

    def test_pages_refer_to_their_figures_and_are_brief(self):
        for path in [*ROOT.glob("chapters/*/chapter.md"), *ROOT.glob("docs/*.md")]:
            with self.subTest(page=path):
                self.assertEqual(number_pages.faults(path.read_text()), [])


class Chapters(unittest.TestCase):
    def assert_found(self, text, *words):
        violations = chapter(text)
        self.assertEqual(len(violations), 1, violations)
        for word in words:
            self.assertIn(word, violations[0])

    def test_good_text(self):
        self.assertEqual(chapter(
            "With N = 32 nodes and a radius of 0.5, in 2 steps, to `1e-12` or \\f$ 10^{-12} \\f$.\n\n"
            "## Part 1 {#chapter_01_part}\n\n### Part of it {#chapter_01_sub}\n\n"
            "@snippet chapters/01_trapezoid/program.cpp sum\n\nThe error is @val_01_error_32.\n\n"
            "- a list\n\n      that goes on\n\n```sh\n# no heading, and 1e-3\n./stokes docs\n```\n"), [])

    def test_no_anchor(self):
        self.assertIn("the first line", check_pages.chapter_violations("c.md", "# A\n\nText.\n")[0])

    def test_fenced_code(self):
        self.assert_found("```cpp\nint i;\n```\n", "chapter.md:3", "@snippet")
        self.assert_found("```\nint i;\n```\n", "chapter.md:3", "@snippet")

    def test_indented_code(self):
        self.assert_found("Text.\n\n    int i;\n", "chapter.md:5", "@snippet")

    def test_code_commands(self):
        self.assert_found("@code{.cpp} int i; @endcode\n", "@snippet")
        self.assert_found("<pre>int i;</pre>\n", "@snippet")

    def test_typed_results(self):
        for typed in ["1e-12", "1.5E-3", "10^-12", "10<sup>-12</sup>", "10⁻¹²", "0.1234", "12.345",
                      "47 iterations", "2.5 s", "30 ms"]:
            self.assert_found(f"The error\nis {typed}, say.\n", "chapter.md:4", "typed result")

    def test_results_that_may_be_items(self):
        self.assert_found("It takes\n\\val_01_error_32. Others take more.\n", "chapter.md:4", "list")
        self.assertEqual(chapter("It takes\n\\val_01_error_32, say.\n"), [])
        self.assert_found("From a gap of\n2. The end.\n", "chapter.md:4", "item of a list")
        self.assertEqual(chapter("Steps:\n\n1. The one.\n2. The other.\n"), [])

    def test_digits_that_are_significant(self):
        for definition in "0.125", "0.0125", "0.001", "1.25", "12.5", "100", "0.5":
            self.assertEqual(chapter(f"A radius\nof {definition}.\n"), [])
        for typed in "0.1250", "0.01234", "1.000", "10.25":
            self.assert_found(f"The error\nis {typed}.\n", "chapter.md:4", "typed result")

    def test_typed_result_in_a_formula(self):
        self.assert_found("\\f$ 1.3 \\cdot 10^{-12} \\f$\n", "typed result")
        self.assert_found("\\f[ x = 4.32\\times10^{-3} \\f]\n", "typed result")

    def test_empty_heading(self):
        self.assert_found("## One\n\n## Two\n\nText.\n", "chapter.md:3", "nothing under it")
        self.assert_found("Text.\n\n## Last\n", "chapter.md:5", "nothing under it")
        self.assert_found("Text.\n\n### Deep\n\n## Next\n\nText.\n", "chapter.md:5")
        # A fence ends with as many marks as it began with.
        self.assert_found("````sh\n```\n````\n\n## One\n\n## Two\n\nText.\n", "chapter.md:7")
        self.assertEqual(chapter("## One\n\n````sh\n```\n# no heading\n# nor this\n````\n"), [])

    def test_order_of_equations(self):
        first, second = "\\f[ x = 1 \\tag{01.1} \\f]\n", "\\f[ x = 2 \\tag{01.2} \\f]\n"
        self.assertEqual(chapter(first + second), [])
        self.assert_found(second, "chapter.md:3", "this is equation 1")
        self.assert_found(first + first, "chapter.md:4", "this is equation 2")

    def test_text_of_link_on_one_line(self):
        self.assert_found("See (@ref claim_01_2 \"claim\n01_2\").\n", "chapter.md:3", "one line")
        self.assertEqual(chapter("See (@ref claim_01_2 \"claim 01_2\") and \"a quotation\nhere\".\n"),
                         [])

    def test_unfinished(self):
        for mark in ["TODO", "FIXME", "???"]:
            self.assert_found(f"Text. {mark}\n", "chapter.md:3", mark)


class Accuracy(unittest.TestCase):
    def found(self, comment):
        return check_pages.unproved_accuracy("sum.hpp", comment + "double sum();\n")

    def test_claim(self):
        self.assertEqual(self.found("/// @par Accuracy  order 2: @ref claim_01_2\n"), [])
        self.assertEqual(self.found("/// @par Accuracy  order 2, as\n/// @ref claim_01_2 says\n"
                                    "/// @par Cost  1\n"), [])

    def test_no_claim(self):
        for comment in ["/// @par Accuracy  order 2\n",
                        "/// Adds.\n/// @par Accuracy  order 2\n/// @sa @ref claim_01_2\n"]:
            self.assertEqual(len(self.found(comment)), 1, comment)


class PublicApi(unittest.TestCase):
    MEMBER = """<memberdef kind="function" id="f" prot="public"><type>double</type><name>f</name>
        <qualifiedname>stokesbook::f</qualifiedname><argsstring>(double x)</argsstring>
        <param><type>double</type><declname>x</declname></param>
        <briefdescription>{brief}</briefdescription><detaileddescription>{details}
        </detaileddescription></memberdef>"""
    PARAMETER = """<para><parameterlist kind="param"><parameteritem><parameternamelist>
        <parametername>x</parametername></parameternamelist><parameterdescription>{}
        </parameterdescription></parameteritem></parameterlist></para>"""
    RESULT = '<para><simplesect kind="return"><para>a number</para></simplesect></para>'

    def violations(self, member, kind="namespace", prot="public"):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "x.xml").write_text(
                f'<doxygen><compounddef kind="{kind}" prot="{prot}"><compoundname>stokesbook'
                f'</compoundname><sectiondef>{member}</sectiondef></compounddef></doxygen>')
            return check_pages.api_violations(pathlib.Path(folder))

    def function(self, brief="Computes.", parameter="a number", result=RESULT):
        return self.MEMBER.format(brief=brief, details=self.PARAMETER.format(parameter) + result)

    def test_documented(self):
        self.assertEqual(self.violations(self.function()), [])

    def test_undocumented(self):
        self.assertEqual(self.violations(self.MEMBER.format(brief="", details="")),
                         ["stokesbook::f lacks a description"])

    def test_tag_that_is_left_out(self):
        self.assertEqual(self.violations(self.MEMBER.format(brief="Computes.", details="")), [])

    def test_tag_without_text(self):
        self.assertEqual(self.violations(self.function(parameter="")),
                         ["stokesbook::f lacks a text after @param x"])
        self.assertEqual(self.violations(self.function(
            result='<para><simplesect kind="return"><para/></simplesect></para>')),
            ["stokesbook::f lacks a text after @return"])

    def test_text_taken_for_a_title(self):
        paragraph = '<para><simplesect kind="par"><title>Cost{}</title>{}</simplesect></para>'
        for title, text, violations in [("", "<para>O(N)</para>", 0), (" O(N)", "<para/>", 1)]:
            member = self.function(result=self.RESULT + paragraph.format(title, text))
            self.assertEqual(len(self.violations(member)), violations, title)

    def test_undocumented_enumerator(self):
        self.assertEqual(self.violations(
            '<memberdef kind="enum" id="e" prot="public"><name>E</name><qualifiedname>stokesbook::E'
            '</qualifiedname><briefdescription>An enum.</briefdescription><enumvalue><name>a</name>'
            '<briefdescription/></enumvalue></memberdef>'),
            ["stokesbook::E lacks a description of a"])

    def test_undocumented_type(self):
        self.assertIn("stokesbook lacks a description",
                      self.violations(self.function(), kind="struct"))

    def test_nothing_read(self):
        self.assertIn("nothing", self.violations(self.function(), kind="struct", prot="private")[0])


class Html(unittest.TestCase):
    def violations(self, body):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "index.html").write_text(f"<html><body>{body}</body></html>")
            (folder / "other.html").write_text('<a id="here"></a>')
            return check_pages.html_violations(folder)

    def test_good_page(self):
        self.assertEqual(self.violations(
            '<a href="other.html#here">x</a> <a href="#top" id="top">y</a> <a href="https://a.org/b">'
            r'z</a> \( \frac12 \) \[ \eta \] <code>\ref</code> <pre>@ref</pre>'), [])

    def test_broken_link(self):
        self.assertIn("does not exist", self.violations('<a href="none.html">x</a>')[0])
        self.assertIn("does not exist", self.violations('<img src="none.svg">')[0])

    def test_broken_anchor(self):
        self.assertIn("no such anchor", self.violations('<a href="other.html#there">x</a>')[0])
        self.assertIn("no such anchor", self.violations('<a href="#there">x</a>')[0])

    def test_leaks(self):
        for leak in [r"\val_01_error_32", "@ref", "@snippet", r"\f$", r"\_form", "???"]:
            self.assertEqual(self.violations(f"<p>a {leak} b</p>"), [f"index.html: shows {leak}"])

    def test_folded_text_without_summary(self):
        self.assertEqual(self.violations("<details><summary>a</summary>b</details>"), [])
        self.assertEqual(len(self.violations("<details>b</details>")), 1)

    def test_no_pages(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(len(check_pages.html_violations(pathlib.Path(folder))), 1)


class Numbers(unittest.TestCase):
    FILES = {"a_x_figure.html": "<svg><title>Errors</title></svg>",
             "a_x_table.html": "<table>\n<caption>Errors. Error: relative.</caption></table>",
             "a_y_table.html": "<table><caption>Others?</caption></table>",
             "a_y_work_figure.html": "<svg><title>W: error against a</title></svg>"
                                     "<svg><title>W: error against b</title></svg>"}
    FIRST = ("# One {#chapter_01}\n\nText, see \\see_a_x_figure and\n\\see_a_x_table. 12 words\n\n"
             "@htmlinclude a_x_figure.html\n\n@htmlinclude a_x_table.html\n\n## Part {#chapter_01_part}\n\n"
             "```sh\n## no heading\n```\n\n@htmlinclude a_y_table.html\n")
    SECOND = ("# Two {#chapter_02}\n\n@htmlinclude a_y_work_figure.html\n\nSee \\see_a_x_figure.\n")

    def pages(self, *texts):
        sections = {"a_x_figure.html": ("Errors", "study_a.html#study_a_x")}
        return number_pages.numbered_pages(list(texts), self.FILES.get, sections)

    def test_figures_and_tables_are_numbered_by_themselves(self):
        pages = self.pages(self.FIRST, self.SECOND)
        figure = pages["chapter_01_a_x_figure.html"]
        self.assertIn('<figure class="picture" id="a_x_figure">', figure)
        self.assertIn("<b>Figure 01.1.</b> Errors. <a", figure)
        self.assertIn('href="study_a.html#study_a_x"', figure)
        self.assertIn("<b>Table 01.2.</b> Others?</figcaption>", pages["chapter_01_a_y_table.html"])
        self.assertIn("<b>Figure 02.1.</b> W: error against a; error against b.<",
                      pages["chapter_02_a_y_work_figure.html"])

    def test_a_table_below_its_figure_is_folded(self):
        pages = self.pages(self.FIRST)
        self.assertIn("<summary>Table 01.1: the numbers of figure 01.1</summary>",
                      pages["chapter_01_a_x_table.html"])
        self.assertNotIn("<caption>", pages["chapter_01_a_x_table.html"])
        self.assertNotIn("<details>", pages["chapter_01_a_y_table.html"])

    def test_references(self):
        pages = self.pages(self.FIRST, self.SECOND)
        link = '<a href="chapter_01.html#a_x_figure">figure 01.1</a>'
        self.assertIn(f"see {link} and\n", pages["chapter_01.md"])
        self.assertIn(f"See {link}.\n", pages["chapter_02.md"])
        begun = self.pages(self.FIRST, self.SECOND.replace("See \\see_", "New. \\see_"))
        self.assertIn(f"New. {link.replace('figure 01', 'Figure 01')}.\n", begun["chapter_02.md"])
        self.assertEqual(number_pages.faults(self.FIRST), ["the text does not refer to a_y_table"])
        self.assertEqual(number_pages.faults("# One {#chapter_01}\n" + "word " * 4498), [])
        self.assertEqual(number_pages.faults("# One {#chapter_01}\n" + "word " * 4500),
                         ["4501 words of prose; a chapter has at most 4500"])
        with self.assertRaises(SystemExit):
            self.pages(self.SECOND)

    def test_quotations_link_to_their_files(self):
        text = "# One {#chapter_01}\n\n@snippet src/a/b.cpp part\n\nText.\n"
        self.assertEqual(number_pages.quoted_files(text), {"src/a/b.cpp"})
        page = self.pages(text)["chapter_01.md"]
        self.assertIn("@snippet src/a/b.cpp part\n@htmlonly[block]", page)
        self.assertIn('<a href="source/src/a/b.cpp.txt">src/a/b.cpp</a>', page)

    def test_texts_keep_their_lines_and_get_their_numbers(self):
        lines = self.pages(self.FIRST, self.SECOND)["chapter_01.md"].splitlines()
        self.assertEqual(lines[0], "# 1 One {#chapter_01}")
        self.assertIn('<a rel="next" href="chapter_02.html">2 Two</a>', lines[1])
        self.assertEqual([lines[k] for k in (2, 5, 9, 12)],
                         ["Text, see " + '<a href="chapter_01.html#a_x_figure">figure 01.1</a> and',
                          "@htmlinclude[block] chapter_01_a_x_figure.html",
                          "## 1.1 Part {#chapter_01_part}", "## no heading"])

    def test_words_of_prose_are_counted(self):
        text = "A word \\f$ x + y \\f$, @ref eq_01_1 \"(01.1)\".\n```sh\n./stokes docs\n```\n" * 100
        self.assertEqual(number_pages.words_of_prose(text), 300)
        self.assertIn("5 minutes (300 words", number_pages.reading_time(text))


class Search(unittest.TestCase):
    def test_sections_and_their_texts(self):
        page = ('<script>x</script><div class="title">The title <div class="ingroups">a group</div></div>'
                '<div class="toc"><h3>Contents</h3><div>1</div></div><p>First, \\( x^2 \\) text.</p>'
                '<h1><a class="anchor" id="a"></a>\nHead</h1><p>of<a id="b"></a> a</p>'
                '<h2 class="memtitle"><span class="permalink"><a href="#b">x</a></span>f()</h2>last')
        self.assertEqual(search_index.entries_of("chapter_01.html", page, {"chapter_01.html#a": "rate; "}), [
            [0, "The title", "The title", "chapter_01.html", "a group First, … text.", ""],
            [0, "The title", "Head", "chapter_01.html#a", "of a", "rate; "],
            [0, "The title", "f()", "chapter_01.html#b", "last", ""]])

    def test_terms_stand_where_the_glossary_says(self):
        page = ('<ul><li><b>rate</b>: <a href="chapter_01.html#a">1.1</a>; <a href="b.html#b">2.1</a> <br />'
                'The <a href="c.html">rate</a> is ...</li>\n<li><strong>node</strong>: '
                '<a href="chapter_01.html#a">1.1</a></li></ul>')
        self.assertEqual(search_index.terms_of(page),
                         {"chapter_01.html#a": "rate; node; ", "b.html#b": "rate; "})

    def test_chapters_come_before_other_pages(self):
        names = ["chapter_01", "conventions", "exercise_01_1", "study_fmm", "group__fmm"]
        ranks = [search_index.entries_of(f"{name}.html", '<h1 id="a">x</h1>', {})[0][0] for name in names]
        self.assertEqual(ranks, [0, 1, 2, 3, 4])


class Book(unittest.TestCase):
    def test_links_lead_to_places_in_the_book(self):
        body = ('<a href="b.html#x">1</a> <a href="b.html">2</a> <a href="#y">3</a> <a href="https://a.org">4</a>'
                ' <a href="claims.html#z">5</a>')
        title, page = print_book.page_of_book(
            '<div class="title">A title </div><div class="contents"><div class="toc">-</div>'
            f'<div class="textblock">{body}</div></div><!-- contents -->', "a.html", {"a.html", "b.html"})
        self.assertEqual(title, "A title")
        self.assertIn('<a href="#x">1</a> <a href="#b.html">2</a> <a href="#y">3</a> '
                      '<a href="https://a.org">4</a> <a >5</a>', page)
        self.assertNotIn("toc", page)


class Glossary(unittest.TestCase):
    CHAPTER = ("# One {#chapter_01}\n\n**New:** a thing.\n\n## Part {#chapter_01_part}\n\n**Cost.** The cost is a\n"
               "**fine sum**, as said. **Rows** follow. It\n\\f[ x \\f] is **bare**.\n\n- **An item** is no term,\n"
               "- but the **other** is.\n\n```sh\necho a **shell**.\n```\n")

    def test_terms(self):
        self.assertEqual(glossary.terms_of(self.CHAPTER), [
            ("fine sum", "The cost is a **fine sum**, as said.", "chapter_01_part"),
            ("bare", "", "chapter_01_part"), ("other", "", "chapter_01_part")])

    def test_page(self):
        page = glossary.glossary_page([self.CHAPTER, "# Two {#chapter_02}\n\nA **Bare** fact.\n"])
        self.assertIn("\n- **bare**: @ref chapter_01_part; @ref chapter_02\n- **fine sum**: "
                      "@ref chapter_01_part <br>The cost is a **fine sum**, as said.\n- **other**", page)


class Lists(unittest.TestCase):
    def test_every_method_has_its_place_in_the_graph(self):
        methods = make_pages.methods_of(ROOT)
        graph = make_pages.graph(methods, make_pages.builds_on(ROOT, methods))
        self.assertEqual(graph.count("<rect"), 14)
        for number in range(1, 15):
            self.assertIn(f'href="chapter_{number:02}.html"', graph)

    def test_arrows_are_those_of_the_chapters(self):
        with tempfile.TemporaryDirectory() as name:
            root = pathlib.Path(name)
            methods = [("01", "a", ""), ("02", "b", ""), ("03", "c", ""), ("04", "d", "")]
            said = ["nothing.", "@ref\nchapter_01.", "@ref chapter_01; sums of @ref chapter_02.",
                    "@ref chapter_01 to @ref chapter_03."]
            for (number, method, _), text in zip(methods, said):
                folder = root / f"chapters/{number}_{method}"
                folder.mkdir(parents=True)
                (folder / "chapter.md").write_text(
                    f"# C\n**Builds on:** {text} **Library:** x. See @ref chapter_04.\n")
            uses = make_pages.builds_on(root, methods)
            self.assertEqual(uses, {"a": set(), "b": {"a"}, "c": {"a", "b"}, "d": {"a", "b", "c"}})
            self.assertEqual(make_pages.direct_uses(uses, list("abcd")),
                             {"a": set(), "b": {"a"}, "c": {"b"}, "d": {"c"}})

    def test_exercise_page(self):
        page = make_pages.exercise_page("03", 2, "# Two\nA $x$ and `$HOME`.\n")
        self.assertTrue(page.startswith("# Exercise 03.2: Two {#exercise_03_2}\n\nThis exercise belongs"), page)
        self.assertTrue(page.endswith("\nA \\f$x\\f$ and `$HOME`.\n"), page)
        folded = make_pages.exercise_page("03", 2, "# Two\n<details><summary>a</summary>\n")
        self.assertIn("@htmlonly[block]\n<details><summary>a</summary>\n@endhtmlonly", folded)


if __name__ == "__main__":
    unittest.main()
