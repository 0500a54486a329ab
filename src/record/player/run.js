// Reads the run from the page's data blocks, and computes states between written times.

// Places in the arrays of bodies and walls, and of contacts; see animation_frame().
const X = 0, Y = 1, THETA = 2;
const UX = 3, UY = 4, OMEGA = 5;  // of bodies only; force and torque are the last three numbers
const A = 0, B = 1, CONTACT_X = 2, CONTACT_Y = 3, FORCE = 4, GAP = 5;

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
    .map(([t, bodies, walls, contacts]) => ({t, bodies, walls, contacts}));
  return run;
}

// The state of a body (k >= 0) or wall (-1, -2, ...) in a frame.
const stateIn = (frame, k) => k < 0 ? frame.walls[-1 - k] : frame.bodies[k];

const between = (from, to, part) => from.map((x, i) => x + part * (to[i] - x));

// A point of the plane in the frame of a body or wall, and back.
function toLocal(state, x, y) {
  const c = Math.cos(state[THETA]), s = Math.sin(state[THETA]);
  const dx = x - state[X], dy = y - state[Y];
  return [c * dx + s * dy, c * dy - s * dx];
}

function toPlane(state, x, y) {
  const c = Math.cos(state[THETA]), s = Math.sin(state[THETA]);
  return [state[X] + c * x - s * y, state[Y] + s * x + c * y];
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
  };
  state.contacts = near.contacts.map(contact => {
    const carrier = contact[A] >= 0 ? contact[A] : contact[B];
    const local = toLocal(stateIn(near, carrier), contact[CONTACT_X], contact[CONTACT_Y]);
    const [x, y] = toPlane(stateIn(state, carrier), ...local);
    return [contact[A], contact[B], x, y, contact[FORCE], contact[GAP]];
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
