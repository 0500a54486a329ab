// Chapter 06: errors of three ways to evaluate the double layer of an ellipse close to it.
{
  const {PI} = Math;
  const least = 0.003;  // the smallest depth of a target
  const plane = new figures.Panel({left: 10, top: 24, width: 500, height: 300}, [-2, 2], [-1.2, 1.2]);
  const errors = new figures.Panel({left: 78, top: 376, width: 426, height: 190}, [-2, 1], [1e-13, 10],
                                   {log: true});

  const {point, preimage, errorsAt, nodesOf} = window.closeEvaluation;

  figures.add("close", {
    settings: {x: 0.35, y: 0.55, N: 48, sigma: 3, degree: 6},
    sliders: {N: ["nodes <i>N</i>", 16, 128, 8], sigma: ["fine nodes for each node, <i>σ</i>", 1, 8, 1],
              degree: ["degree <i>m</i> of the polynomial", 1, 12, 1]},
    handles: [{panel: plane, label: "target", step: 0.02, anywhere: true, at: ({x, y}) => [x, y],
               to: (_, target) => {
                 const {t, depth} = preimage(target), [x, y] = point(t, Math.min(0.9, Math.max(least, depth)));
                 return {x, y};
               }}],
    shown: {predicted: "e<sup>−<i>N</i> |Im <i>τ</i>|</sup> =", rule: "error of the rule",
            interpolation: "of interpolation", cauchy: "of the Cauchy scheme"},

    numbers: ({x, y, ...settings}) => errorsAt([x, y], settings),

    draw({x, y, ...settings}, now) {
      const {N} = settings, {t} = preimage([x, y]), turn = Array.from({length: 121}, (_, k) => PI * k / 60);
      const level = error => Math.log(1 / error) / N;
      const depths = Array.from({length: 37}, (_, k) => Math.max(least, 0.06 * PI * 10 ** (k / 12) / N));
      const xs = depths.map(depth => Math.log10(N * depth / (2 * PI)));
      const line = (key, colour, width) => errors.line(depths.flatMap((depth, k) => {
        const value = errorsAt(point(t, depth), settings)[key];
        return xs[k] < -2 || xs[k] > 1 ? [] : [[xs[k], Math.min(10, Math.max(1e-13, value))]];
      }), colour, {"stroke-width": width});
      const here = Math.log10(N * preimage([x, y]).depth / (2 * PI));
      const mark = (key, colour) => errors.dots([[here, Math.min(10, Math.max(1e-13, now[key]))]], colour, 5);
      return [
        plane.area(turn.map(at => point(at)), ""), plane.line(turn.map(at => point(at))),
        ...[1e-2, 1e-4, 1e-6, 1e-8].map(level).filter(depth => depth < 0.6).map(depth =>
          plane.line(turn.map(at => point(at, depth)), "line-1", {"stroke-width": 1, "stroke-dasharray": "4 4"})),
        plane.dots(nodesOf(N).map(({x}) => x), "line-0", 2.5),
        errors.axes([-2, -1, 0, 1], [1e-12, 1e-8, 1e-4, 1],
                    "log₁₀ of the distance in spacings, along this normal", "error"),
        line("rule", "line-1", 1.8), line("interpolation", "line-0", 1.8), line("cauchy", "line-2", 1.8),
        ...here < -2 || here > 1 ? [] :
          [mark("rule", "line-1"), mark("interpolation", "line-0"), mark("cauchy", "line-2")],
        errors.label([-2, 10], "rule", "line-1", {dx: 160, dy: -6}),
        errors.label([-2, 10], "interpolation", "line-0", {dx: 200, dy: -6}),
        errors.label([-2, 10], "Cauchy scheme", "line-2", {dx: 290, dy: -6}),
      ];
    },
  });
}
