// Chapter 02: the flows of a force, a torque and a stresslet at the origin. The viscosity is 1.
{
  const {Panel} = figures, {dot, plus, times} = plane, {PI} = Math;
  const fluid = new Panel({left: 60, top: 24, width: 440, height: 308}, [-2, 2], [-1.4, 1.4]);
  const decay = new Panel({left: 60, top: 380, width: 440, height: 118}, [-1, 1], [1e-3, 10], {log: true});
  const clamp = (value, bound) => Math.min(bound, Math.max(-bound, value));
  const [STOKESLET, ROTLET, STRESSLET] = [0, 1, 2];

  const stokeslet = (r, force, gauge) => {
    const square = dot(r, r);
    return times(1 / (4 * PI), plus(times(dot(r, force) / square, r), force, -0.5 * Math.log(square / gauge ** 2)));
  };
  const rotlet = (r, torque) => times(torque / (4 * PI * dot(r, r)), [-r[1], r[0]]);

  // Returns the velocity at a point r; the torque of the rotlet is the height of the drawn vector.
  function velocity({kind, f, g, angle, gauge}, r) {
    if (kind === STOKESLET) return stokeslet(r, [f, g], gauge);
    if (kind === ROTLET) return rotlet(r, g);
    return plane.stresslet(r, [Math.cos(PI * angle / 180), Math.sin(PI * angle / 180)], [f, g]);
  }

  const tip = ({kind, f, g}) => kind === ROTLET ? [0, g] : [f, g];
  const speed = (settings, r) => Math.hypot(...velocity(settings, r));

  // Returns the outflow through the circle of radius 1, by the trapezoid rule.
  function flux(settings) {
    const circle = Array.from({length: 32}, (_, j) => [Math.cos(PI * j / 16), Math.sin(PI * j / 16)]);
    const sum = circle.reduce((total, x) => total + PI / 16 * dot(velocity(settings, x), x), 0);
    return Math.abs(sum) < 1e-14 ? 0 : sum;
  }

  // Arrows on a grid; their lengths grow like the cube root of the speed, so that weak flows are seen.
  function arrows(settings) {
    const found = [];
    for (let x = -1.8; x < 1.9; x += 0.3) {
      for (let y = -1.2; y < 1.3; y += 0.3) {
        const r = [x, y], u = velocity(settings, r), size = Math.hypot(...u);
        if (Math.hypot(x, y) < 0.2 || size < 1e-9) continue;
        const half = times(0.2 * Math.min(1, Math.cbrt(size)) / size, u);
        found.push(fluid.arrow(plus(r, half, -1), plus(r, half), "line-0", 1.2));
      }
    }
    return found.join("");
  }

  figures.add("push", {
    settings: {kind: 0, f: 1, g: 0.4, angle: 0, gauge: 10, x: -1.05, y: 0.75},
    choices: {kind: ["flow of a", ["force", "torque", "stresslet"]]},
    sliders: {angle: ["angle of the normal <i>n</i>", -180, 180, 5], gauge: ["gauge length ℓ", 1, 20, 0.5]},
    when: {angle: ({kind}) => kind === STRESSLET, gauge: ({kind}) => kind === STOKESLET},
    handles: [
      {panel: fluid, label: "tip of the vector", step: 0.05, at: tip,
       to: ({kind}, [x, y]) => kind === ROTLET ? {g: clamp(y, 1.4)} : {f: clamp(x, 2), g: clamp(y, 1.4)}},
      {panel: fluid, label: "point of measurement", step: 0.05, at: ({x, y}) => [x, y],
       to: (_, [x, y]) => ({x: clamp(x, 2), y: clamp(y, 1.4)})}],
    shown: {u: "velocity at <i>x</i>: <i>u</i><sub>1</sub> =", v: "<i>u</i><sub>2</sub> =",
            ratio: "at twice the distance, speed times", flux: "outflow of the circle"},

    numbers(settings) {
      const r = [settings.x, settings.y], [u, v] = velocity(settings, r);
      return {u, v, ratio: speed(settings, times(2, r)) / speed(settings, r), flux: flux(settings)};
    },

    draw(settings) {
      const {kind, angle, x, y} = settings, rho = Math.hypot(x, y);
      const circle = Array.from({length: 97}, (_, j) => [Math.cos(PI * j / 48), Math.sin(PI * j / 48)]);
      const normal = [Math.cos(PI * angle / 180), Math.sin(PI * angle / 180)];
      const along = Array.from({length: 81}, (_, k) => k / 40 - 1);
      const curve = along.map(power => [power, speed(settings, times(10 ** power / rho, [x, y]))]);
      return [
        arrows(settings),
        fluid.line(circle, "", {"stroke-dasharray": "4 4", "stroke-opacity": 0.6}),
        fluid.arrow([0, 0], tip(settings), "line-1", 3),
        fluid.label(tip(settings), ["F", "L", "η"][kind], "line-1", {dx: 12, dy: -8}),
        kind === STRESSLET ? fluid.arrow([0, 0], times(0.5, normal), "line-2", 3) +
                        fluid.label(times(0.6, normal), "n", "line-2", {dx: -4, dy: 4}) : "",
        fluid.dots([[x, y]], "line-1", 5), fluid.label([x, y], "x", "", {dx: 12, dy: -8}),
        fluid.axes([-2, -1, 0, 1, 2], [-1, 0, 1], "", "the flow, and a circle of radius 1"),
        decay.line(curve.filter(point => point[1] > 1e-3 && point[1] < 10), "line-0"),
        decay.dots([[clamp(Math.log10(rho), 1), Math.min(10, Math.max(1e-3, speed(settings, [x, y])))]], "line-0", 6),
        decay.axes([-1, 0, 1], [1e-3, 1e-2, 1e-1, 1, 10], "log₁₀ of the distance", "speed in the direction of x"),
      ];
    },
  });
}
