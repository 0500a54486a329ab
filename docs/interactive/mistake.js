// Chapter 02: four identities of the double layer on an ellipse 2:1, and mistakes that break them.
{
  const {Panel} = figures, {dot, plus, times} = plane, {PI} = Math;
  const picture = new Panel({left: 24, top: 24, width: 472, height: 272}, [-2.95, 2.95], [-1.7, 1.7]);
  const [NORMAL, FACTOR, DIAGONAL, CURVATURE, JUMP] = [1, 2, 3, 4, 5];
  const INSIDE = [0.3, 0.2], FLUID = [1.2, 1.5], HOLDS = 1e-6;

  // Returns the double layer at a target, with the given mistake; node is the target's node, or -1.
  function layer(nodes, density, target, node, mistake) {
    let u = plane.layer(nodes, density, target);
    if (node >= 0 && mistake !== DIAGONAL) {  // the limit (02.9) of the kernel times the weight
      const {tangent, curvature, weight} = nodes[node];
      const limit = times(curvature * weight / (2 * PI) * dot(tangent, density[node]), tangent);
      u = plus(u, limit, mistake === CURVATURE ? -1 : 1);
    }
    return times(mistake === NORMAL ? -1 : mistake === FACTOR ? 0.5 : 1, u);
  }

  // Returns the error of the flux identity (02.11) for the density (x_1, 0).
  function fluxError(nodes, mistake) {
    const density = nodes.map(({x}) => [x[0], 0]), jump = mistake === JUMP ? 0.5 : -0.5;
    const sum = nodes.reduce((total, {x, normal, weight}, j) => {
      const limit = plus(layer(nodes, density, x, j, mistake), density[j], jump);
      return total + weight * dot(normal, plus(limit, density[j]));
    }, 0);
    return Math.abs(sum) / nodes.reduce((total, {weight}) => total + weight, 0);
  }

  figures.add("mistake", {
    settings: {mistake: 0, N: 64},
    choices: {mistake: ["mistake", ["none", "other normal", "1/2π for 1/π", "zero diagonal", "other sign of κ",
                                    "jump of the other side"]]},
    sliders: {N: ["number <i>N</i> of nodes", 32, 128, 16]},
    shown: {inside: "errors: inside", fluid: "in the fluid", on: "on the curve", flux: "of the flux"},

    numbers({mistake, N}) {
      const nodes = plane.ellipse(2, 1, N), one = nodes.map(() => [1, 0]);
      const errorAt = (target, node, share) =>
        Math.hypot(...plus(layer(nodes, one, target, node, mistake), [share, 0], -1));
      const seen = error => error < 1e-12 ? 0 : error;  // rounding errors count as 0
      return {inside: seen(errorAt(INSIDE, -1, 1)), fluid: seen(errorAt(FLUID, -1, 0)),
              on: seen(Math.max(...nodes.map(({x}, j) => errorAt(x, j, 0.5)))),
              flux: seen(fluxError(nodes, mistake))};
    },

    draw({mistake, N}, numbers) {
      const nodes = plane.ellipse(2, 1, N), one = nodes.map(() => [1, 0]), ring = plane.ellipse(2, 1, 96);
      const arrow = (x, node) => {
        const u = layer(nodes, one, x, node, mistake);
        return picture.dots([x], "line-0", 2) + picture.arrow(x, plus(x, u, 0.4), "line-0", 2);
      };
      const lights = [["inside: D[U] = U", numbers.inside], ["in the fluid: D[U] = 0", numbers.fluid],
                      ["on the curve: DU = U/2", numbers.on], ["flux of −η/2 + Dη is −∫ n·η ds", numbers.flux]];
      const rows = new Panel({left: 24, top: 312, width: 472, height: 96}, [0, 1], [4, 0]);
      const sense = mistake === NORMAL ? -0.25 : 0.25;
      return [
        picture.area(ring.map(({x}) => x), "", {"fill-opacity": 0.08}),
        picture.line([...ring, ring[0]].map(({x}) => x)),
        ...[-1.2, -0.6, 0, 0.6, 1.2].map(x => arrow([x, 0.2], -1)),
        ...[-2.4, -1.2, 0, 1.2, 2.4].flatMap(x => [arrow([x, 1.5], -1), arrow([x, -1.5], -1)]),
        ...[1, 3, 5, 7, 9, 11, 13, 15].map(k => arrow(nodes[k * N / 16].x, k * N / 16)),
        picture.arrow(nodes[N * 3 / 4].x, plus(nodes[N * 3 / 4].x, nodes[N * 3 / 4].normal, sense), "line-2", 2),
        picture.label(plus(nodes[N * 3 / 4].x, nodes[N * 3 / 4].normal, sense), "n", "line-2", {dx: 8, dy: 4}),
        picture.label([-2.95, 1.7], "arrows: the double layer of the density U = (1, 0)", "line-0", {dy: -8}),
        ...lights.map(([words, error], k) => {
          const holds = error < HOLDS, colour = holds ? "line-2" : "line-1";
          return (holds ? rows.dots([[0.02, k + 0.5]], colour, 7) : rows.cross([0.02, k + 0.5], colour, 6)) +
            rows.label([0.06, k + 0.5], words, "", {dy: 4}) +
            rows.label([1, k + 0.5], holds ? "holds" : "fails", colour, {dy: 4, "text-anchor": "end"});
        }),
      ];
    },
  });
}
