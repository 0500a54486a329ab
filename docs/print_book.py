"""Prints the chapters, and the pages that explain their marks and letters, as one PDF.

print_book.py FOLDER-OF-PAGES CHROMIUM     writes book.pdf beside the folder
"""

import contextlib
import html
import pathlib
import re
import subprocess
import sys

# Where all fits on the paper, the browser prints at this scale: text of 10 points in lines of 75 characters.
STYLE = """<style>
  @page { size: A4; margin: 18mm 25mm; @bottom-center { content: counter(page); font-size: 9pt; } }
  body { overflow: visible; zoom: 0.85; } .book-page { break-before: page; }
</style>"""


WIDTH = 74  # characters of a program's output that fit on a line of the paper


def shrunk_output(match):
    """Returns a program's output, so small that no row of its tables takes two lines."""
    text = html.unescape(re.sub("<[^>]*>", "", match[1]))
    zoom = min(1.0, WIDTH / max(map(len, text.splitlines())))
    return f'<pre class="fragment" style="zoom: {max(zoom, 0.7):.2f}">{match[1]}</pre>'


def page_of_book(text, name, names):
    """Returns the title of a page, and its text with links to places in the book only."""
    title = re.search(r'<div class="title">(.*?) *</div>', text, re.DOTALL)[1]
    body = text[text.index('<div class="textblock">'):text.index("</div><!-- contents -->")]

    def link(match):
        page, _, anchor = match[1].partition("#")
        if not page or page in names:
            return f'href="#{anchor or page}"'
        return match[0] if page.startswith("http") else ""

    body = re.sub(r'href="([^"]*)"', link, body)
    body = re.sub(r'<pre class="fragment">(.*?)</pre>', shrunk_output, body, flags=re.DOTALL)
    return title, (f'<div class="book-page" id="{name}"><h1 class="title">{title}</h1>'
                   f'<div class="contents">{body}</div></div>\n')


def book_html(folder):
    """Returns the book as one page."""
    further = ("reading_results", "conventions", "glossary", "bibliography")
    paths = [*sorted(folder.glob("chapter_*.html")), *(folder / f"{name}.html" for name in further)]
    names = {path.name for path in paths}
    head = (folder / "index.html").read_text().partition("</head>")[0]
    head = re.sub(r"<title>.*?</title>", "<title>stokesbook</title>", head)
    pages = [page_of_book(path.read_text(), path.name, names) for path in paths]
    contents = "".join(f'<p><a href="#{path.name}">{title}</a></p>\n'
                       for path, (title, _) in zip(paths, pages))
    return (f'{head}{STYLE}</head><body><div class="contents"><h1>stokesbook</h1>\n{contents}</div>\n'
            + "".join(text for _, text in pages) + '<script src="site.js"></script></body></html>\n')


@contextlib.contextmanager
def one_page(folder):
    """Writes the whole book as one file beside the pictures that it shows; removes it in the end."""
    page = folder / "book.html"
    page.write_text(book_html(folder))
    try:
        yield page
    finally:
        page.unlink()


def main(folder, chromium):
    with one_page(folder) as page:
        subprocess.run([chromium, "--headless", "--no-sandbox", "--disable-gpu", "--window-size=1400,1000",
                        "--virtual-time-budget=1000000", "--no-pdf-header-footer",
                        f"--print-to-pdf={folder.parent / 'book.pdf'}", page.as_uri()], check=True)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve(), sys.argv[2])
