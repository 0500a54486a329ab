// Chapter 04: a shaft that turns in an eccentric bushing, and what a leak in the data does to its load.
{
  const {PI} = Math;
  const least = 0.05, most = 0.46;  // displacements of the shaft
  const plane = new figures.Panel({left: 12, top: 44, width: 290, height: 290}, [-1.75, 1.75], [-1.75, 1.75]);
  const counts = new figures.Panel({left: 372, top: 44, width: 130, height: 256}, [0, 0.5], [10, 2000],
                                   {log: true});

  const {radius, closedForm, nodesOf, solve} = window.journalBearing;

  const displacement = ({x, y}) => Math.hypot(x, y);
  const across = ({x, y}) => [-y / Math.hypot(x, y), x / Math.hypot(x, y)];  // turned by a right angle
  // Forces of the fluid on the shaft, the reversed ones, with and without N_0. The last ones are kept.
  let last = {};
  function forces(settings) {
    const key = JSON.stringify(settings);
    if (last.key !== key) last = {key, value: [true, false].map(withN0 => solve(settings, withN0).map(f => -f))};
    return last.value;
  }

  figures.add("bearing", {
    settings: {x: 0.2, y: -0.15, N: 48, leak: 0.002},
    sliders: {N: ["nodes <i>N</i> of each circle", 16, 64, 4], leak: ["speed of the leak", 0, 0.01, 0.0005]},
    handles: [{panel: plane, label: "centre of the shaft", step: 0.02, at: ({x, y}) => [x, y],
               to: (_, [x, y]) => {
                 const e = Math.hypot(x, y) || 1e-9, kept = Math.min(most, Math.max(least, e));
                 return {x: (x || 1e-9) * kept / e, y: y * kept / e};
               }}],
    shown: {exact: "force across, without a leak", across: "by <i>N</i> nodes",
            along: "force along, with <i>N</i><sub>0</sub>", alongWithout: "without <i>N</i><sub>0</sub>",
            nodes: "nodes needed for all digits"},

    numbers(settings) {
      const {force, nodes} = closedForm(displacement(settings)), [a, b] = across(settings);
      const [[x, y], [u, v]] = forces(settings);
      return {exact: force, across: a * x + b * y, along: b * x - a * y, alongWithout: b * u - a * v, nodes};
    },

    draw(settings, {exact}) {
      const {x, y, N} = settings, e = displacement(settings), [a, b] = across(settings);
      const arrow = ([u, v], colour, width) => {  // not longer than the drawing is wide
        const scale = 1 / Math.max(60, Math.hypot(u, v) / 1.6);
        return plane.arrow([x, y], [x + u * scale, y + v * scale], colour, width);
      };
      const [withN0, without] = forces(settings);
      const circle = (x, y, r) => Array.from({length: 121}, (_, k) =>
        [x + r * Math.cos(PI * k / 60), y + r * Math.sin(PI * k / 60)]);
      const needed = Array.from({length: 46}, (_, k) => [least + (most - least) * k / 45]);
      return [
        plane.line(circle(0, 0, radius)), plane.area(circle(x, y, 1)), plane.line(circle(x, y, 1)),
        plane.dots(nodesOf(settings).map(({x, y}) => [x, y]), "line-0", 2),
        plane.line([[0, 0], [x, y]], "", {"stroke-dasharray": "3 3"}), plane.cross([0, 0]),
        arrow([a * exact, b * exact], "", 6), arrow(withN0, "line-2", 3), arrow(without, "line-1", 1.6),
        plane.label([-1.75, 1.75], "force on the shaft:", "", {dy: -24}),
        plane.label([-1.75, 1.75], "closed form", "", {dx: 0, dy: -8}),
        plane.label([-1.75, 1.75], "with N₀", "line-2", {dx: 84, dy: -8}),
        plane.label([-1.75, 1.75], "without N₀", "line-1", {dx: 146, dy: -8}),
        counts.axes([0, 0.2, 0.4], [10, 100, 1000], "displacement of the shaft", "nodes needed"),
        counts.line(needed.map(([at]) => [at, closedForm(at).nodes])),
        counts.line([[0, N], [0.5, N]], "line-0", {"stroke-dasharray": "5 4"}),
        counts.label([0, N], "N", "line-0", {dx: 5, dy: 14}),
        counts.dots([[e, closedForm(e).nodes]], "", 5),
      ];
    },
  });
}
