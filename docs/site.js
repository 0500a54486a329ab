// The search box of all pages, the filter of the index of claims, and folded tables on paper.

// Returns up to 20 sections of the index that contain words of the query, the best first. A word counts
// more in a heading of the book, and in a name of the API that is the whole query. Then chapters come first,
// and then sections with more occurrences.
function search(index, query) {
  const words = query.toLowerCase().match(/[\p{L}\p{N}]+/gu);
  if (!words) return [];
  const begins = words.map(word => new RegExp("(?<![\\p{L}\\p{N}])" + word, "giu"));
  const name = text => text.replace("()", "").trim().toLowerCase();
  const phrase = new RegExp(words.join("[^\\p{L}\\p{N}]+"), "iu");
  const points = (text, one, all) => begins.filter(begin => text.search(begin) >= 0).length * one +
                                     (words.length > 1 && phrase.test(text) ? all : 0);
  return index.map(([rank, page, heading, address, text]) => {
    const leads = rank < 3 || name(heading) === name(query);
    const at = Math.max(60, text.search(phrase), text.search(begins[0])) - 60;
    return {
      page, heading, address, rank, text: text.substr(at, 160),
      points: leads ? points(heading, 3, 2) + points(text, 1, 1) : points(heading + " " + text, 1, 1),
      occurrences: begins.reduce((sum, begin) => sum + (text.match(begin) || []).length, 0)
    };
  }).filter(hit => hit.points > 0)
    .sort((a, b) => b.points - a.points || a.rank - b.rank || b.occurrences - a.occurrences)
    .slice(0, 20);
}

(function addSearchBox() {
  const box = document.createElement("div");
  box.id = "book-search";
  box.innerHTML = '<input type="search" placeholder="Search (press /)" aria-label="Search the book"><ol></ol>';
  document.getElementById("top").append(box);
  const [field, list] = box.children;

  function show() {
    list.replaceChildren(...search(window.searchIndex || [], field.value).map(hit => {
      const link = document.createElement("a");
      link.href = hit.address;
      for (const [tag, text] of [["b", hit.heading], ["i", hit.heading === hit.page ? "" : hit.page],
                                 ["span", hit.text]]) {
        link.append(Object.assign(document.createElement(tag), {textContent: text}));
      }
      const item = document.createElement("li");
      item.append(link);
      return item;
    }));
  }

  field.addEventListener("focus", () => {  // The index is read when it is needed first.
    if (window.searchIndex || document.querySelector("script[src='search_index.js']")) return;
    const script = document.createElement("script");
    document.head.append(Object.assign(script, {src: "search_index.js", onload: show}));
  });
  field.addEventListener("input", show);
  list.addEventListener("click", () => list.replaceChildren());
  document.addEventListener("click", event => box.contains(event.target) || list.replaceChildren());
  document.addEventListener("keydown", event => {
    const links = [field, ...list.querySelectorAll("a")], at = links.indexOf(document.activeElement);
    const step = {ArrowDown: 1, ArrowUp: -1}[event.key];
    if (event.key === "/" && !/INPUT|TEXTAREA/.test(document.activeElement.tagName)) field.focus();
    else if (event.key === "Escape" && at >= 0) list.replaceChildren();
    else if (event.key === "Enter" && at === 0 && links[1]) links[1].click();
    else if (step && at >= 0 && links[at + step]) links[at + step].focus();
    else return;
    event.preventDefault();
  });
})();

addEventListener("beforeprint", () => {
  for (const folded of document.querySelectorAll("figure details")) folded.open = true;
});
