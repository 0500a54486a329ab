// Draws a run on a canvas.

// The colours of the pictures: viridis, see svg.hpp.
const VIRIDIS = ["440154", "472d7b", "3b528b", "2c728e", "21918c", "28ae80", "5ec962", "addc30",
                 "fde725"].map(hex => [0, 2, 4].map(at => parseInt(hex.slice(at, at + 2), 16)));

function viridis(fraction) {
  const at = Math.min(Math.max(fraction, 0), 1) * (VIRIDIS.length - 1);
  const k = Math.min(Math.floor(at), VIRIDIS.length - 2);
  return `rgb(${between(VIRIDIS[k], VIRIDIS[k + 1], at - k).map(Math.round)})`;
}

// Colours of values as fractions of their largest value.
const COLOURS = {
  speed: viridis,
  spin: viridis,
  // All directions have the same lightness.
  orientation: fraction => `oklch(72% 0.12 ${360 * fraction})`,
};

const modulo = (x, period) => x - period * Math.floor(x / period);

// Values of a body that colours show, from 0 to the largest value.
const VALUES = {
  speed: body => Math.hypot(body[UX], body[UY]),
  spin: body => Math.abs(body[OMEGA]),
  orientation: (body, period) => modulo(body[THETA], period),
};

// Returns a closed curve through points (Catmull and Rom), which stays smooth in close-ups.
function smoothPath(points) {
  const path = new Path2D(), n = points.length;
  const at = k => points[(k + n) % n];
  path.moveTo(...points[0]);
  for (let k = 0; k < n; ++k) {
    const [[x0, y0], [x1, y1], [x2, y2], [x3, y3]] = [at(k - 1), at(k), at(k + 1), at(k + 2)];
    path.bezierCurveTo(x1 + (x2 - x0) / 6, y1 + (y2 - y0) / 6, x2 - (x3 - x1) / 6,
                       y2 - (y3 - y1) / 6, x2, y2);
  }
  path.closePath();
  return path;
}

// Returns what drawing a curve in its own frame requires: its path, a mark along direction 1 inside
// it, its radius, and whether half a turn leaves it as it is.
function shapeOf(points) {
  const path = smoothPath(points);
  const angle = ([x, y]) => Math.abs(Math.atan2(y, x));
  const reach = Math.hypot(...points.reduce((a, b) => angle(b) < angle(a) ? b : a));
  const mark = new Path2D();
  mark.moveTo(0.5 * reach, 0);
  mark.lineTo(0.9 * reach, 0);
  const radius = Math.max(...points.map(point => Math.hypot(...point)));
  const turns = points.every(([x, y], k) => {
    const [x1, y1] = points[(k + Math.floor(points.length / 2)) % points.length];
    return Math.hypot(x + x1, y + y1) < 1e-3 * radius;
  });
  return {path, mark, radius, turns};
}

