// Chapter 03: an ellipse under a weight, its velocity by (03.13), and the gauge length. The viscosity is 1 and
// the half axes have the sum 2.
{
  const {Panel} = figures, {plus, times} = plane, {PI} = Math;
  const fluid = new Panel({left: 60, top: 24, width: 440, height: 308}, [-2.5, 2.5], [-1.75, 1.75]);
  const gauges = new Panel({left: 60, top: 380, width: 440, height: 118}, [-1, 1.5], [-3, 5]);

  const axes = ratio => [2 / (1 + ratio), 2 * ratio / (1 + ratio)];

  // Returns 4 pi times the velocities by unit forces along the two axes; logGauge is log10 of the gauge length.
  const mobilities = (ratio, logGauge) => axes(ratio).map(axis => axis / 2 + Math.LN10 * logGauge);

  // Returns the vector with the given components along the axes of the ellipse, or the components of a vector.
  const turned = ([u, v], degrees) => {
    const [c, s] = [Math.cos(PI * degrees / 180), Math.sin(PI * degrees / 180)];
    return [c * u - s * v, s * u + c * v];
  };

  // The weight is 4 pi, so that velocities have the size 1.
  function velocity({ratio, angle, logGauge}) {
    const weight = turned([0, -1], -angle);
    return turned(mobilities(ratio, logGauge).map((mobility, k) => mobility * weight[k]), angle);
  }

  const ring = (ratio, n) => Array.from({length: n}, (_, j) => 2 * PI * (j + 0.5) / n)
    .map(t => [axes(ratio)[0] * Math.cos(t), axes(ratio)[1] * Math.sin(t)]);

  // Returns the velocity of the fluid: Stokeslets in equal parts of the parameter of the ellipse.
  function flow({ratio, angle, logGauge}, x, sources) {
    return sources.reduce((sum, source) => {
      const r = plus(x, source, -1), rho = Math.hypot(...r);
      const stokeslet = plus(times(-r[1] / rho ** 2, r), [0, Math.log(rho) - Math.LN10 * logGauge]);
      return plus(sum, stokeslet, 1 / sources.length);
    }, [0, 0]);
  }

  function arrows(settings) {
    const {ratio, angle} = settings, [a, b] = axes(ratio), found = [];
    const sources = ring(ratio, 48).map(point => turned(point, angle));
    for (let x = -2.3; x < 2.4; x += 0.4) {
      for (let y = -1.6; y < 1.7; y += 0.4) {
        const own = turned([x, y], -angle);
        if ((own[0] / (a + 0.12)) ** 2 + (own[1] / (b + 0.12)) ** 2 < 1) continue;
        const u = flow(settings, [x, y], sources), size = Math.hypot(...u);
        const length = 0.3 * Math.min(1, size / 2);
        if (size > 1e-9) found.push(fluid.arrow([x, y], plus([x, y], u, length / size), "line-0", 1.2));
      }
    }
    return found.join("");
  }

  figures.add("mobility", {
    settings: {angle: 30, ratio: 0.3, logGauge: 0.5},
    sliders: {angle: ["angle of the major axis", -180, 180, 1], ratio: ["ratio <i>b</i>/<i>a</i>", 0.1, 1, 0.05],
              logGauge: ["log₁₀ of the gauge length ℓ", -1, 1.5, 0.02]},
    handles: [{panel: fluid, label: "tip of the major axis", step: 0.05,
               at: ({ratio, angle}) => turned([axes(ratio)[0], 0], angle),
               to: (_, [x, y]) => ({angle: Math.atan2(y, x) * 180 / PI})}],
    shown: {sideways: "velocity: sideways", up: "upwards", drift: "drift angle, degrees",
            along: "4πμ<i>U</i>/<i>F</i> along the major axis", across: "across it"},

    numbers({angle, ratio, logGauge}) {
      const [sideways, up] = velocity({angle, ratio, logGauge}), [along, across] = mobilities(ratio, logGauge);
      return {sideways, up, drift: Math.atan2(sideways, -up) * 180 / PI, along, across};
    },

    draw(settings, {sideways, up, along, across}) {
      const {ratio, angle, logGauge} = settings, outline = ring(ratio, 96).map(point => turned(point, angle));
      const [first, last] = gauges.x, lines = [first, last].map(x => mobilities(ratio, x));
      return [
        arrows(settings),
        fluid.area(outline, "", {"fill-opacity": 0.12}), fluid.line([...outline, outline[0]]),
        fluid.arrow([0, 0], [0, -1], "line-1", 3), fluid.label([0, -1], "weight", "line-1", {dx: 6, dy: 14}),
        fluid.arrow([0, 0], [0.6 * sideways, 0.6 * up], "line-2", 3),
        fluid.label([0.6 * sideways, 0.6 * up], "U", "line-2", {dx: 8, dy: -4}),
        fluid.axes([-2, -1, 0, 1, 2], [-1, 0, 1], "", "the ellipse, its velocity U, and the flow"),
        gauges.line([[first, 0], [last, 0]], "", {"stroke-opacity": 0.5, "stroke-width": 1}),
        gauges.line([[first, lines[0][0]], [last, lines[1][0]]], "line-0"),
        gauges.line([[first, lines[0][1]], [last, lines[1][1]]], "line-1"),
        gauges.dots([[logGauge, along]], "line-0", 6), gauges.dots([[logGauge, across]], "line-1", 6),
        gauges.axes([-1, -0.5, 0, 0.5, 1, 1.5], [-2, 0, 2, 4], "log₁₀ of the gauge length ℓ",
                    "4πμU/F along the major axis (blue) and across it"),
      ];
    },
  });
}
