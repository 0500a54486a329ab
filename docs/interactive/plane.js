// Vectors [x, y] of the plane, the nodes of an ellipse, and the kernel of the double layer. Figures that need
// them load this script first.
window.plane ??= (() => {
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1];
  const plus = (a, b, factor = 1) => [a[0] + factor * b[0], a[1] + factor * b[1]];
  const times = (factor, a) => [factor * a[0], factor * a[1]];

  // Returns the velocity (02.6) of a density eta at a source with the normal n, seen from target = source + r.
  function stresslet(r, n, eta) {
    const square = dot(r, r);
    return times(dot(r, n) * dot(r, eta) / (Math.PI * square * square), r);
  }

  // Returns n nodes of the ellipse (a cos t, b sin t) as {x, normal, weight, tangent, curvature}. Normals point
  // into the ellipse: the fluid is outside.
  function ellipse(a, b, n) {
    return Array.from({length: n}, (_, j) => {
      const t = 2 * Math.PI * j / n, [c, s] = [Math.cos(t), Math.sin(t)];
      const speed = Math.hypot(a * s, b * c);
      return {x: [a * c, b * s], normal: [-b * c / speed, -a * s / speed], weight: 2 * Math.PI / n * speed,
              tangent: [-a * s / speed, b * c / speed], curvature: a * b / speed ** 3};
    });
  }

  // Returns the double layer of nodes with a density at a target, by the trapezoid rule. As in the library, a
  // distance below half a weight counts as half a weight.
  function layer(nodes, density, target) {
    return nodes.reduce((sum, {x, normal, weight}, j) => {
      const r = plus(target, x, -1), rho = Math.hypot(...r), least = Math.max(rho, weight / 2);
      if (rho === 0) return sum;
      return plus(sum, stresslet(r, normal, density[j]), weight * (rho / least) ** 4);
    }, [0, 0]);
  }

  return {dot, plus, times, stresslet, ellipse, layer};
})();
