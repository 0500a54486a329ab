// The search box of all pages, the index of claims, and folded tables on paper.

// Returns up to 20 sections of the index that contain words of the query, the best first. A word counts
// more in a heading of the book, where the book defines it, and in a heading that is the whole query.
// Then chapters come first, and then sections with more occurrences. Without a hit, words are cut to stems.
function search(index, query) {
  const words = query.toLowerCase().match(/[\p{L}\p{N}]+/gu);
  if (!words) return [];
  const hits = found(index, query, words), stems = words.map(word => word.slice(0, 6));
  return hits.length || stems.join() === words.join() ? hits : found(index, query, stems);
}

function found(index, query, words) {
  const begins = words.map(word => new RegExp("(?<![\\p{L}\\p{N}])" + word, "giu"));
  const name = text => text.replace("()", "").trim().toLowerCase();
  const phrase = new RegExp(words.join("[^\\p{L}\\p{N}]+"), "iu");
  const points = (text, one, all) => begins.filter(begin => text.search(begin) >= 0).length * one +
                                     (words.length > 1 && phrase.test(text) ? all : 0);
  return index.map(([rank, page, heading, address, text, terms]) => {
    const leads = rank < 3 || name(heading) === name(query);
    const at = Math.max(60, text.search(phrase), text.search(begins[0])) - 60;
    return {
      page, heading, address, rank, text: text.substr(at, 160),
      points: (leads ? points(heading, 3, 2) + points(text, 1, 1) : points(heading + " " + text, 1, 1)) +
              points(terms, 3, 2) + (heading.trim().toLowerCase() === query.trim().toLowerCase() ? 4 : 0),
      occurrences: begins.reduce((sum, begin) => sum + (text.match(begin) || []).length, 0)
    };
  }).filter(hit => hit.points > 0)
    .sort((a, b) => b.points - a.points || a.rank - b.rank || b.occurrences - a.occurrences)
    .slice(0, 20);
}

(function addSearchBox() {
  const top = document.getElementById("top");
  if (!top) return;  // the printed book has no search
  const box = document.createElement("div");
  box.id = "book-search";
  box.innerHTML = '<input type="search" placeholder="Search (press /)" aria-label="Search the book"><ol></ol>';
  top.append(box);
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

// In the index of claims, powers are set as such: e^{-d N}, N^-2 and |x|^(3/2), and so are Greek letters and
// indices: eta, Gamma_0.
const greek = {alpha: "α", beta: "β", gamma: "γ", Gamma: "Γ", delta: "δ", eta: "η", theta: "θ", kappa: "κ",
               lambda: "λ", mu: "μ", pi: "π", rho: "ρ", sigma: "σ", phi: "φ", psi: "ψ", omega: "ω"};
const letter = new RegExp(`\\b(${Object.keys(greek).join("|")})(?![a-z])`, "g");
for (const element of document.querySelectorAll(".claim p, .claim summary, .claim li")) {
  for (const node of [...element.childNodes].filter(node => node.nodeType === Node.TEXT_NODE)) {
    const text = node.textContent.replace(/[&<>]/g, c => `&#${c.charCodeAt(0)};`);
    const set = text.replace(/\^(?:\{([^}]*)\}|\(([^)]*)\)|(-?\w+(?:\.\d+)?))/g, "<sup>$1$2$3</sup>")
      .replace(letter, name => greek[name]).replace(/([A-Zα-ω]|Γ)_(\w)\b/gu, "$1<sub>$2</sub>");
    if (set !== text) node.replaceWith(document.createRange().createContextualFragment(set));
  }
}

// Above the index of claims: a field that shows only claims with given words, and an order by laws.
(function addFilterOfClaims() {
  const claims = [...document.querySelectorAll(".claim")];
  if (!claims.length) return;
  const bar = document.createElement("p");
  bar.className = "claim-filter";
  bar.innerHTML = '<input type="search" placeholder="Show claims with ..." aria-label="Show claims with"> ' +
                  '<label><input type="checkbox"> sorted by law</label> <output></output>';
  claims[0].parentElement.prepend(bar);
  const [field, label, output] = bar.children, byLaw = label.firstChild, heads = [];
  for (let e = claims[0].parentElement.firstElementChild; e; e = e.nextElementSibling) {
    if (e !== bar && !claims.includes(e)) heads.push(e);
  }
  const places = claims.map(claim => claim.previousElementSibling);
  const law = claim => claim.querySelector("summary").textContent.replace(/[\d.]+/g, "");

  function show() {
    const words = field.value.toLowerCase().split(/\s+/);
    const shown = claims.filter(claim => {
      const text = (claim.textContent + claim.querySelector(".badge").title).toLowerCase();
      claim.hidden = !words.every(word => text.includes(word));
      return !claim.hidden;
    });
    output.textContent = shown.length + " of " + claims.length + " claims";
    for (const head of heads) head.hidden = byLaw.checked || field.value !== "";
    if (byLaw.checked) bar.after(...claims.toSorted((a, b) => law(a) < law(b) ? -1 : 1));
    else claims.forEach((claim, k) => places[k].after(claim));
  }
  bar.addEventListener("input", show);
  show();
})();

addEventListener("beforeprint", () => {
  for (const folded of document.querySelectorAll("figure details, .book-page details")) folded.open = true;
});
