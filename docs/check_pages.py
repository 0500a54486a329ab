"""Checks that the pages keep the rules of the book.

check_pages.py sources ROOT     checks texts of chapters and exercises, before Doxygen runs
check_pages.py xml FOLDER       checks the comments of the public API that Doxygen has read
check_pages.py html FOLDER      checks the pages that Doxygen has written

Every check returns its findings as text; the program prints them and fails if there are any.

Results must not be typed by hand. In the prose of a chapter, the program refuses:
- scientific notation: 1e-12, 10^-12, 10<sup>-12</sup>;
- decimal fractions of four significant digits or more: 0.1234, 12.34;
- counts and times with their unit: 47 iterations, 2.5 s.
In formulas, it refuses a decimal mantissa times a power of ten: 1.3 \\cdot 10^{-12}.
It therefore accepts definitions (N = 32, a radius of 0.5, \\f$ \\varepsilon = 10^{-12} \\f$),
tolerances and parameters as code (`1e-12`), numbers of headings and of equations, (01.10), and
aliases, which carry the results.
"""

import html.parser
import pathlib
import re
import sys
import urllib.parse
import xml.etree.ElementTree

FENCE = re.compile(r"^( *)(```+|~~~+) *(\{?\.?[\w+-]*)")
SHELL = {"sh", "console"}
HEADING = re.compile(r"^(#{1,6}) ")
FORMULA = re.compile(r"\\f\$(.*?)\\f\$|\\f\[(.*?)\\f\]|\\f\{(.*?)\\f\}|\$\$(.+?)\$\$", re.DOTALL)
UNFINISHED = re.compile(r"\b(?:TODO|FIXME|XXX)\b|\?\?\?")
# Doxygen reads the text of a link from one line; else it may show all commands that follow as text.
BROKEN_LINK = re.compile(r'@ref \w+ "[^"\n]*$')
# The text ends before the next command that begins a line, or at the end of the comment.
ACCURACY = re.compile(r"@par Accuracy.*\n(?:\s*///(?! *@).*\n|\s*/// *@ref.*\n)*")
# Markdown takes such a line for an item of a list if the result is a whole number.
AS_ITEM = re.compile(r"\s*[@\\]val_\w+\.\s")
ITEM_IN_PARAGRAPH = re.compile(r"^(?!\d+\. |[-+*] )\S.*\n(?=(\d+\.) )", re.MULTILINE)
CODE_COMMAND = re.compile(r"[@\\](?:code|verbatim)\b|<pre\b", re.IGNORECASE)

TYPED_RESULT = re.compile(
    r"\b\d+(?:\.\d+)?[eE][-+]?\d+\b"
    r"|\b10\s*(?:\^|<sup>)|\b10[⁻⁰¹²³⁴-⁹]+"
    r"|(?<![\w.])(?=\d*\.\d)(?=[0.]*[1-9](?:\.?\d){3})\d+\.\d+(?!\.?\w)"
    r"|(?<![\w.])\d+(?:\.\d+)?\s*(?:iterations?|seconds?|ms|µs|s)\b")
EQUATION_NUMBER = re.compile(r"\((?:0[1-9]|1[0-4])\.\d{1,2}\)")  # (01.10)
EQUATION_TAG = re.compile(r"\\tag\{\d\d\.(\d+)\}")
TYPED_MANTISSA = re.compile(r"\d\.\d+\s*(?:\\,)?\\(?:cdot|times)\s*10\s*\^")


def blanked(match):
    """Returns as many line breaks as the match contains, and no text."""
    return "\n" * match[0].count("\n")


def fenced(text):
    """Returns the line numbers of fenced blocks, and the line and language of each block."""
    numbers, languages, fence = set(), [], None
    for number, line in enumerate(text.splitlines(), 1):
        found = FENCE.match(line)
        if fence is None and found:
            fence = found[2]
            languages.append((number, found[3].strip("{.")))
            numbers.add(number)
        elif fence is not None:
            numbers.add(number)
            if line.strip() == fence:
                fence = None
    return numbers, languages


def without_code(text):
    """Returns the text with blank lines instead of fenced blocks."""
    code = fenced(text)[0]
    return "".join(f"{'' if number in code else line}\n"
                   for number, line in enumerate(text.splitlines(), 1))


def indented_code(text):
    """Returns the lines that Markdown takes for code.

    Such a line is indented by four, follows a blank line, and is not in a list.
    """
    found, blank, in_list = [], True, False
    for number, line in enumerate(text.splitlines(), 1):
        if not line.strip():
            blank = True
            continue
        indent = len(line) - len(line.lstrip())
        if re.match(r" *([-*+]|\d+[.)]) ", line):
            in_list = True
        elif indent == 0:
            in_list = False
        if blank and indent >= 4 and not in_list:
            found.append(number)
        blank = False
    return found


