// Chapter 01: a pole of f(t) = 1/(cosh d - cos t), and the error of the trapezoid rule.
{
  const PI = Math.PI;
  const strip = new figures.Panel({left: 68, top: 24, width: 420, height: 170}, [-PI, PI], [-2.2, 2.2]);
  const errors = new figures.Panel({left: 68, top: 232, width: 420, height: 150}, [0, 64], [1e-16, 10], {log: true});

  const exact = d => 2 * PI / Math.sinh(d);
  const predicted = (d, n) => 2 / Math.expm1(d * n);

  function rule(d, n) {
    let sum = 0;
    for (let j = 0; j < n; ++j) sum += 1 / (Math.cosh(d) - Math.cos(2 * PI * j / n));
    return 2 * PI / n * sum;
  }

  const measured = (d, n) => Math.abs(rule(d, n) / exact(d) - 1);
  const even = Array.from({length: 31}, (_, k) => 4 + 2 * k);

  figures.add("pole", {
    settings: {d: 0.5, N: 16},
    sliders: {d: ["distance <i>d</i> of the pole", 0.1, 2, 0.01], N: ["number <i>N</i> of nodes", 4, 64, 2]},
    handles: [{panel: strip, label: "pole at i d", step: 0.05, at: ({d}) => [0, d], to: (_, [, y]) => ({d: y})}],
    shown: {rule: "rule", integral: "integral", error: "relative error",
            predicted: "2/(e<sup><i>dN</i></sup> − 1) =", factor: "factor a node, e<sup>−<i>d</i></sup> ="},

    numbers({d, N}) {
      return {rule: rule(d, N), integral: exact(d), error: measured(d, N), predicted: predicted(d, N),
              factor: Math.exp(-d)};
    },

    draw({d, N}, {error}) {
      const nodes = Array.from({length: N}, (_, j) => [-PI + 2 * PI * j / N, 0]);
      return [
        strip.area([[-PI, -d], [PI, -d], [PI, d], [-PI, d]], "line-0"),
        strip.line([[-PI, 0], [PI, 0]]),
        strip.dots(nodes, "line-0"),
        strip.cross([0, d], "line-1", 12), strip.cross([0, -d], "line-1"),
        strip.label([0, d], "pole at i d", "line-1", {dx: 16, dy: -8}),
        strip.label([-PI, -d], "f is analytic in the strip", "line-0", {dx: 6, dy: -6}),
        strip.axes([-3, -2, -1, 0, 1, 2, 3], [-2, -1, 0, 1, 2], "", "complex t: Im t against Re t"),
        errors.axes([0, 16, 32, 48, 64], [1e-16, 1e-12, 1e-8, 1e-4, 1], "N", "relative error of the rule"),
        errors.line(even.map(n => [n, Math.max(predicted(d, n), 1e-16)]), "line-1"),
        errors.dots(even.map(n => [n, Math.max(measured(d, n), 1e-16)]), "line-0", 2.5),
        errors.dots([[N, Math.max(error, 1e-16)]], "line-0", 6),
      ];
    },
  });
}
