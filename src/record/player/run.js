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

// Returns the state of a body (k >= 0) or wall (-1, -2, ...) in a frame.
const stateIn = (frame, k) => k < 0 ? frame.walls[-1 - k] : frame.bodies[k];

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
  };
  state.contacts = near.contacts.map(([a, b, x, y, force, gap]) => {
    const carrier = a >= 0 ? a : b;
    const point = carried([x, y], stateIn(near, carrier), stateIn(state, carrier));
    return [a, b, ...point, force, gap];
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