def empty_headings(text):
    """Returns the lines of the headings without text.

    The text must come before the next heading of their level or above, or before the end.
    """
    found, open_headings = [], []  # (level, line) of headings without text so far
    code = fenced(text)[0]
    for number, line in enumerate(text.splitlines(), 1):
        heading = HEADING.match(line)
        if heading and number not in code:
            level = len(heading[1])
            found += [start for other, start in open_headings if other >= level]
            open_headings = [(o, start) for o, start in open_headings if o < level]
            open_headings.append((level, number))
        elif line.strip():
            open_headings = []
    return sorted(found + [start for _, start in open_headings])


def typed_results(text):
    """Returns the results in prose or formulas, each with its line."""
    found = []

    def look(pattern, part, offset):
        for match in pattern.finditer(part):
            found.append((text.count("\n", 0, offset + match.start()) + 1, match[0].strip()))

    for formula in FORMULA.finditer(text):
        look(TYPED_MANTISSA, formula[0], formula.start())
    # Parts that are not prose are overwritten, so that the prose keeps its place.
    prose = text
    for pattern in [FORMULA, re.compile(r"`[^`\n]*`"), re.compile(r"\]\([^)]*\)|<https?:[^>]*>"),
                    EQUATION_NUMBER, re.compile(r"\{#\w+\}|[@\\]\w+")]:
        prose = pattern.sub(lambda m: re.sub(r"[^\n]", "\0", m[0]), prose)
    look(TYPED_RESULT, prose, 0)
    return found


def lines_with(pattern, name, text, meaning=""):
    """Returns what a pattern finds in each line, with the meaning of such a violation."""
    return [f"{name}:{number}: {match[0]}{meaning}"
            for number, line in enumerate(text.splitlines(), 1) if (match := pattern.search(line))]


def text_violations(name, text):
    """Returns the violations of the rules that hold for any text of the book."""
    return (lines_with(UNFINISHED, name, text)
            + lines_with(BROKEN_LINK, name, text, ": the text of a link must stand on one line")
            + [f"{name}:{line}: a heading with nothing under it" for line in empty_headings(text)])


def chapter_violations(name, text):
    """Returns the violations of the rules in one chapter.md."""
    if not re.match(r"# \S.* \{#chapter_\d\d\}\n", text):
        return [f"{name}:1: the first line must be a title and anchor: # Title {{#chapter_NN}}"]
    prose, languages = without_code(text), fenced(text)[1]
    violations = text_violations(name, text)
    violations += [f"{name}:{line}: a block of {language or 'code'}: show code by @snippet"
                   for line, language in languages if language not in SHELL]
    violations += [f"{name}:{line}: indented code: show code by @snippet"
                   for line in indented_code(FORMULA.sub(blanked, prose))]
    violations += lines_with(CODE_COMMAND, name, prose, ": show code by @snippet")
    violations += [f"{name}:{line}: a typed result, {result}: use the study's alias"
                   for line, result in typed_results(prose)]
    violations += [f"{name}:{number}: a result that may be an item of a list, as 11. is: not first"
                   for number, line in enumerate(prose.splitlines(), 1) if AS_ITEM.match(line)]
    violations += [f"{name}:{prose.count(chr(10), 0, match.end()) + 1}: {match[1]} begins a line of a "
                   "paragraph, and would become an item of a list"
                   for match in ITEM_IN_PARAGRAPH.finditer(prose)]
    violations += [f"{name}:{text.count(chr(10), 0, match.start()) + 1}: {match[0]}: this is "
                   f"equation {place} of the chapter"
                   for place, match in enumerate(EQUATION_TAG.finditer(text), 1)
                   if int(match[1]) != place]
    return violations


def unproved_accuracy(name, text):
    """Returns statements on accuracy without a claim, in a header of a room that has a study."""
    return [f"{name}:{text.count(chr(10), 0, match.start()) + 1}: an accuracy without its claim: "
            "add @ref claim_NN_k" for match in ACCURACY.finditer(text)
            if "@ref claim_" not in match[0]]


def source_violations(root):
    violations = []
    for study in sorted(root.glob("verification/*/study.cpp")):
        for path in sorted((root / "src" / study.parent.name).rglob("*.hpp")):
            violations += unproved_accuracy(path.relative_to(root).as_posix(), path.read_text())
    for path in sorted([*root.glob("chapters/*/chapter.md"), *root.glob("docs/*.md"),
                        *root.glob("chapters/*/exercises/*/README.md")]):
        check = chapter_violations if path.name == "chapter.md" else text_violations
        violations += check(path.relative_to(root).as_posix(), path.read_text())
    return violations


def has_text(element):
    return element is not None and "".join(element.itertext()).strip() != ""


