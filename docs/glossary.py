"""Makes the glossary: each term that a chapter defines, its defining sentence, and its section.

A chapter sets a term in bold where it defines it, within a sentence. Bold words that begin a sentence, or end
with a full stop or colon, are headings of paragraphs or items, not terms.
"""

import re

from check_pages import without_code

TERM = re.compile(r"\*\*([A-Za-z][\w'-]*(?:\s[\w'-]+){0,3})\*\*")
PARAGRAPH = re.compile(r"\n\s*\n|\n(?=[-*] |\d+\. )")
LEADING = re.compile(r"^(?:[-*] |\d+\. )?(?:\*\*[^*]+[.:?]\*\*\s*)?")
SENTENCE = re.compile(r"(?<=[.:?])\s+(?=[A-Z(*@`])")
WHOLE = re.compile(r"[A-Z(][^|]*[.:]")


def terms_of(text):
    """Returns (term, sentence, anchor of the section) for each term that a chapter defines.

    The sentence is empty if it is not whole, because of a displayed formula.
    """
    found, anchor = [], ""
    for block in PARAGRAPH.split(without_code(text)):
        heading = re.match(r"#+ .*\{#(\w+)\}", block.strip())
        if heading:
            anchor = heading[1]
            continue
        for sentence in SENTENCE.split(LEADING.sub("", block.strip())):
            sentence = " ".join(sentence.split())
            is_whole = WHOLE.fullmatch(sentence) and not re.search(r"\\f\[|@anchor", sentence)
            found += [(match[1], sentence if is_whole else "", anchor)
                      for match in TERM.finditer(sentence) if match.start() > 0]
    return found


def glossary_page(chapters):
    """Returns the page of the terms of all chapters, in alphabetical order."""
    entries = {}
    for text in chapters:
        for term, sentence, anchor in terms_of(text):
            first, anchors = entries.setdefault(term.lower(), ((term, sentence), []))
            if anchor not in anchors:
                anchors.append(anchor)
    lines = ["# Glossary {#glossary}", "", "Each term with the sentence that defines it, and the section.", ""]
    for _, ((term, sentence), anchors) in sorted(entries.items()):
        places = "; ".join(f"@ref {anchor}" for anchor in anchors)
        lines += [f"- **{term}**: {places}" + (f" <br>{sentence}" if sentence else "")]
    return "\n".join([*lines, ""])
