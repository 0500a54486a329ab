// Controls the player: time, keys, pointer and numbers.

const element = id => document.getElementById(id);

class Player {
  constructor(run) {
    this.run = run;
    this.frames = run.frames;
    this.view = new View(element("canvas"), run);
    this.place = 0;       // a place in the list of frames
    this.playing = false;
    this.pinned = null;   // the part that a click or key has picked
    this.hovered = null;  // the part under the pointer
    this.pointer = null;  // the last pixel of the pointer
    const length = this.frames.at(-1).t - this.frames[0].t;
    // At speed 1 a run plays at 15 frames a second, but takes at least 4 and at most 20 seconds.
    this.rate = length / Math.min(20, Math.max(4, this.frames.length / 15));
    const spacing = length / Math.max(1, this.frames.length - 1) || 1;
    this.decimals = Math.min(12, Math.max(0, 2 - Math.floor(Math.log10(spacing))));
    this.fillPage();
    this.listen();
    this.show();
  }

  get frame() { return Math.round(this.place); }
  get state() { return inCell(stateAt(this.frames, this.place)); }
  get picked() { return this.hovered || this.pinned; }

  fillPage() {
    document.title = element("title").textContent = this.run.title || "Run without a title";
    document.documentElement.classList.toggle("embedded", window.top !== window);
    element("scrub").max = this.frames.length - 1;
    for (const id of ["play", "scrub"]) element(id).disabled = this.frames.length < 2;
    element("contacts-label").hidden = this.view.topForce === 0;
    element("canvas").setAttribute("aria-label", `${document.title}, ` +
      `bodies: ${this.run.bodies.length}, walls: ${this.run.walls.length}`);
    element("legend").hidden = this.run.bodies.length === 0;
    this.fillLegend();
  }

  fillLegend() {
    const colour = element("colour").value;
    element("legend-name").textContent = {speed: "speed |U|", spin: "angular speed |\u03c9|",
                                          orientation: "orientation \u03b8"}[colour];
    const ramp = Array.from({length: 65}, (_, k) => COLOURS[colour](k / 64));
    element("ramp").style.background = `linear-gradient(90deg, ${ramp})`;
    const top = this.view.tops[colour];
    element("high").textContent = colour !== "orientation" ? short(top, 3)
                                : top > Math.PI ? "2\u03c0" : "\u03c0";
  }

  // Draws before the next image of the screen, however often it is called.
  show() {
    this.waiting ??= requestAnimationFrame(now => {
      this.waiting = null;
      this.advance(now);
      this.draw();
      if (this.playing) this.show();
    });
  }

  draw() {
    const state = this.state;
    if (this.pointer) this.hovered = this.view.pick(state, ...this.pointer, this.showsContacts());
    // Contacts of other frames may be others.
    if (this.pinned?.contact !== undefined && this.pinned.frame !== this.frame) this.pinned = null;
    const picked = this.picked;
    const trail = picked && picked.part >= 0 &&
      this.frames.map(frame => inCell(frame).bodies[picked.part]);
    this.view.draw(state, {colour: element("colour").value, contacts: this.showsContacts(), picked,
                           trail});
    element("canvas").classList.toggle("on-something", Boolean(this.hovered));
    element("time").textContent = `t = ${state.t.toFixed(this.decimals)}`;
    element("count").textContent = `frame ${this.frame} of ${this.frames.length - 1}`;
    element("scrub").value = this.place;
    element("scrub").setAttribute("aria-valuetext", element("time").textContent);
    this.showNumbers(state, picked);
  }

  showsContacts() { return element("contacts").checked; }

  advance(now) {
    const passed = this.last === undefined ? 0 : (now - this.last) / 1000;
    this.last = now;
    if (!this.playing) return;
    const end = this.frames.at(-1).t;
    const t = this.state.t + passed * this.rate * Number(element("speed").value);
    if (t < end) {
      this.place = placeOf(this.frames, t);
    } else if (element("loop").checked) {
      this.place = 0;
    } else {
      this.place = this.frames.length - 1;
      this.pause();
    }
  }

  play() {
    if (this.frames.length < 2) return;
    if (this.place === this.frames.length - 1) this.place = 0;
    this.last = undefined;
    this.setPlaying(true);
  }

  pause() { this.setPlaying(false); }

  setPlaying(playing) {
    this.playing = playing;
    element("play").classList.toggle("playing", playing);
    element("play").setAttribute("aria-label", playing ? "Pause" : "Play");
    element("numbers").setAttribute("aria-live", playing ? "off" : "polite");
    this.show();
  }

  // Goes to a frame and stays there.
  seek(frame) {
    this.place = Math.min(Math.max(Math.round(frame), 0), this.frames.length - 1);
    this.pause();
  }

  // Picks the next body (step 1) or the one before (-1).
  pickNext(step) {
    const n = this.run.bodies.length;
    if (n === 0) return;
    const now = this.pinned?.part >= 0 ? this.pinned.part : step > 0 ? -1 : n;
    this.pinned = {part: (now + step + n) % n};
    this.pointer = this.hovered = null;
  }