def member_violations(member, owner):
    """Returns the texts that the comment of one public member lacks."""
    name = f"{owner}::{member.findtext('name')}"
    lacks = []
    if not has_text(member.find("briefdescription")) and not has_text(
            member.find("detaileddescription")):
        lacks.append("a description")
    if member.get("kind") == "enum":
        lacks += [f"a description of {value.findtext('name')}"
                  for value in member.findall("enumvalue")
                  if not has_text(value.find("briefdescription"))
                  and not has_text(value.find("detaileddescription"))]
    lacks += [f"a text below {paragraph.findtext('title')}"
              for paragraph in member.findall(".//simplesect[@kind='par']")
              if not has_text(paragraph.find("para"))]
    lacks += [f"a text after @param {item.findtext('.//parametername')}"
              for item in member.findall(".//parameterlist[@kind='param']/parameteritem")
              if not has_text(item.find("parameterdescription"))]
    lacks += ["a text after @return" for result in member.findall(".//simplesect[@kind='return']")
              if not has_text(result)]
    return [f"{name} lacks {lack}" for lack in lacks]


def is_implicit(member):
    """Defaulted and deleted functions, friends among them, and destructors need no comment."""
    arguments = member.findtext("argsstring") or ""
    return arguments.endswith(("=default", "=delete")) or member.findtext("name").startswith("~")


def api_violations(folder):
    """Returns the public types, functions and variables of stokesbook that lack a comment."""
    violations, seen = [], set()
    for path in sorted(folder.glob("*.xml")):
        for compound in xml.etree.ElementTree.parse(path).getroot().findall("compounddef"):
            owner = compound.findtext("compoundname")
            kind = compound.get("kind")
            if kind not in ("namespace", "class", "struct", "group") or compound.get("prot") in (
                    "private", "protected"):
                continue
            if kind in ("class", "struct") and not has_text(compound.find("briefdescription")):
                violations.append(f"{owner} lacks a description")
            for member in compound.iter("memberdef"):
                qualified = member.findtext("qualifiedname") or ""
                if (member.get("prot") != "public" or member.get("id") in seen
                        or member.get("kind") not in ("function", "variable", "enum", "typedef")
                        or not qualified.startswith("stokesbook::") or is_implicit(member)):
                    continue
                seen.add(member.get("id"))
                violations += member_violations(member, qualified.rpartition("::")[0])
    if not seen:
        violations.append(f"{folder}: nothing of namespace stokesbook was read")
    return violations


class Page(html.parser.HTMLParser):
    """Collects the anchors, links, prose and folded texts of one page."""

    def __init__(self, text):
        super().__init__()
        self.anchors, self.links, self.prose = set(), [], []
        self.folded = self.summaries = 0
        self._silent = []  # open elements whose text is not prose
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.anchors |= {attributes[key] for key in ("id", "name") if attributes.get(key)}
        for key in ("href", "src", "data", "xlink:href"):
            if attributes.get(key):
                self.links.append(attributes[key])
        self.folded += tag == "details"
        self.summaries += tag == "summary"
        is_code = "fragment" in (attributes.get("class") or "").split()
        if tag in ("pre", "code", "script", "style", "tt", "svg") or is_code or (
                self._silent and tag == self._silent[0]):
            self._silent.append(tag)

    def handle_endtag(self, tag):
        if self._silent and self._silent[-1] == tag:
            self._silent.pop()

    def handle_data(self, data):
        if not self._silent:
            self.prose.append(data)


MATH = re.compile(r"\\\(.*?\\\)|\\\[.*?\\\]|\\begin\{(\w+\*?)\}.*?\\end\{\1\}", re.DOTALL)
LEAK = re.compile(r"[@\\][A-Za-z_]\w+|\\f[$\[]|\?\?\?")


def html_violations(folder):
    """Returns broken links and anchors, missing pictures, and Doxygen commands that are visible."""
    pages = {path.name: Page(path.read_text()) for path in folder.glob("*.html")}
    if "index.html" not in pages:
        return [f"{folder}: no pages"]
    violations = []
    for name, page in sorted(pages.items()):
        for link in sorted(set(page.links)):
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc or link == "#":
                continue
            target, anchor = urllib.parse.unquote(parts.path) or name, parts.fragment
            if not (folder / target).exists():
                violations.append(f"{name}: {link} does not exist")
            elif anchor and target in pages and anchor not in pages[target].anchors:
                violations.append(f"{name}: {link} has no such anchor")
        prose = MATH.sub("", "".join(page.prose))
        if page.folded != page.summaries:
            violations.append(f"{name}: {page.folded} folded texts, {page.summaries} summaries")
        violations += [f"{name}: shows {leak}" for leak in sorted(set(LEAK.findall(prose)))]
    return violations


CHECKS = {"sources": source_violations, "xml": api_violations, "html": html_violations}


def main(what, folder):
    violations = CHECKS[what](pathlib.Path(folder))
    for violation in violations:
        print(violation, file=sys.stderr)
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
