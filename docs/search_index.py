"""Writes the index of the search box, search_index.js: the sections of all pages with their texts.

search_index.py FOLDER-OF-PAGES
"""

import collections
import html.parser
import json
import pathlib
import re
import sys

from check_pages import MATH

# A page's rank is the first pattern that its name matches: of equal hits, chapters come first.
RANKS = ["chapter_", "(?!group_|class|struct|namespace|exercise_|study_|claims|bibliography)",
         "exercise_", "study_|claims|bibliography", "group_|class|struct|namespace"]
BLOCKS = {"p", "div", "li", "td", "th", "dt", "dd", "figcaption", "summary"}
NOT_READ = {"toc", "permalink", "fragment"}  # classes; quoted code would outweigh the text
NO_TEXT = re.compile(r".*-members|.*_animation|dir_.*|.*_8[hc]pp|annotated|modules|pages|topics")


class Sections(html.parser.HTMLParser):
    """Collects [heading, anchor, text] of each section of a page; the first is the page's title."""

    def __init__(self, text):
        super().__init__()
        self.sections = []
        self._anchor, self._heading, self._silent = "", None, []  # open heading, silent elements
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        classes = (attributes.get("class") or "").split()
        if self._silent or tag in ("script", "style", "svg", "nav") or NOT_READ & set(classes):
            if not self._silent or tag == self._silent[0]:
                self._silent.append(tag)
        elif re.fullmatch("h[1-6]", tag) or "title" in classes and tag == "div":
            self.sections.append(["", self._anchor, ""])
            self._heading = tag
        elif tag == self._heading:  # below the title of a type: the groups that it is in
            self._heading = None
        elif tag in BLOCKS:
            self.handle_data(" ")
        if attributes.get("id") and not self._silent:
            self._anchor = attributes["id"]
            if self._heading:
                self.sections[-1][1] = self._anchor

    def handle_endtag(self, tag):
        if self._silent and self._silent[-1] == tag:
            self._silent.pop()
        elif tag == self._heading:
            self._heading = None

    def handle_data(self, data):
        if self.sections and not self._silent:
            self.sections[-1][0 if self._heading else 2] += data


def words_of(text):
    return " ".join(MATH.sub(" … ", text).split())


def terms_of(glossary):
    """Returns the terms that each section defines, from the page of the glossary: address -> terms."""
    terms = collections.defaultdict(str)
    for item in re.findall(r"<li>(.*?)</li>", glossary, re.DOTALL):
        places = item.partition("<br")[0]  # the sentence that defines the term may have links, too
        for address in re.findall(r'href="([^"]*)"', places):
            terms[address] += re.search(r"<(?:b|strong)>(.*?)</", places)[1] + "; "
    return terms


def entries_of(name, text, terms):
    """Returns [rank, title of the page, heading, address, text, terms] for each section of a page."""
    rank = next(k for k, pattern in enumerate(RANKS) if re.match(pattern, name))
    sections = Sections(text).sections
    title = words_of(sections[0][0]) if sections else ""
    addresses = [f"{name}#{anchor}" if k else name for k, (_, anchor, _) in enumerate(sections)]
    return [[rank, title, words_of(heading), address, words_of(body), terms.get(address, "")]
            for address, (heading, _, body) in zip(addresses, sections)]


def main(folder):
    terms = terms_of((folder / "glossary.html").read_text())
    entries = [entry for page in sorted(folder.glob("*.html")) if not NO_TEXT.fullmatch(page.stem)
               for entry in entries_of(page.name, page.read_text(), terms)]
    index = json.dumps(entries, ensure_ascii=False)
    (folder / "search_index.js").write_text(f"searchIndex = {index};\n")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
