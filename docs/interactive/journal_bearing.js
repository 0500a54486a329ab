// The load of a shaft of radius 1 that turns in an eccentric bushing: by the closed form of chapter 04, and by the
// trapezoid rule. Called by bearing.js.
window.journalBearing ??= (() => {
  const {PI} = Math;
  const radius = 1.5;  // of the bushing

  // The closed form (04.10) for the angular velocity 1, and the nodes that take its error to rounding.
  function closedForm(e) {
    const sum = 1 + radius ** 2;
    const tau = Math.acosh((sum - e * e) / (2 * radius)), s = radius * Math.sinh(tau) / e;
    const f = -e / (2 * tau * sum - 4 * s * e), d = Math.log(radius / (1 + e));
    return {force: Math.abs(8 * PI * f), nodes: 2 * Math.ceil(24 / Math.min(tau, 2 * d))};
  }

  // Solves a x = b by elimination with row exchanges, in place.
  function eliminate(a, b) {
    const n = b.length;
    for (let k = 0; k < n; ++k) {
      let best = k;
      for (let i = k + 1; i < n; ++i) if (Math.abs(a[i][k]) > Math.abs(a[best][k])) best = i;
      [a[k], a[best], b[k], b[best]] = [a[best], a[k], b[best], b[k]];
      const pivot = a[k];
      for (let i = k + 1; i < n; ++i) {
        const row = a[i], factor = row[k] / pivot[k];
        for (let j = k + 1; j < n; ++j) row[j] -= factor * pivot[j];
        b[i] -= factor * b[k];
      }
    }
    for (let k = n - 1; k >= 0; --k) {
      for (let j = k + 1; j < n; ++j) b[k] -= a[k][j] * b[j];
      b[k] /= a[k][k];
    }
    return b;
  }

  // The nodes of the shaft and then of the bushing, with normals out of the fluid and the given velocities.
  function nodesOf({x, y, N, leak}) {
    return Array.from({length: 2 * N}, (_, j) => {
      const wall = j >= N, r = wall ? radius : 1, sign = wall ? 1 : -1;
      const c = Math.cos(2 * PI * j / N), s = Math.sin(2 * PI * j / N), out = leak * (1 + c);
      return wall ? {sign, x: r * c, y: r * s, nx: c, ny: s, w: 2 * PI * r / N, g: [out * c, out * s]}
                  : {sign, x: x + c, y: y + s, nx: -c, ny: -s, w: 2 * PI / N, g: [-s, c]};
    });
  }

  // The force of the shaft on the fluid, from the equations (04.9) at the nodes.
  function solve(settings, withN0) {
    const nodes = nodesOf(settings), matrix = [];
    for (const p of nodes) {
      const rows = [new Float64Array(2 * nodes.length), new Float64Array(2 * nodes.length)];
      const layer = [[0, 0, 0], [0, 0, 0]];  // the layer's flow if the shaft's density is a rigid motion
      nodes.forEach((q, j) => {
        const same = p === q, rx = same ? -q.ny : p.x - q.x, ry = same ? q.nx : p.y - q.y, rho2 = rx * rx + ry * ry;
        const k = same ? -q.sign / settings.N : q.w / PI * (rx * q.nx + ry * q.ny) / (rho2 * rho2);
        const xx = k * rx * rx - (same ? 0.5 : 0), xy = k * rx * ry, yy = k * ry * ry - (same ? 0.5 : 0);
        const flux = withN0 && p.sign > 0 && q.sign > 0 ? q.w / (2 * PI * radius) : 0;
        rows[0].set([xx - flux * p.nx * q.nx, xy - flux * p.nx * q.ny], 2 * j);
        rows[1].set([xy - flux * p.ny * q.nx, yy - flux * p.ny * q.ny], 2 * j);
        if (q.sign > 0) return;
        [[xx, xy], [xy, yy]].forEach(([a, b], i) =>
          [a, b, a * q.ny - b * q.nx].forEach((value, mode) => layer[i][mode] += value));
      });
      // The reduced form: Stokeslet and rotlet take the place of this flow.
      const rx = p.x - settings.x, ry = p.y - settings.y, rho2 = rx * rx + ry * ry;
      const log = 0.5 - 0.5 * Math.log(rho2);
      const loads = [[-log - rx * rx / rho2, -rx * ry / rho2, ry / rho2],
                     [-rx * ry / rho2, -log - ry * ry / rho2, -rx / rho2]];
      rows.forEach((row, i) => {
        const [u, v, turn] = loads[i].map((value, mode) => (value - layer[i][mode]) / settings.N);
        for (let j = 0; j < settings.N; ++j) {
          row[2 * j] += u + turn * nodes[j].ny;
          row[2 * j + 1] += v - turn * nodes[j].nx;
        }
      });
      matrix.push(...rows);
    }
    const density = eliminate(matrix, nodes.flatMap(({g}) => g)), force = [0, 0];
    for (let j = 0; j < 2 * settings.N; ++j) force[j % 2] -= 4 * PI * density[j] / settings.N;
    return force;
  }

  return {radius, closedForm, nodesOf, solve};
})();
