// Chapter 02: a target near an ellipse, its preimages in the complex parameter t, and the error of the
// double layer at the target, whose density is the constant (1, 0).
{
  const {Panel} = figures, {PI} = Math;
  const fluid = new Panel({left: 60, top: 24, width: 440, height: 242}, [-2, 2], [-1.1, 1.1]);
  const strip = new Panel({left: 60, top: 302, width: 440, height: 118}, [-PI, PI], [-2, 2]);
  const errors = new Panel({left: 60, top: 466, width: 440, height: 118}, [0, 128], [1e-16, 10], {log: true});
  const clamp = (value, bound) => Math.min(bound, Math.max(-bound, value));

  // Returns the preimages [Re t, Im t] of x + iy on the ellipse (cos t, b sin t), the nearest to the real axis
  // first: with zeta = exp(it) they solve (1 + b)/2 zeta + (1 - b)/2 / zeta = x + iy.
  function preimages(x, y, b) {
    const [re, im] = [x * x - y * y - (1 - b * b), 2 * x * y], size = Math.hypot(re, im);
    const [u, v] = [Math.sqrt((size + re) / 2), Math.sign(im || 1) * Math.sqrt((size - re) / 2)];
    return [1, -1].map(sign => [x + sign * u, y + sign * v])
      .filter(zeta => Math.hypot(...zeta) > 1e-12)  // a circle has one preimage only
      .map(zeta => [Math.atan2(zeta[1], zeta[0]), -Math.log(Math.hypot(...zeta) / (1 + b))])
      .sort((s, t) => Math.abs(s[1]) - Math.abs(t[1]));
  }

  function error({x, y, b}, n) {
    const nodes = plane.ellipse(1, b, n), inside = x * x + y * y / (b * b) < 1;
    const velocity = plane.layer(nodes, nodes.map(() => [1, 0]), [x, y]);
    return Math.hypot(velocity[0] - (inside ? 1 : 0), velocity[1]);
  }

  // Returns the points x(t + ih), which lie on an ellipse with the same foci.
  function shifted(b, h) {
    const axes = [Math.cosh(h) + b * Math.sinh(h), Math.sinh(h) + b * Math.cosh(h)];
    return Array.from({length: 97}, (_, k) => k * PI / 48).map(t => [axes[0] * Math.cos(t), axes[1] * Math.sin(t)]);
  }

  figures.add("preimage", {
    settings: {x: 1.1, y: 0.5, b: 0.5, N: 64},
    sliders: {N: ["number <i>N</i> of nodes", 8, 128, 4], b: ["minor half axis <i>b</i>", 0.2, 1, 0.05]},
    handles: [{panel: fluid, label: "target z", step: 0.05, anywhere: true, at: ({x, y}) => [x, y],
               to: (_, [x, y]) => ({x: clamp(x, 2), y: clamp(y, 1.1)})}],
    shown: {d: "<i>d</i> = |Im <i>t</i>| =", spacings: "node spacings <i>dN</i>/2π =",
            predicted: "<i>N</i> e<sup>−<i>dN</i></sup> =", error: "error"},

    numbers(settings) {
      const {x, y, b, N} = settings, d = Math.abs(preimages(x, y, b)[0][1]);
      return {d, spacings: d * N / (2 * PI), predicted: N * Math.exp(-d * N), error: error(settings, N)};
    },

    draw(settings, numbers) {
      const {x, y, b, N} = settings, five = 10 * PI / N;
      const deepest = Math.atanh(Math.min(b, 0.999999));  // there the points x(t - ih) reach the foci
      const [near, far] = preimages(x, y, b).map(t => Math.abs(t[1]) < 2 ? t : null);  // null: not on the picture
      const outer = fluid.path(shifted(b, five), true);
      const inner = five < deepest ? fluid.path(shifted(b, -five).reverse(), true) : "";
      const counts = Array.from({length: 31}, (_, k) => 8 + 4 * k), least = value => Math.max(value, 1e-16);
      return [
        '<clipPath id="preimage-clip"><rect x="60" y="24" width="440" height="242"/></clipPath>',
        `<g class="line-1" clip-path="url(#preimage-clip)"><path d="${outer}${inner}" fill="currentColor" ` +
          'fill-opacity="0.15" fill-rule="evenodd"/></g>',
        fluid.line(shifted(b, 0)), fluid.dots(plane.ellipse(1, b, N).map(node => node.x), "line-0", 2.5),
        fluid.dots([[x, y]], "line-1", 5), fluid.label([x, y], "z", "", {dx: 12, dy: -8}),
        fluid.label([-2, -1.1], "shaded: within five spacings", "line-1", {dx: 8, dy: -8}),
        fluid.axes([-2, -1, 0, 1, 2], [-1, 0, 1], "", "target z and the nodes"),
        strip.area([[-PI, -five], [PI, -five], [PI, five], [-PI, five]].map(([u, v]) => [u, clamp(v, 2)]), "line-1"),
        strip.line([[-PI, 0], [PI, 0]]),
        strip.dots(plane.ellipse(1, b, N).map((_, j) => [-PI + 2 * PI * j / N, 0]), "line-0", 2.5),
        near ? strip.cross(near, "line-1", 6) : "", far ? strip.cross(far, "", 4) : "",
        strip.axes([-3, -2, -1, 0, 1, 2, 3], [-2, -1, 0, 1, 2], "", "its preimages: Im t against Re t"),
        errors.line(counts.map(n => [n, least(n * Math.exp(-numbers.d * n))]).filter(point => point[1] < 10), "line-1"),
        errors.dots(counts.map(n => [n, Math.min(least(error(settings, n)), 10)]), "line-0", 2.5),
        errors.dots([[N, Math.min(least(numbers.error), 10)]], "line-0", 6),
        errors.axes([0, 32, 64, 96, 128], [1e-16, 1e-12, 1e-8, 1e-4, 1], "N", "error at z, and N exp(−dN)"),
      ];
    },
  });
}
