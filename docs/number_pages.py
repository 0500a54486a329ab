"""Completes the texts of the book: numbers of sections, figures and tables, captions, and what leads on.

An included figure or table, X_figure.html, X_table.html or X.svg, becomes a <figure> with its number in
its page and a caption: the title of the picture or the caption of the table. \\see_X_figure and
\\see_X_table become links to it. A table that directly follows the figure of its name is folded.
Texts keep their lines, so that warnings of Doxygen name the right ones.
"""

import html
import re

from check_pages import FORMULA, without_code

INCLUDE = re.compile(r"^@htmlinclude (?:\S*/)?(\w+_(figure|table)\.html|\w+\.svg)$", re.MULTILINE)
SEE = re.compile(r"[@\\]see_(\w+)")
SNIPPET = re.compile(r"^(@snippet (\S+) \S+\n)\n", re.MULTILINE)
TITLE = re.compile(r"# (.*) \{#(\w+)\}\n")
MOST_WORDS = 4500  # of a chapter's prose
WORDS_A_MINUTE = 45  # slow, because formulas and figures take their time, but are not counted


class Shown:
    """A figure or table that a page includes."""

    def __init__(self, name, page, number, follows):
        self.stem, _, ending = name.partition(".")
        self.is_table = self.stem.endswith("_table")
        self.name, self.page, self.number = name, page, number
        self.folded_below = follows if self.is_table and follows and follows.key == self.key else None
        self.file = f"{page}_{self.stem}.html"

    @property
    def key(self):
        return re.sub(r"(_work)?_(figure|table)$", "", self.stem)

    @property
    def label(self):
        return f"{'table' if self.is_table else 'figure'} {self.number}"

    def link(self, begins=False):
        label = self.label.capitalize() if begins else self.label
        return f'<a href="{self.page}.html#{self.stem}">{label}</a>'


def shown_in(text):
    """Returns the figures and tables of a page in their order."""
    page = TITLE.match(text)[2]
    chapter = re.fullmatch(r"chapter_(\d\d)", page)
    found, counts, end = [], [0, 0], 0
    for match in INCLUDE.finditer(text):
        is_table = match[2] == "table"
        counts[is_table] += 1
        number = f"{chapter[1]}.{counts[is_table]}" if chapter else str(counts[is_table])
        follows = found[-1] if found and not text[end:match.start()].strip() else None
        found.append(Shown(match[1], page, number, follows))
        end = match.end()
    return found


def begins_sentence(match):
    """Returns whether a match begins a sentence or a paragraph of its text."""
    before = match.string[:match.start()]
    return before.endswith("\n\n") or before.rstrip().endswith((".", "!", "?"))


def unreferred(text):
    """Returns the figures and tables that a page includes and that its text does not refer to."""
    return [shown.stem for shown in shown_in(text) if shown.stem not in SEE.findall(text)]


def faults(text):
    """Returns what a page lacks: references to its figures and tables, or brevity."""
    found = [f"the text does not refer to {stem}" for stem in unreferred(text)]
    words = words_of_prose(text)
    if words > MOST_WORDS and TITLE.match(text)[2].startswith("chapter_"):
        found.append(f"{words} words of prose; a chapter has at most {MOST_WORDS}")
    return found


def caption_of(content, title):
    """Returns the caption of a table, or the titles of a figure's pictures, else the given title."""
    titles = re.findall(r"<caption>(.*?)</caption>|<title>(.*?)</title>", content, re.DOTALL)
    titles = [caption or picture for caption, picture in titles] or [html.escape(title)]
    # The pictures of one figure have titles "What is shown: error against ...".
    caption = "; ".join([titles[0], *(further.rpartition(": ")[2] for further in titles[1:])])
    return caption if caption.endswith((".", "!", "?")) else caption + "."


def study_sections(folder):
    """Returns where the studies show their files: name of file -> (title, link) of the section."""
    sections = {}
    for page in sorted(folder.glob("*_study.md")):
        for part in page.read_text().split("\n## ")[1:]:
            title, anchor = re.match(r"(.*) \{#(\w+)\}", part).groups()
            for name in re.findall(r"@htmlinclude (\S+)", part):
                sections[name] = title, f"study_{page.stem.removesuffix('_study')}.html#{anchor}"
    return sections