class View {
  constructor(canvas, run) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d");
    const shapes = run.shapes.map(shapeOf);
    this.bodies = run.bodies.map(k => shapes[k]);
    this.walls = run.walls.map((k, i) => ({...shapes[k], encloses: run.encloses[i]}));
    const first = run.frames[0];
    this.walls.forEach((wall, k) => wall.moves = run.frames.some(
      frame => [X, Y, THETA].some(i => frame.walls[k][i] !== first.walls[k][i])));
    this.tops = {
      speed: largest(run.frames, frame => frame.bodies.map(VALUES.speed)),
      spin: largest(run.frames, frame => frame.bodies.map(VALUES.spin)),
      orientation: this.bodies.every(shape => shape.turns) ? Math.PI : 2 * Math.PI,
    };
    this.topForce = largest(run.frames, frame => frame.contacts.map(contact => contact[FORCE]));
    this.box = this.boxOf(run.frames);
    this.readColours();
    this.fit();
  }

  shape(k) { return k < 0 ? this.walls[-1 - k] : this.bodies[k]; }

  readColours() {
    const style = getComputedStyle(document.documentElement);
    this.colours = Object.fromEntries(
      ["fluid", "solid", "edge", "contact", "accent"].map(
        name => [name, style.getPropertyValue("--" + name).trim()]));
  }

  // Returns the box of all points that bodies and walls reach during the run.
  boxOf(frames) {
    const box = {left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity};
    const include = (state, {radius}) => {
      box.left = Math.min(box.left, state[X] - radius);
      box.right = Math.max(box.right, state[X] + radius);
      box.bottom = Math.min(box.bottom, state[Y] - radius);
      box.top = Math.max(box.top, state[Y] + radius);
    };
    for (const frame of frames.map(inCell)) {
      frame.lattice?.corners().forEach(corner => include(corner, {radius: 0}));
      frame.bodies.forEach((state, k) => include(state, this.bodies[k]));
      frame.walls.forEach((state, k) => include(state, this.walls[k]));
    }
    return box;
  }

  fit() {
    const {left, right, bottom, top} = this.box;
    this.fitted = true;
    this.x = (left + right) / 2;
    this.y = (bottom + top) / 2;
    this.scale = 0.94 * Math.min(this.canvas.clientWidth / (right - left),
                                 this.canvas.clientHeight / (top - bottom));
  }

  // Maps a point of the plane to a pixel, from the corner of the canvas; toPoint() maps back.
  toPixel(x, y) {
    return [this.canvas.clientWidth / 2 + this.scale * (x - this.x),
            this.canvas.clientHeight / 2 - this.scale * (y - this.y)];
  }

  toPoint(px, py) {
    return [this.x + (px - this.canvas.clientWidth / 2) / this.scale,
            this.y - (py - this.canvas.clientHeight / 2) / this.scale];
  }

  zoom(factor, px = this.canvas.clientWidth / 2, py = this.canvas.clientHeight / 2) {
    const [x, y] = this.toPoint(px, py);
    this.fitted = false;
    this.scale *= factor;
    this.x = x - (px - this.canvas.clientWidth / 2) / this.scale;
    this.y = y + (py - this.canvas.clientHeight / 2) / this.scale;
  }

  move(dx, dy) {
    this.fitted = false;
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
  }

  // Gives the canvas as many pixels as the screen has in its place.
  resize() {
    const ratio = window.devicePixelRatio || 1;
    const width = Math.round(this.canvas.clientWidth * ratio);
    const height = Math.round(this.canvas.clientHeight * ratio);
    if (this.canvas.width === width && this.canvas.height === height) return;
    this.canvas.width = width;
    this.canvas.height = height;
    if (this.fitted) this.fit();
  }

  // Makes the context draw in the frame of a body or wall, or in the plane; y points upwards.
  enter(state = [0, 0, 0]) {
    const ratio = window.devicePixelRatio || 1, size = ratio * this.scale;
    const c = size * Math.cos(state[THETA]), s = size * Math.sin(state[THETA]);
    const [px, py] = this.toPixel(state[X], state[Y]);
    this.context.setTransform(c, -s, -s, -c, ratio * px, ratio * py);
  }

  draw(state, {colour, contacts, picked, trail}) {
    this.resize();
    const {context, colours} = this;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    context.fillStyle = colours.fluid;
    if (!this.walls.some(wall => wall.encloses)) {
      context.fillRect(0, 0, this.canvas.width, this.canvas.height);
    }
    context.lineJoin = context.lineCap = "round";
    this.drawWalls(state);
    if (state.lattice) this.drawCell(state);
    if (trail) this.drawTrail(trail, state.lattice);
    this.drawBodies(state, colour);
    if (contacts) this.drawContacts(state, picked);
    if (picked?.part !== undefined) this.drawPicked(state, picked.part);
  }

  drawWalls(state) {
    const {context, colours} = this, pixel = 1 / this.scale;
    this.walls.forEach((wall, k) => {
      this.enter(state.walls[k]);
      context.fillStyle = wall.encloses ? colours.fluid : colours.solid;
      context.fill(wall.path);
      context.strokeStyle = colours.edge;
      if (wall.moves) {  // dashes show that it turns
        context.save();
        context.globalAlpha = 0.35;
        context.lineWidth = 6 * pixel;
        context.lineCap = "butt";
        context.setLineDash([12 * pixel, 12 * pixel]);
        context.stroke(wall.path);
        context.restore();
      }
      context.lineWidth = 1.5 * pixel;
      context.stroke(wall.path);
    });
  }

  // Draws the images of bodies that are next to a periodic cell, and the edge of the cell.
  drawCell({bodies, lattice}) {
    const {context, colours} = this, pixel = 1 / this.scale, corners = lattice.corners();
    const farthest = Math.hypot(...sum(corners[0], -1, lattice.centre));
    context.fillStyle = colours.solid;
    context.strokeStyle = colours.edge;
    context.lineWidth = 0.75 * pixel;
    context.globalAlpha = 0.5;
    for (const [i, j] of [[0, 1], [1, -1], [1, 0], [1, 1], [0, -1], [-1, 1], [-1, 0], [-1, -1]]) {
      bodies.forEach((body, k) => {
        const {path, radius} = this.bodies[k];
        const place = sum(sum(body, i, lattice.u), j, lattice.v);
        if (Math.hypot(...sum(place, -1, lattice.centre)) > farthest + radius) return;
        this.enter([...place, body[THETA]]);
        context.fill(path);
        context.stroke(path);
      });
    }
    context.globalAlpha = 1;
    this.enter();
    context.beginPath();
    for (const corner of corners) context.lineTo(...corner);
    context.closePath();
    context.setLineDash([5 * pixel, 4 * pixel]);
    context.stroke();
    context.setLineDash([]);
  }

  drawBodies(state, colour) {
    const {context, colours} = this, pixel = 1 / this.scale, top = this.tops[colour];
    state.bodies.forEach((body, k) => {
      const shape = this.bodies[k];
      const fraction = top > 0 ? VALUES[colour](body, top) / top : 0;
      this.enter(body);
      context.fillStyle = COLOURS[colour](fraction);
      context.fill(shape.path);
      context.strokeStyle = colours.edge;
      context.lineWidth = 0.75 * pixel;
      context.stroke(shape.path);
      if (shape.radius * this.scale < 4) return;  // marks are not seen
      context.strokeStyle = colour !== "orientation" && fraction < 0.6 ? "#fff" : "#000";
      context.lineWidth = Math.min(2, 0.1 * shape.radius * this.scale) * pixel;
      context.stroke(shape.mark);
    });
  }

  // Draws lines from the centres of bodies to the points where forces act. The width of a line is
  // proportional to its force.
  drawContacts(state, picked) {
    const {context, colours} = this;
    this.enter();
    state.contacts.forEach((contact, k) => {
      context.strokeStyle = picked?.contact === k ? colours.accent : colours.contact;
      context.lineWidth = Math.max(0.75, 6 * contact[FORCE] / this.topForce) / this.scale;
      for (const [x, y] of contactEnds(state, contact)) {
        context.beginPath();
        context.moveTo(x, y);
        context.lineTo(contact[CONTACT_X], contact[CONTACT_Y]);
        context.stroke();
      }
    });
  }

  drawPicked(state, part) {
    const {context, colours} = this;
    this.enter(stateIn(state, part));
    context.strokeStyle = colours.accent;
    context.lineWidth = 3 / this.scale;
    context.stroke(this.shape(part).path);
  }

  // Draws a path, which is broken where a body leaves a periodic cell.
  drawTrail(states, lattice) {
    const {context, colours} = this;
    this.enter();
    context.beginPath();
    states.forEach((state, k) => {
      const [x, y] = state, moved = sum(state, -1, states[Math.max(k - 1, 0)]);
      const jumps = lattice && Math.hypot(...moved) > 0.5 * Math.hypot(...lattice.u);
      jumps ? context.moveTo(x, y) : context.lineTo(x, y);
    });
    context.strokeStyle = colours.accent;
    context.lineWidth = 1.5 / this.scale;
    context.globalAlpha = 0.6;
    context.stroke();
    context.globalAlpha = 1;
  }

  // Returns the part under a pixel: {contact: k}, {part: k} with k < 0 for walls, or null.
  pick(state, px, py, withContacts) {
    const [x, y] = this.toPoint(px, py);
    if (withContacts) {
      const contact = state.contacts.findIndex(contact => this.isOn(state, contact, x, y));
      if (contact >= 0) return {contact};
    }
    this.context.setTransform(1, 0, 0, 1, 0, 0);
    const holds = k => this.context.isPointInPath(
      this.shape(k).path, ...carried([x, y], stateIn(state, k), [0, 0, 0]));
    for (let k = this.bodies.length - 1; k >= 0; --k) {
      const [bx, by] = state.bodies[k];
      if (Math.hypot(x - bx, y - by) <= this.bodies[k].radius && holds(k)) return {part: k};
    }
    for (let k = -this.walls.length; k < 0; ++k) {
      if (holds(k) !== this.shape(k).encloses) return {part: k};
    }
    return null;
  }

  // Returns whether a point is within some pixels of a contact's lines.
  isOn(state, contact, x, y) {
    return contactEnds(state, contact).some(([ax, ay]) => {
      const dx = contact[CONTACT_X] - ax, dy = contact[CONTACT_Y] - ay;
      const along = Math.min(Math.max(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy), 0), 1);
      return this.scale * Math.hypot(x - ax - along * dx, y - ay - along * dy) < 4;
    });
  }
}
