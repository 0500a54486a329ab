// Chapter 05: the polynomial of GMRES on eigenvalues that the reader moves.
{
  const pairs = 5, size = 2 * pairs;  // each pair of conjugate eigenvalues is a 2 x 2 block of the matrix
  const plane = new figures.Panel({left: 40, top: 44, width: 456, height: 304}, [-0.9, 2.7], [-1.2, 1.2]);
  const curve = new figures.Panel({left: 68, top: 400, width: 428, height: 160}, [0, 10], [1e-8, 10], {log: true});
  const key = (letter, j) => letter + j;

  const eigenvalues = settings =>
    Array.from({length: pairs}, (_, j) => [settings[key("x", j)], settings[key("y", j)]]);

  const {arnoldi, leastSquares, modulus, dot} = window.krylov;

  // The blocks [x -y; y x], and `coupling` times the next pair's components.
  function multiply(settings, v) {
    return eigenvalues(settings).flatMap(([x, y], j) => {
      const [a, b, c = 0, d = 0] = v.slice(2 * j, 2 * j + 4);
      return [x * a - y * b + settings.coupling * c, y * a + x * b + settings.coupling * d];
    });
  }

  const right = Array.from({length: size}, (_, i) => i % 2 ? 0 : Math.sqrt(1 / pairs));
  const run = settings => arnoldi(v => multiply(settings, v), right, size);

  // The line |p| = level as pieces in the cells of a grid.
  function contour(values, columns, level) {
    const [x0, x1] = plane.x, [y0, y1] = plane.y, rows = values.length / columns;
    const at = (i, j) => values[j * columns + i] - Math.log10(level);
    const pieces = [];
    for (let j = 0; j + 1 < rows; ++j) {
      for (let i = 0; i + 1 < columns; ++i) {
        const below = (at(i, j) < 0) + (at(i + 1, j) < 0) + (at(i + 1, j + 1) < 0) + (at(i, j + 1) < 0);
        if (below % 4 === 0) continue;
        const ends = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].flatMap(([a, b], k, corners) => {
          const [c, d] = corners[(k + 1) % 4], u = at(a, b), v = at(c, d), part = u / (u - v);
          return (u < 0) === (v < 0) ? [] : [[x0 + (x1 - x0) * (a + part * (c - a)) / (columns - 1),
                                              y0 + (y1 - y0) * (b + part * (d - b)) / (rows - 1)]];
        });
        for (let k = 0; k + 1 < ends.length; k += 2) pieces.push(plane.path(ends.slice(k, k + 2)));
      }
    }
    return pieces.join("");
  }

  const start = Object.fromEntries([0, 1, 2, 3, 4].flatMap(j => {
    const angle = Math.PI * (0.1 + 0.2 * j);
    return [[key("x", j), 1 + 0.5 * Math.cos(angle)], [key("y", j), 0.5 * Math.sin(angle)]];
  }));

  figures.add("gmres", {
    settings: {...start, k: 4, coupling: 0},
    sliders: {k: ["iterations <i>k</i>", 0, 10, 1], coupling: ["coupling of the pairs", 0, 1, 0.02]},
    handles: [0, 1, 2, 3, 4].map(j => ({
      panel: plane, label: `eigenvalue ${j + 1}`, step: 0.05, at: s => [s[key("x", j)], s[key("y", j)]],
      to: (_, [x, y]) => ({[key("x", j)]: Math.min(2.6, Math.max(-0.8, x)),
                           [key("y", j)]: Math.min(1.15, Math.max(0, y))})})),
    shown: {residual: "residual ‖<i>r<sub>k</sub></i>‖/‖<i>b</i>‖",
            mean: "root mean square of |<i>p<sub>k</sub></i>| at the eigenvalues",
            largest: "largest |<i>p<sub>k</sub></i>| at an eigenvalue"},

    numbers(settings) {
      const columns = run(settings), {residuals, y} = leastSquares(columns, settings.k);
      const values = eigenvalues(settings).map(z => modulus(columns, y, z));
      return {residual: residuals[settings.k] ?? residuals.at(-1), mean: Math.sqrt(dot(values, values) / pairs),
              largest: Math.max(...values)};
    },

    draw(settings, {residual}) {
      const columns = run(settings), {residuals, y} = leastSquares(columns, settings.k);
      const across = 58, up = 39, values = [];
      for (let j = 0; j < up; ++j) {
        for (let i = 0; i < across; ++i) {
          const z = [-0.9 + 3.6 * i / (across - 1), -1.2 + 2.4 * j / (up - 1)];
          values.push(Math.log10(Math.max(modulus(columns, y, z), 1e-300)));
        }
      }
      const lines = (level, colour, more) => `<g class="${colour}"><path d="${contour(values, across, level)}" ` +
        `fill="none" stroke="currentColor" ${more}/></g>`;
      const floor = value => Math.max(value, 1e-8);
      return [
        plane.axes([0, 1, 2], [-1, 0, 1]),
        lines(10, "", 'stroke-opacity="0.35"'), lines(1, "line-1", 'stroke-width="2.2"'),
        ...[0.1, 0.01, 0.001].map((level, i) => lines(level, "line-0", `stroke-opacity="${1 - 0.3 * i}"`)),
        plane.dots(eigenvalues(settings).map(([x, y]) => [x, -y]), "", 3.5),
        plane.cross([0, 0]), plane.label([0, 0], "0: p = 1", "", {dx: -8, dy: -8, "text-anchor": "end"}),
        plane.label([-0.9, 1.2], "complex plane: eigenvalues, and lines of equal |p|:", "", {dy: -24}),
        plane.label([-0.9, 1.2], "10", "", {dx: 4, dy: -8}),
        plane.label([-0.9, 1.2], "1", "line-1", {dx: 36, dy: -8}),
        plane.label([-0.9, 1.2], "0.1, 0.01, 0.001 (fainter)", "line-0", {dx: 58, dy: -8}),
        curve.axes([0, 2, 4, 6, 8, 10], [1e-8, 1e-6, 1e-4, 0.01, 1], "iterations", "relative residual"),
        curve.line(residuals.map((value, k) => [k, floor(value)]), "line-0"),
        curve.dots(residuals.map((value, k) => [k, floor(value)]), "line-0", 3),
        curve.dots([[settings.k, floor(residual)]], "line-1", 6),
      ];
    },
  });
}