def figure_html(shown, content, title, study):
    """Returns a figure or table with its number and caption."""
    caption = caption_of(content, title)
    if study:
        caption += f' <a class="study" href="{study}">Study</a>'
    label = shown.label.capitalize()
    content = re.sub(r"<caption>.*?</caption>\n?", "", content, flags=re.DOTALL)
    if shown.folded_below:
        content = (f"<details><summary>{label}: the numbers of {shown.folded_below.label}</summary>\n"
                   f"<p>{caption}</p>\n{content}</details>")
    else:
        caption = f"<figcaption><b>{label}.</b> {caption}</figcaption>\n"
        content = caption + content if shown.is_table else content + caption
    kind = "table" if shown.is_table else "picture"
    return f'<figure class="{kind}" id="{shown.stem}">\n{content}</figure>\n'


def words_of_prose(text):
    """Counts the words of a chapter, without formulas and code."""
    prose = re.sub(r"[@\\]\w+|\{#\w+\}|<[^>]*>", " ", FORMULA.sub(" ", without_code(text)))
    return len(re.findall(r"[^\W\d_][\w'-]*", prose))


def reading_time(text):
    """Returns the line on the time that a chapter takes, at its head."""
    words = words_of_prose(text)
    return (f'<p class="reading">Reading time: {5 * round(words / WORDS_A_MINUTE / 5)} minutes '
            f"({round(words, -2):,} words at {WORDS_A_MINUTE} a minute, formulas included)</p>")


def with_section_numbers(text, chapter):
    """Returns the text of a chapter with its number before its title, and numbers before sections."""
    code, section, lines = False, 0, []
    for line in text.splitlines():
        code ^= line.startswith("```")
        if line.startswith("# ") and not lines:
            line = f"# {int(chapter)} {line[2:]}"
        elif line.startswith("## ") and not code:
            section += 1
            line = f"## {int(chapter)}.{section} {line[3:]}"
        lines.append(line)
    return "\n".join([*lines, ""])


def quoted_files(text):
    """Returns the source files from which a page quotes."""
    return {match[2] for match in SNIPPET.finditer(text)}


def with_sources(text):
    """Returns the text with a link to the whole file below each quotation of code."""
    return SNIPPET.sub(r'\1@htmlonly[block]<p class="source"><a href="source/\2.txt">\2</a></p>@endhtmlonly\n', text)


def pager(chapters, k):
    """Returns links to the chapters before and after the chapter k of (title, anchor) pairs."""
    links = [f'<a rel="{relation}" href="{chapters[j][1]}.html">{html.escape(chapters[j][0])}</a>'
             for relation, j in [("prev", k - 1), ("next", k + 1)] if 0 <= j < len(chapters)]
    return f'@htmlonly[block]<nav class="pager">{"".join(links)}</nav>@endhtmlonly'


def numbered_pages(texts, find, sections):
    """Returns the texts to be read by Doxygen, and their figures and tables: file name -> text.

    texts are the chapters, in order, and other pages: all with a title and an anchor. find(name) returns
    the text of an included file, sections is that of study_sections().
    """
    figures = [shown_in(text) for text in texts]
    chapters = [(f"{int(anchor[-2:])} {title}", anchor) for title, anchor in
                (TITLE.match(text).groups() for text in texts) if anchor.startswith("chapter_")]
    everywhere = {shown.stem: shown for page in reversed(figures) for shown in page}
    written = {}
    for k, text in enumerate(texts):
        page = TITLE.match(text)[2]
        own = everywhere | {shown.stem: shown for shown in figures[k]}
        in_order = iter(figures[k])
        if k < len(chapters):
            time = reading_time(text)
            text = with_section_numbers(text, page[-2:])
            title, _, body = text.partition("\n\n")
            text = (f"{title}\n@tableofcontents{{HTML:1}} {pager(chapters, k)} "
                    f"@htmlonly[block]{time}@endhtmlonly\n"
                    f"{body}\n{pager(chapters, k)}\n")
        text = with_sources(text)
        text = INCLUDE.sub(lambda _: f"@htmlinclude[block] {next(in_order).file}", text)
        for stem in set(SEE.findall(text)):
            if stem not in own:
                raise SystemExit(f"{page}: \\see_{stem}: no page includes such a figure or table")
        written[f"{page}.md"] = SEE.sub(
            lambda match: own[match[1]].link(begins_sentence(match)), text)
        for shown in figures[k]:
            title, study = sections.get(shown.name, (shown.name, None))
            written[shown.file] = figure_html(shown, find(shown.name), title, study)
    return written
