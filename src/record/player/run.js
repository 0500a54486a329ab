// Reads the run from the page's data blocks, and computes states between written times.

// Places in the arrays of bodies and walls, and of contacts; see animation_frame().
const X = 0, Y = 1, THETA = 2;
const UX = 3, UY = 4, OMEGA = 5;  // of bodies only; force and torque are the last three numbers
const A = 0, B = 1, CONTACT_X = 2, CONTACT_Y = 3, FORCE = 4, GAP = 5;

const sum = ([x, y], s, [u, v]) => [x + s * u, y + s * v];
const dot = ([x, y], [u, v]) => x * u + y * v;
const cross = ([x, y], [u, v]) => x * v - y * u;

// The lattice of a periodic cell: its centre and the reduced basis, see Lattice in lattice.hpp.
class Lattice {
  constructor([x, y, ...basis]) {
    this.centre = [x, y];
    let u = basis.slice(0, 2), v = basis.slice(2);
    while (dot(v = sum(v, -Math.round(dot(u, v) / dot(u, u)), u), v) < dot(u, u)) [u, v] = [v, u];
    [this.u, this.v] = [u, cross(u, v) < 0 ? v.map(x => -x) : v];
  }

  // Returns the image of a point that is nearest to another point.
  near(point, to) {
    const {u, v} = this, z = sum(point, -1, to), area = cross(u, v);
    const s = Math.floor(cross(z, v) / area), t = Math.floor(cross(u, z) / area);
    const images = [[s, t], [s + 1, t], [s, t + 1], [s + 1, t + 1]].map(
      ([i, j]) => sum(sum(z, -i, u), -j, v));
    return sum(to, 1, images.reduce((a, b) => dot(b, b) < dot(a, a) ? b : a));
  }

  // Returns the corners of the Voronoi cell about the centre.
  corners() {
    const {u, v} = this, acute = dot(u, v) >= 0;
    const sides = [u, acute ? v : sum(u, 1, v), acute ? sum(v, -1, u) : v, u.map(x => -x)];
    const corners = [0, 1, 2].map(k => {
      const [a, b] = [sides[k], sides[k + 1]], [p, q] = [dot(a, a), dot(b, b)];
      return [p * b[1] - q * a[1], q * a[0] - p * b[0]].map(x => 0.5 * x / cross(a, b));
    });
    return [1, -1].flatMap(sign => corners.map(corner => sum(this.centre, sign, corner)));
  }
}

// Replaces bodies and contacts of a state by their images in its periodic cell, if it has one. The
// last two numbers of a contact become the place of the second body's image in contact.
function inCell(state) {
  if (!state.cell) return state;
  const lattice = new Lattice(state.cell);
  const bodies = state.bodies.map(
    body => [...lattice.near(body, lattice.centre), ...body.slice(THETA)]);
  const contacts = state.contacts.map(([a, b, x, y, force, gap, i, j]) => {
    const moved = sum(bodies[a], -1, state.bodies[a]);
    const image = sum(sum(state.bodies[b], i, state.cell.slice(2, 4)), j, state.cell.slice(4));
    return [a, b, ...sum([x, y], 1, moved), force, gap, ...sum(image, 1, moved)];
  });
  return {...state, bodies, contacts, lattice};
}

function parsed(block) {
  try {
    return JSON.parse(block.textContent);
  } catch {
    return null;  // the last block is incomplete: the page was not copied to its end
  }
}

function readRun() {
  const run = parsed(document.querySelector(".run"));
  run.frames = [...document.querySelectorAll(".frame")].map(parsed).filter(frame => frame)
    .map(([t, bodies, walls, contacts, cell]) => ({t, bodies, walls, contacts, cell}));
  return run;
}

// Returns the state of a body (k >= 0) or wall (-1, -2, ...) in a frame.
const stateIn = (frame, k) => k < 0 ? frame.walls[-1 - k] : frame.bodies[k];

// Returns the places of the bodies in contact; in a periodic cell, that of the second one's image.
const contactEnds = ({bodies}, [a, b, , , , , ...image]) =>
  [bodies[a], image.length ? image : bodies[b]].filter(place => place);

const between = (from, to, part) => from.map((x, i) => x + part * (to[i] - x));

// Returns where a point goes that moves with a body or wall from one state to another.
function carried([x, y], from, to) {
  const turn = to[THETA] - from[THETA], c = Math.cos(turn), s = Math.sin(turn);
  const dx = x - from[X], dy = y - from[Y];
  return [to[X] + c * dx - s * dy, to[Y] + s * dx + c * dy];
}

// Returns the state at a place in the list of frames, linear between two frames: angles are not
// wrapped. Contacts are those of the nearest frame, and their points move with the first party, or
// with the second if the first is a wall.
function stateAt(frames, place) {
  const k = Math.min(Math.floor(place), frames.length - 1), part = place - k;
  const near = frames[Math.round(place)];
  if (part === 0) return near;
  const from = frames[k], to = frames[k + 1];
  const state = {
    t: from.t + part * (to.t - from.t),
    bodies: from.bodies.map((body, i) => between(body, to.bodies[i], part)),
    walls: from.walls.map((wall, i) => between(wall, to.walls[i], part)),
    cell: from.cell && between(from.cell, to.cell, part),
  };
  state.contacts = near.contacts.map(([a, b, x, y, ...values]) => {
    const carrier = a >= 0 ? a : b;
    const point = carried([x, y], stateIn(near, carrier), stateIn(state, carrier));
    return [a, b, ...point, ...values];
  });
  return state;
}

// Returns the place in the list of frames that belongs to a time, not before the first frame.
function placeOf(frames, t) {
  const k = frames.findLastIndex(frame => frame.t <= t), next = frames[k + 1];
  return next ? k + (t - frames[k].t) / (next.t - frames[k].t) : k;
}

const largest = (frames, of) =>
  frames.reduce((most, frame) => of(frame).reduce((m, x) => Math.max(m, x), most), 0);

// Returns a number with few digits and a typographic minus sign.
const short = (x, digits = 5) => String(Number(x.toPrecision(digits))).replace("-", "\u2212");
