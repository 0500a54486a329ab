// Chapters 09 to 12: forces press two disks together and then pull them apart; steps follow the gap.
{
  const half = 4, end = 2 * half;  // the forces turn round at `half`
  const plane = new figures.Panel({left: 10, top: 24, width: 500, height: 130}, [-5, 5], [-1.3, 1.3]);
  const gaps = new figures.Panel({left: 68, top: 196, width: 432, height: 230}, [0, end], [1e-3, 10], {log: true});

  // The closing speed of unit disks under the forces 4 pi mu; for narrow gaps it tends to (00.14), 8/3 gap^1.5.
  function speed(gap) {
    const alpha = 2 * Math.asinh(Math.sqrt(gap / 4));
    return 2 * alpha - Math.tanh(2 * alpha);
  }
  const rate = (t, gap) => (t < half ? -1 : 1) * speed(gap);

  // Exact gaps at many times: small steps of the classical Runge-Kutta method for the logarithm of the gap.
  function exactPath(start) {
    const count = 400, dt = half / count, path = [start];
    const f = log => -speed(Math.exp(log)) / Math.exp(log);
    let log = Math.log(start);
    for (let k = 0; k < count; ++k) {
      const k1 = f(log), k2 = f(log + dt / 2 * k1), k3 = f(log + dt / 2 * k2), k4 = f(log + dt * k3);
      log += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      path.push(Math.exp(log));
    }
    return [...path, ...path.slice(0, -1).reverse()].map((gap, k) => [k * dt, gap]);
  }

  // Euler's steps of equal length. They end where the disks overlap.
  function fixedPath(start, steps) {
    const path = [[0, start]];
    for (let k = 0; k < 2 * steps && path.at(-1)[1] > 0; ++k) {
      const [, gap] = path.at(-1), t = half * k / steps;
      path.push([half * (k + 1) / steps, gap + half / steps * rate(t, gap)]);
    }
    return path;
  }

  // Bogacki and Shampine's pair with the control (09.10). Steps that overlap are halved, as in chapter 09.
  function controlledPath(start, tolerance) {
    const path = [[0, start]];
    let length, previous = 1;
    for (const [from, event, sign] of [[0, half, -1], [half, end, 1]]) {
      let [t, gap] = [from, path.at(-1)[1]];
      const f = value => value > 0 ? sign * speed(value) : NaN;
      if (!length) {
        const trial = 0.01 / Math.abs(f(gap));
        const second = Math.abs(f(gap + trial * f(gap)) - f(gap)) / (tolerance * trial * f(gap) ** 2);
        length = Math.min(100 * trial, Math.cbrt(0.01 / Math.max(1 / tolerance, second)) / Math.abs(f(gap)));
      }
      while (t < event) {
        const k1 = f(gap);
        for (let tries = 0; ; ++tries) {
          const count = Math.ceil((event - t) / length - 1e-9);
          const stop = count > 1 ? t + (event - t) / count : event, dt = stop - t;
          const k2 = f(gap + dt / 2 * k1), k3 = f(gap + 0.75 * dt * k2);
          const next = gap + dt * (2 / 9 * k1 + k2 / 3 + 4 / 9 * k3), k4 = f(next);
          if (Number.isNaN(k2 + k3 + k4)) {
            length = dt / 2;
          } else {
            const error = Math.abs(dt * (-5 / 72 * k1 + k2 / 12 + k3 / 9 - k4 / 8)) / tolerance;
            const ideal = 0.9 * Math.max(previous, 1e-4) ** (0.4 / 3) * error ** (-0.7 / 3);
            const factor = Math.min(5, Math.max(0.2, ideal));
            if (error <= 1) {
              if (dt >= 0.5 * length) {  // not cut short by the event
                length = dt * (tries > 0 ? Math.min(factor, 1) : factor);
                previous = error;
              }
              [t, gap] = [stop, next];
              path.push([t, gap]);
              break;
            }
            length = dt * factor;
          }
        }
      }
    }
    return path;
  }

  const at = (path, time) => {  // on the straight line between two points
    const k = path.findIndex(([t]) => t >= time), [[t0, a], [t1, b]] = [path[Math.max(k - 1, 0)], path.at(k)];
    return k < 0 || t1 === t0 ? path.at(-1)[1] : k === 0 ? a : a + (b - a) * (time - t0) / (t1 - t0);
  };
  const gapAt = (path, time) => path.find(([t]) => t >= time)?.[1] ?? path.at(-1)[1];

  figures.add("disks", {
    settings: {time: 2, gap: 1, count: 8, digits: 3},
    sliders: {gap: ["gap at the start, in radii", 0.05, 3, 0.05], count: ["fixed steps until the turn", 1, 100, 1],
              digits: ["tolerance 10<sup>−<i>q</i></sup>: <i>q</i>", 1, 7, 0.5]},
    handles: [{panel: gaps, label: "time", step: 0.2, at: ({time, gap}) => [time, at(exactPath(gap), time)],
               to: (_, [time]) => ({time: Math.min(end, Math.max(0, time))})}],
    shown: {speed: "closing speed at this time", least: "least gap: exact", fixed: "by fixed steps",
            controlled: "by the tolerance", back: "gap at the end: by fixed steps",
            returned: "by the tolerance", step: "length of a fixed step",
            taken: "number of steps by the tolerance"},

    numbers({time, gap, count, digits}) {
      const fixed = fixedPath(gap, count), controlled = controlledPath(gap, 10 ** -digits);
      return {speed: speed(at(exactPath(gap), time)), least: exactPath(gap)[400][1],
              fixed: gapAt(fixed, half), controlled: gapAt(controlled, half), back: fixed.at(-1)[1],
              returned: controlled.at(-1)[1], step: half / count, taken: controlled.length - 1};
    },

    draw({time, gap, count, digits}) {
      const exact = exactPath(gap), fixed = fixedPath(gap, count), path = controlledPath(gap, 10 ** -digits);
      const turn = Array.from({length: 61}, (_, k) => Math.PI * k / 30);
      const circle = x => turn.map(angle => [x + Math.cos(angle), Math.sin(angle)]);
      const apart = at(exact, time) / 2 + 1, wrong = at(fixed, time) / 2 + 1, push = time < half ? -1 : 1;
      const floor = points => points.map(([t, value]) => [t, Math.max(value, 1e-3)]);
      const words = fixed.at(-1)[1] > 0 ? "" :
        fixed.at(-1)[1] < -4 ? "the disks have changed places" : "the disks overlap";
      const law = exact.slice(0, 401).map(([t]) => [t, (1 / Math.sqrt(gap) + 4 / 3 * t) ** -2]);
      return [
        ...[-1, 1].flatMap(side => [
          plane.area(circle(side * apart)), plane.line(circle(side * apart)),
          plane.line(circle(side * wrong), "line-1", {"stroke-dasharray": "5 4", "stroke-width": 1.4}),
          plane.arrow([side * apart, 0], [side * (apart + 0.7 * push), 0], "", 2)]),
        gaps.axes([0, 2, 4, 6, 8], [1e-3, 0.01, 0.1, 1, 10], "time", "gap"),
        gaps.line([[half, 1e-3], [half, 10]], "", {"stroke-dasharray": "2 4", "stroke-width": 1}),
        gaps.line(law, "", {"stroke-dasharray": "6 4", "stroke-width": 1}),
        gaps.line(exact.filter((_, k) => k % 10 === 0)),
        gaps.line(floor(fixed), "line-1", {"stroke-width": 1.2}), gaps.dots(floor(fixed), "line-1", 3),
        gaps.dots(floor(path), "line-0", 3),
        gaps.label([0, 10], "exact", "", {dx: 40, dy: -6}),
        gaps.label([0, 10], "narrow gaps (dashed)", "", {dx: 84, dy: -6}),
        gaps.label([0, 10], "fixed steps", "line-1", {dx: 232, dy: -6}),
        gaps.label([0, 10], "steps by a tolerance", "line-0", {dx: 308, dy: -6}),
        gaps.label([half, 1e-3], words, "line-1", {dx: 8, dy: -10}),
      ];
    },
  });
}
