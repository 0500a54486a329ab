// Interactive figures: the reader changes settings, and a drawing and its numbers follow. Scripts of figures
// are loaded after this script, and call figures.add().
window.figures ??= (() => {
  const known = {};  // name -> functions of the first such figure on the page

  function powerOfTen(power) {
    return "10" + [...String(power)].map(c => c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c]).join("");
  }

  // Returns a number as text, with four significant digits.
  function text(value) {
    if (!Number.isFinite(value)) return "not finite";
    const size = Math.abs(value);
    if (size === 0 || size >= 0.001 && size < 1e5) {
      return String(Number.isInteger(value) ? value : Number(value.toPrecision(4))).replace("-", "−");
    }
    const [digits, power] = value.toExponential(3).split("e");
    return digits.replace("-", "−") + " · " + powerOfTen(Number(power));
  }

  function attributes(values = {}) {
    return Object.entries(values).map(([name, value]) => ` ${name}="${value}"`).join("");
  }

  // A rectangle of the drawing with coordinates of its own: x and y are [from, to]; y may be logarithmic.
  // Methods that draw return SVG. Colours are classes: "line-0", "line-1", "line-2", or "" for the text's.
  class Panel {
    constructor({left, top, width, height}, x, y, {log = false} = {}) {
      Object.assign(this, {left, top, width, height, x, y, log});
    }

    // Maps a point to a pixel; toPoint() maps back.
    toPixel([x, y]) {
      const height = this.log ? v => Math.log(Math.max(v, 1e-300)) : v => v;
      const [low, high] = this.y.map(height);
      return [this.left + this.width * (x - this.x[0]) / (this.x[1] - this.x[0]),
              this.top + this.height * (high - height(y)) / (high - low)];
    }

    toPoint([left, top]) {
      const up = (this.top + this.height - top) / this.height;
      return [this.x[0] + (this.x[1] - this.x[0]) * (left - this.left) / this.width,
              this.log ? this.y[0] * (this.y[1] / this.y[0]) ** up : this.y[0] + (this.y[1] - this.y[0]) * up];
    }

    path(points, closed = false) {
      return "M" + points.map(point => this.toPixel(point).map(v => v.toFixed(1)).join(" ")).join("L") +
             (closed ? "Z" : "");
    }

    line(points, colour = "", more = {}) {
      return `<g class="${colour}"><path d="${this.path(points)}" fill="none" stroke="currentColor" ` +
             `stroke-width="1.8"${attributes(more)}/></g>`;
    }

    area(points, colour = "", more = {}) {
      return `<g class="${colour}"><path d="${this.path(points, true)}" fill="currentColor" ` +
             `fill-opacity="0.15"${attributes(more)}/></g>`;
    }

    dots(points, colour = "", radius = 3.5) {
      return `<g class="${colour}" fill="currentColor">` + points.map(point => {
        const [x, y] = this.toPixel(point);
        return `<circle cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="${radius}"/>`;
      }).join("") + "</g>";
    }

    cross([x, y], colour = "", size = 5) {
      const [left, top] = this.toPixel([x, y]).map(v => Number(v.toFixed(1)));
      return `<g class="${colour}"><path d="M${left - size} ${top - size}l${2 * size} ${2 * size}m0 ${-2 * size}` +
             `l${-2 * size} ${2 * size}" fill="none" stroke="currentColor" stroke-width="2.2"/></g>`;
    }

    arrow(from, to, colour = "", width = 1.6) {
      const [[x0, y0], [x1, y1]] = [this.toPixel(from), this.toPixel(to)];
      const length = Math.hypot(x1 - x0, y1 - y0);
      if (length < 1) return "";
      const size = Math.min(8, 0.5 * length), [u, v] = [(x1 - x0) * size / length, (y1 - y0) * size / length];
      const at = (x, y) => x.toFixed(1) + " " + y.toFixed(1);
      return `<g class="${colour}" fill="currentColor"><path d="M${at(x0, y0)}L${at(x1 - 0.8 * u, y1 - 0.8 * v)}" ` +
             `stroke="currentColor" stroke-width="${width}"/><path d="M${at(x1, y1)}L${at(x1 - u - 0.45 * v,
             y1 - v + 0.45 * u)}L${at(x1 - u + 0.45 * v, y1 - v - 0.45 * u)}Z"/></g>`;
    }

    // Writes beside a point; more may hold the shifts dx and dy in pixels, and text-anchor.
    label([x, y], words, colour = "", more = {}) {
      const [left, top] = this.toPixel([x, y]);
      return `<g class="${colour}"><text x="${left.toFixed(1)}" y="${top.toFixed(1)}" ` +
             `fill="currentColor"${attributes(more)}>${words}</text></g>`;
    }

    // Draws a frame with marks at values of x and y.
    axes(xs, ys, xName = "", yName = "") {
      const bottom = this.log ? this.y[0] : Math.min(...this.y);
      const marks = [
        ...xs.map(x => this.label([x, bottom], text(x), "", {dy: 16, "text-anchor": "middle"})),
        ...ys.map(y => this.label([this.x[0], y], this.log ? powerOfTen(Math.round(Math.log10(y))) : text(y), "",
                                  {dx: -6, dy: 4, "text-anchor": "end"})),
        this.label([this.x[1], bottom], xName, "", {dy: 32, "text-anchor": "end"}),
        this.label([this.x[0], this.y[1]], yName, "", {dx: 2, dy: -6})];
      return `<rect x="${this.left}" y="${this.top}" width="${this.width}" height="${this.height}" fill="none" ` +
             `stroke="currentColor" stroke-opacity="0.4"/><g opacity="0.85">${marks.join("")}</g>`;
    }
  }

  function element(html) {
    const holder = document.createElement("template");
    holder.innerHTML = html;
    return holder.content.firstElementChild;
  }

  // Makes a slider; change() gets its new value. Returns the element and a function that shows a value.
  function slider([label, from, to, step], change) {
    const control = element(`<label><span>${label}</span><input type="range" min="${from}" max="${to}" ` +
                            `step="${step}"><output></output></label>`);
    const [, input, output] = control.children;
    input.addEventListener("input", () => change(Number(input.value)));
    return [control, value => { input.value = value; output.textContent = text(value); }];
  }

  // Makes a row of buttons; the value is the number of the pressed one, from 0 on.
  function choice([label, names], change) {
    const control = element(`<div role="group"><span>${label}</span><div></div></div>`);
    const buttons = names.map(name => element(`<button type="button">${name}</button>`));
    buttons.forEach((button, k) => button.addEventListener("click", () => change(k)));
    control.lastChild.append(...buttons);
    return [control, value => buttons.forEach((button, k) => button.setAttribute("aria-pressed", k === value))];
  }

  // Makes a point that mouse, finger and arrow keys move: handle.to(settings, point) returns the settings that
  // change. If handle.anywhere, a press anywhere on its panel moves it there.
  function grip(svg, handle, settings, set) {
    const {panel, step} = handle;
    svg.insertAdjacentHTML("beforeend", `<g class="handle" tabindex="0" role="slider" aria-label="${handle.label}" ` +
                           'aria-valuenow="0"><circle r="22" fill-opacity="0"/><circle class="grip" r="8"/></g>');
    const dot = svg.lastElementChild;
    let held = false;
    const move = point => set(handle.to(settings, point));
    function follow(event) {
      const {a, d, e, f} = svg.getScreenCTM();
      move(panel.toPoint([(event.clientX - e) / a, (event.clientY - f) / d]));
    }
    function press(event) {
      event.preventDefault();
      held = true;
      dot.setPointerCapture(event.pointerId);
      dot.focus({preventScroll: true});
      follow(event);
    }
    dot.addEventListener("pointerdown", event => { event.stopPropagation(); press(event); });
    dot.addEventListener("pointermove", event => held && follow(event));
    for (const end of ["pointerup", "pointercancel"]) dot.addEventListener(end, () => held = false);
    dot.addEventListener("keydown", event => {
      const way = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
      if (!way) return;
      event.preventDefault();
      const size = step * (event.shiftKey ? 5 : 1), at = handle.at(settings);
      move(at.map((v, k) => v + size * way[k]));
    });
    if (handle.anywhere) {
      svg.addEventListener("pointerdown", event => {
        const {a, d, e, f} = svg.getScreenCTM();
        const [left, top] = [(event.clientX - e) / a - panel.left, (event.clientY - f) / d - panel.top];
        if (left >= 0 && top >= 0 && left <= panel.width && top <= panel.height) press(event);
      });
    }
    return () => {
      const at = handle.at(settings);
      dot.setAttribute("transform", `translate(${panel.toPixel(at).map(v => v.toFixed(1)).join(" ")})`);
      dot.setAttribute("aria-valuetext", at.map(text).join(", "));
    };
  }

  function start(name, root, figure) {
    const settings = {...figure.settings}, follow = [];
    const svg = root.querySelector("svg"), drawing = svg.querySelector(".drawing");
    const list = root.querySelector(".numbers"), title = svg.querySelector("title");
    const controls = element('<div class="controls"></div>');

    function set(changes) {
      for (const [key, value] of Object.entries(changes)) {
        const [, from, to, step] = figure.sliders?.[key] ?? [];
        settings[key] = from === undefined ? value :
          Math.min(to, Math.max(from, Number((from + step * Math.round((value - from) / step)).toFixed(10))));
      }
      const numbers = figure.numbers(settings);
      drawing.innerHTML = figure.draw(settings, numbers).join("");
      list.innerHTML = Object.entries(figure.shown).map(([key, label]) =>
        `<span>${label} <output data-number="${key}">${text(numbers[key])}</output></span>`).join(" ");
      for (const show of follow) show();
    }

    // Each control changes one setting and shows its value.
    function add(key, [control, show]) {
      controls.append(control);
      follow.push(() => {
        show(settings[key]);
        control.hidden = figure.when?.[key]?.(settings) === false;
      });
    }
    for (const [key, choose] of Object.entries(figure.choices ?? {})) {
      add(key, choice(choose, value => set({[key]: value})));
    }
    for (const [key, slide] of Object.entries(figure.sliders ?? {})) {
      add(key, slider(slide, value => set({[key]: value})));
    }
    for (const handle of figure.handles ?? []) follow.push(grip(svg, handle, settings, set));

    svg.setAttribute("role", "group");
    if (title) {  // browsers show a title over the drawing while the mouse rests
      svg.setAttribute("aria-label", title.textContent);
      title.remove();
    }
    list.setAttribute("aria-live", "polite");
    root.append(controls);
    set({});
    known[name] ??= {set, still: () => drawing.innerHTML, numbers: figure.numbers, list};
  }

  return {
    Panel, text,

    // Shows a figure in each <div class="interactive" data-figure="name"> of the page:
    //   settings   name -> value at the start; all values are numbers
    //   sliders    setting -> [label, from, to, step]
    //   choices    setting -> [label, names of the buttons]
    //   when       setting -> function(settings) that returns whether its slider or buttons have an effect
    //   handles    [{panel, label, step, at(settings) -> point, to(settings, point) -> settings, anywhere}]
    //   shown      name of a number -> its label
    //   numbers    function(settings) -> numbers by name
    //   draw       function(settings, numbers) -> list of SVG texts
    add(name, figure) {
      for (const root of document.querySelectorAll(`.interactive[data-figure="${name}"]`)) {
        if (!root.dataset.started) start(name, root, figure);
        root.dataset.started = "yes";
      }
    },

    names: () => Object.keys(known),

    // For tests: applies settings to a figure of the page and returns the texts of the numbers that it shows.
    show(name, settings) {
      known[name].set(settings);
      return Object.fromEntries([...known[name].list.querySelectorAll("output")]
        .map(output => [output.dataset.number, output.textContent]));
    },
    still: name => [known[name].still(), known[name].list.innerHTML],
  };
})();
