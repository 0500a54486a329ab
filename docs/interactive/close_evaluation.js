// The double layer of an ellipse at targets close to it, by the three ways of chapter 06. Vectors [x, y] are also
// complex numbers. Called by close.js.
window.closeEvaluation ??= (() => {
  const {PI} = Math;
  const semi = [1, 0.5];  // semi-axes; the fluid is outside

  const times = ([a, b], [c, d]) => [a * c - b * d, a * d + b * c];
  const over = ([a, b], [c, d]) => [(a * c + b * d) / (c * c + d * d), (b * c - a * d) / (c * c + d * d)];
  const plus = ([a, b], [c, d], factor = 1) => [a + factor * c, b + factor * d];
  const conjugate = ([a, b]) => [a, -b];

  const density = t => {
    const peak = 0.75 / (1.25 - Math.cos(t - 1));  // its modes fall like 2^-k
    return [Math.cos(t) + peak, Math.sin(2 * t) + peak];
  };
  // A point of the curve whose parameter has the imaginary part -depth, and derivatives.
  const point = (t, depth = 0) => {
    const [p, q] = [(semi[0] + semi[1]) / 2 * Math.exp(depth), (semi[0] - semi[1]) / 2 * Math.exp(-depth)];
    return [(p + q) * Math.cos(t), (p - q) * Math.sin(t)];
  };
  const slope = t => [-semi[0] * Math.sin(t), semi[1] * Math.cos(t)];

  // The preimage of a target: x(t - i depth) = z.
  function preimage(z) {
    const s = (semi[0] ** 2 - semi[1] ** 2), square = plus(times(z, z), [-s, 0]);
    const size = Math.sqrt(Math.hypot(...square)), angle = Math.atan2(square[1], square[0]) / 2;
    const root = [size * Math.cos(angle), size * Math.sin(angle)];
    const w = root[0] * z[0] + root[1] * z[1] < 0 ? plus(z, root, -1) : plus(z, root);
    return {t: Math.atan2(w[1], w[0]), depth: Math.log(Math.hypot(...w) / (semi[0] + semi[1]))};
  }

  function rule(z, nodes) {
    const u = [0, 0];
    for (const {x, dx, eta, h} of nodes) {  // n ds = i x' h on a body
      // As in the library, a distance below half a weight counts as half a weight.
      const r0 = z[0] - x[0], r1 = z[1] - x[1], least2 = (h * h * (dx[0] ** 2 + dx[1] ** 2)) / 4;
      const rho2 = Math.max(r0 * r0 + r1 * r1, least2);
      const k = h / PI * (r1 * dx[0] - r0 * dx[1]) * (r0 * eta[0] + r1 * eta[1]) / (rho2 * rho2);
      u[0] += k * r0;
      u[1] += k * r1;
    }
    return u;
  }

  const sample = (n, densityAt = density) => Array.from({length: n}, (_, j) => {
    const t = 2 * PI * j / n;
    return {t, x: point(t), dx: slope(t), eta: densityAt(t, j), h: 2 * PI / n};
  });

  const kept = new Map();  // what depends on the nodes alone
  function once(name, make) {
    if (!kept.has(name)) kept.set(name, make());
    return kept.get(name);
  }

  const nodesOf = N => once(`nodes${N}`, () => sample(N));

  // The rule with so many nodes that its error is rounding.
  function exact(z) {
    const n = 2 ** Math.ceil(Math.log2(45 / preimage(z).depth));
    return rule(z, once("exact" + n, () => sample(Math.max(64, n))));
  }

  // The trigonometric interpolant of values at the nodes.
  function interpolate(values, t) {
    const n = values.length, result = [0, 0];
    for (let j = 0; j < n; ++j) {
      const lag = t - 2 * PI * j / n, sine = Math.sin(lag / 2);
      const weight = Math.abs(sine) < 1e-15 ? 1 : Math.sin(n * lag / 2) * Math.cos(lag / 2) / (n * sine);
      result[0] += weight * values[j][0];
      result[1] += weight * values[j][1];
    }
    return result;
  }

  // The limit -eta / 2 + D eta from the fluid at each node; on the diagonal half of the curvature stands.
  function limits(N) {
    const nodes = nodesOf(N);
    return nodes.map(p => {
      const speed = Math.hypot(...p.dx), along = (p.eta[0] * p.dx[0] + p.eta[1] * p.dx[1]) / speed ** 4;
      const own = semi[0] * semi[1] * p.h / (2 * PI) * along;
      const u = plus(rule(p.x, nodes.filter(q => q !== p)), p.dx, own);
      return plus(u, p.eta, -0.5);
    });
  }

  // Interpolation along the normal, between the limit and values of a rule with sigma N nodes.
  function interpolation(z, N, sigma, degree) {
    let {t} = preimage(z);
    for (let k = 0; k < 20; ++k) {  // Newton's method for the foot: (z - x) . x' = 0
      const x = point(t), dx = slope(t), [r0, r1] = plus(z, x, -1);
      t += (r0 * dx[0] + r1 * dx[1]) / (dx[0] ** 2 + dx[1] ** 2 + r0 * x[0] + r1 * x[1]);
    }
    const nodes = nodesOf(N), limit = once(`limits${N}`, () => limits(N));
    const fine = once(`fine${N} ${sigma}`, () =>
      sample(sigma * N, at => interpolate(nodes.map(({eta}) => eta), at)));
    const dx = slope(t), speed = Math.hypot(...dx), out = [dx[1] / speed, -dx[0] / speed];
    const first = speed * 2 * PI / N;  // the first point is one spacing away
    const away = plus(z, point(t), -1), distance = (away[0] * out[0] + away[1] * out[1]) / first;
    if (distance >= 1) return rule(z, fine);
    let u = [0, 0];
    for (let j = 0; j <= degree; ++j) {
      let weight = 1;
      for (let k = 0; k <= degree; ++k) if (k !== j) weight *= (distance - k) / (j - k);
      u = plus(u, j === 0 ? interpolate(limit, t) : rule(plus(point(t), out, j * first), fine), weight);
    }
    return u;
  }

  // The derivative in t of the interpolant, at the nodes.
  const differentiate = values => values.map((_, j) => values.reduce((sum, value, k) => {
    const lag = j - k;
    return lag === 0 ? sum : plus(sum, value, (lag % 2 ? -0.5 : 0.5) / Math.tan(PI * lag / values.length));
  }, [0, 0]));

  // U, phi and phi' at the nodes, by (06.10) and (06.11) with s = -1; c = x' s / (i N).
  function cauchyData(N) {
    const nodes = nodesOf(N), c = nodes.map(({dx: [a, b]}) => [-b / N, a / N]);
    const slopes = differentiate(nodes.map(({eta}) => eta));
    const phi = nodes.map((p, j) => nodes.reduce((sum, q, k) => k === j ? sum :
      plus(sum, over(times(c[k], plus(q.eta, p.eta, -1)), plus(q.x, p.x, -1)), -0.5),
      times([0, -0.5 / N], slopes[j])));
    const dphi = differentiate(phi).map((value, j) => over(value, nodes[j].dx));
    const chi = limits(N).map((U, j) => conjugate(plus(phi[j], U, -1)));
    return nodes.map(({x}, j) => ({x, c: c[j], phi: phi[j], dphi: dphi[j], chi: chi[j]}));
  }

  // (06.13) by the quotients (06.14).
  function cauchy(z, N) {
    let delta = [1, 0], first = [0, 0], second = [0, 0];
    for (const {x, c, phi, dphi, chi} of once(`cauchy${N}`, () => cauchyData(N))) {
      const w = over(c, plus(x, z, -1));
      delta = plus(delta, w);
      first = plus(first, times(w, phi));
      second = plus(second, times(w, plus(chi, times(conjugate(plus(z, x, -1)), dphi))));
    }
    return plus(over(first, delta), conjugate(over(second, delta)), -1);
  }

  // The errors of the three ways at a target, and the prediction for the rule.
  function errorsAt(z, {N, sigma, degree}) {
    const u = exact(z), error = v => Math.hypot(...plus(v, u, -1)), nodes = nodesOf(N);
    return {rule: error(rule(z, nodes)), predicted: Math.exp(-N * preimage(z).depth),
            interpolation: error(interpolation(z, N, sigma, degree)), cauchy: error(cauchy(z, N))};
  }

  return {point, preimage, errorsAt, nodesOf};
})();