  // Returns the name of a part, and the rows of its numbers.
  rowsOf(state, {part, contact}) {
    const pair = (x, y) => `(${short(x)}, ${short(y)})`;
    const name = k => k < 0 ? `wall ${-1 - k}` : `body ${k}`;
    if (contact !== undefined) {
      const found = state.contacts[contact];
      return [`contact of ${name(found[A])} and ${name(found[B])}`, ["force", short(found[FORCE])],
              ["gap", short(found[GAP])], ["at", pair(found[CONTACT_X], found[CONTACT_Y])]];
    }
    const found = stateIn(state, part), [fx, fy, torque] = found.slice(-3);
    const motion = part < 0 ? [] : [["velocity", pair(found[UX], found[UY])],
                                    ["angular velocity", short(found[OMEGA])]];
    return [name(part), ["position", pair(found[X], found[Y])],
            ["orientation", short(found[THETA])], ...motion,
            ["force on fluid", pair(fx, fy)], ["torque on fluid", short(torque)]];
  }

  // Shows the numbers of a part beside the pointer, or in the corner if a click has picked it.
  showNumbers(state, picked) {
    const box = element("numbers");
    box.hidden = !picked;
    if (!picked) return;
    const [title, ...rows] = this.rowsOf(state, picked);
    const lines = rows.map(([name, value]) => `<tr><td>${name}</td><td>${value}</td></tr>`);
    box.innerHTML = `<b>${title}</b><table>${lines.join("")}</table>`;
    const {clientWidth, clientHeight} = element("canvas");
    let [left, top] = [8, 8];
    if (this.hovered) {
      const [x, y] = this.pointer;
      left = x + 18 + box.offsetWidth < clientWidth ? x + 18 : x - 18 - box.offsetWidth;
      top = Math.min(y + 12, clientHeight - box.offsetHeight - 4);
    }
    box.style.left = `${Math.max(4, left)}px`;
    box.style.top = `${Math.max(4, top)}px`;
  }

  listen() {
    const on = (id, event, action) => element(id).addEventListener(event, action);
    const buttons = {play: " ", in: "+", out: "-", fit: "0"};
    for (const [id, key] of Object.entries(buttons)) on(id, "click", () => this.act(key));
    on("scrub", "input", () => this.seek(element("scrub").valueAsNumber));
    on("contacts", "change", () => this.show());
    on("colour", "change", () => {
      this.fillLegend();
      this.show();
    });
    document.addEventListener("keydown", event => this.key(event));
    new ResizeObserver(() => this.show()).observe(element("stage"));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
      this.view.readColours();
      this.show();
    });
    this.listenToPointer(element("canvas"));
  }

  key(event) {
    const target = event.target.tagName;
    if (event.ctrlKey || event.metaKey || event.altKey || target === "SELECT") return;
    if (event.key === " " && (target === "BUTTON" || event.target.type === "checkbox")) return;
    if (this.act(event.key)) event.preventDefault();
  }

  // Does what a key stands for, and returns whether the key stands for anything.
  act(key) {
    const actions = {
      " ": () => this.playing ? this.pause() : this.play(),
      ArrowRight: () => this.seek(Math.floor(this.place) + 1),
      ArrowLeft: () => this.seek(Math.ceil(this.place) - 1),
      Home: () => this.seek(0),
      End: () => this.seek(this.frames.length - 1),
      "+": () => this.view.zoom(1.4),
      "-": () => this.view.zoom(1 / 1.4),
      0: () => this.view.fit(),
      "]": () => this.pickNext(1),
      "[": () => this.pickNext(-1),
      Escape: () => { this.pinned = null; },
    };
    if (!Object.hasOwn(actions, key)) return false;
    actions[key]();
    this.show();
    return true;
  }

  listenToPointer(canvas) {
    let drag = null;
    const pixel = event => [event.offsetX, event.offsetY];
    canvas.addEventListener("pointerdown", event => {
      drag = {at: pixel(event), moved: false};
      this.pointer = drag.at;
      canvas.setPointerCapture(event.pointerId);
      this.show();
    });
    canvas.addEventListener("pointermove", event => {
      const at = pixel(event);
      if (drag && (drag.moved || Math.hypot(at[0] - drag.at[0], at[1] - drag.at[1]) > 3)) {
        this.view.move(at[0] - drag.at[0], at[1] - drag.at[1]);
        drag = {at, moved: true};
      }
      this.pointer = at;
      canvas.classList.toggle("moving", Boolean(drag && drag.moved));
      this.show();
    });
    canvas.addEventListener("pointerup", event => {
      if (drag && !drag.moved) {
        const picked = this.view.pick(this.state, ...drag.at, this.showsContacts());
        this.pinned = picked && {...picked, frame: this.frame};
      }
      drag = null;
      canvas.classList.remove("moving");
      if (event.pointerType !== "mouse") this.pointer = this.hovered = null;
      this.show();
    });
    for (const end of ["pointerleave", "pointercancel"]) {
      canvas.addEventListener(end, () => {
        drag = this.pointer = this.hovered = null;
        this.show();
      });
    }
    // Inside another page the wheel scrolls that page, unless the animation has been clicked.
    canvas.addEventListener("wheel", event => {
      if (window.top !== window && !event.ctrlKey && document.activeElement !== canvas) return;
      event.preventDefault();
      this.view.zoom(Math.exp(-0.0015 * event.deltaY), ...pixel(event));
      this.show();
    }, {passive: false});
  }
}

document.addEventListener("DOMContentLoaded", () => {
  const run = readRun();
  if (run.frames.length === 0) {
    element("title").textContent = `${run.title}: no frame is written yet`;
    return;
  }
  window.player = new Player(run);
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) window.player.play();
});
