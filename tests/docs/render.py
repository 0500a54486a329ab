"""Renders pages in a headless Chromium and reports their faults.

render.py FOLDER [PAGE...]                      checks all or some pages of FOLDER
render.py FOLDER --screenshots TO [PAGE...]     saves pictures of pages: light, dark, phone
"""

import concurrent.futures
import pathlib
import sys

import browser

PHONE = (390, 844)
DESKTOP = (1280, 900)

# Returns the faults of a page, once its formulas are set.
REPORT = r"""
(async () => {
  if (window.MathJax && MathJax.Hub) {
    await new Promise(done => MathJax.Hub.Queue(done));
  }
  const found = [];
  for (const jax of window.MathJax && MathJax.Hub ? MathJax.Hub.getAllJax() : []) {
    const holder = document.getElementById(jax.inputID + "-Frame");
    const text = jax.originalText.trim();
    if (jax.texError || /"?merror"?/.test(jax.root ? jax.root.type + " " + jax.root.toString() : "merror")) {
      found.push("a formula is wrong: " + text);
    } else if (jax.root.toString().includes("???")) {
      found.push("a formula refers to an equation that is not on its page: " + text);
    } else if (!holder || !holder.querySelector("svg") || !holder.getBoundingClientRect().width) {
      found.push("a formula is not set: " + text);
    }
  }
  for (const failed of document.querySelectorAll(".MathJax_Error")) {
    found.push("MathJax failed: " + failed.textContent);
  }
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const text = walker.currentNode;
    if (/\\\(|\\\[/.test(text.data) &&
        !text.parentElement.closest("script, style, pre, code, .fragment")) {
      found.push("TeX shows: " + text.data.trim().slice(0, 60));
    }
  }
  for (const picture of document.querySelectorAll(".contents img, .contents svg")) {
    if (picture.closest(
        ".MathJax_SVG, .MathJax_SVG_Display, details:not([open]), .inherit_header")) continue;
    const box = picture.getBoundingClientRect();
    const name = picture.getAttribute("src") || picture.getAttribute("class") || picture.tagName;
    if (picture.tagName === "IMG" && !(picture.complete && picture.naturalWidth)) {
      found.push("a picture is missing: " + name);
    } else if (box.width < 10 || box.height < 10) {
      found.push("a picture has no size: " + name);
    }
  }
  for (const box of [document.documentElement, document.getElementById("doc-content")]) {
    if (box && box.scrollWidth > box.clientWidth + 1) {
      const wide = [...box.querySelectorAll(".contents *")].filter(element => {
        for (let e = element; e && e !== box; e = e.parentElement) {
          if (getComputedStyle(e).overflowX !== "visible" && e !== element) return false;
        }
        return element.getBoundingClientRect().right > box.clientWidth + 1;
      })[0];
      found.push("wider than the screen by " + (box.scrollWidth - box.clientWidth) + ": " +
                 (wide ? wide.tagName + "." + wide.className + " " +
                         wide.textContent.trim().slice(0, 40) : box.id || "the page"));
    }
  }
  return found;
})()
"""


def pages_of(folder):
    """Returns the pages with text, without Doxygen's bare lists of members."""
    return sorted(page for page in folder.glob("*.html") if not page.stem.endswith("-members"))


def render(tab, page, width=PHONE):
    """Returns the faults of one page on a screen of this size."""
    tab.look(*width)
    found = tab.open(page.as_uri())
    found += tab.evaluate(REPORT)
    found += tab.errors()
    return [f"{page.name}: {problem}" for problem in found]


def render_all(pages, command="chromium", tabs=4):
    """Returns the faults of all pages on a phone."""
    with browser.Browser(command) as chromium, concurrent.futures.ThreadPoolExecutor(tabs) as pool:
        shares = [pages[start::tabs] for start in range(tabs)]

        def work(share):
            tab = chromium.tab()
            return [problem for page in share for problem in render(tab, page)]
        return sorted(problem for problems in pool.map(work, shares) for problem in problems)


def search_results(tab, page, words):
    """Returns the addresses that the search box of a page offers for some words."""
    tab.look(*DESKTOP)
    tab.open(page.as_uri())
    return tab.evaluate(r"""
      (async () => {
        const [field, list] = document.getElementById("book-search").children;
        field.focus();
        while (!window.searchIndex) await new Promise(done => setTimeout(done, 50));
        field.value = WORDS;
        field.dispatchEvent(new Event("input"));
        return [...list.querySelectorAll("a")].map(link => link.getAttribute("href"));
      })()""".replace("WORDS", repr(words)))


def save_screenshots(pages, folder):
    folder.mkdir(parents=True, exist_ok=True)
    with browser.Browser() as chromium:
        tab = chromium.tab()
        for page in pages:
            for name, size, dark in [("light", DESKTOP, False), ("dark", DESKTOP, True),
                                     ("phone", PHONE, False)]:
                tab.look(*size, dark=dark)
                tab.open(page.as_uri())
                tab.evaluate(REPORT)
                height = tab.evaluate("""Math.max(document.documentElement.scrollHeight,
                    ...["doc-content", "top"].map(id => document.getElementById(id))
                       .filter(e => e).map(e => e.scrollHeight + e.offsetTop))""")
                tab.look(size[0], min(height + 200, 12000), dark=dark)
                tab.save_picture(folder / f"{page.stem}_{name}.png")


def main(arguments):
    folder = pathlib.Path(arguments.pop(0)).resolve()
    screenshots = None
    if arguments[:1] == ["--screenshots"]:
        screenshots = pathlib.Path(arguments[1])
        arguments = arguments[2:]
    pages = [folder / name for name in arguments] or pages_of(folder)
    if screenshots:
        save_screenshots(pages, screenshots)
        return 0
    problems = render_all(pages)
    print("\n".join(problems))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
