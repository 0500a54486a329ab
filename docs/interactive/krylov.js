// GMRES with the polynomial of its residual. Called by gmres.js.
window.krylov ??= (() => {
  const dot = (a, b) => a.reduce((sum, value, i) => sum + value * b[i], 0);
  const minus = (a, factor, b) => a.map((value, i) => value - factor * b[i]);

  // Arnoldi's method with two passes, for a unit vector b. Returns the
  // columns of H; the last one may have no subdiagonal entry.
  function arnoldi(multiply, b, steps) {
    const basis = [b], columns = [];
    for (let k = 0; k < steps; ++k) {
      let w = multiply(basis[k]);
      const column = new Array(k + 1).fill(0), before = Math.sqrt(dot(w, w));
      for (let pass = 0; pass < 2; ++pass) {
        const h = basis.map(v => dot(v, w));
        h.forEach((value, i) => { w = minus(w, value, basis[i]); column[i] += value; });
      }
      const length = Math.sqrt(dot(w, w));
      columns.push(column);
      if (length <= 1e-13 * before) break;
      column.push(length);
      basis.push(w.map(value => value / length));
    }
    return columns;
  }

  // Rotations make H triangular. Returns the residuals, and y of least residual after k steps.
  function leastSquares(columns, k) {
    const rotations = [], right = [1], residuals = [1], triangle = [];
    columns.forEach((column, j) => {
      const h = [...column, 0].slice(0, j + 2);
      rotations.forEach(([c, s], i) => [h[i], h[i + 1]] = [c * h[i] + s * h[i + 1], c * h[i + 1] - s * h[i]]);
      const rho = Math.hypot(h[j], h[j + 1]), c = rho ? h[j] / rho : 1, s = rho ? h[j + 1] / rho : 0;
      rotations.push([c, s]);
      triangle.push([...h.slice(0, j), rho]);
      right.push(-s * right[j]);
      right[j] *= c;
      residuals.push(Math.abs(right[j + 1]));
    });
    const y = right.slice(0, Math.min(k, columns.length));
    for (let j = y.length - 1; j >= 0; --j) {
      y[j] = triangle[j][j] ? y[j] / triangle[j][j] : 0;
      for (let i = 0; i < j; ++i) y[i] -= triangle[j][i] * y[j];
    }
    return {residuals, y};
  }

  // |p_k(z)|: the recurrence of Arnoldi's basis holds for polynomials, with z in place of the matrix.
  function modulus(columns, y, [x0, y0]) {
    const real = [1], imaginary = [0];
    let p = 0, q = 0;
    for (let k = 0; k < y.length; ++k) {
      const a = real[k], b = imaginary[k], column = columns[k];
      p += y[k] * a;
      q += y[k] * b;
      let c = x0 * a - y0 * b, d = x0 * b + y0 * a;
      for (let i = 0; i <= k; ++i) { c -= column[i] * real[i]; d -= column[i] * imaginary[i]; }
      real.push(c / column[k + 1]);
      imaginary.push(d / column[k + 1]);
    }
    return Math.hypot(1 - x0 * p + y0 * q, x0 * q + y0 * p);
  }

  return {arnoldi, leastSquares, modulus, dot};
})();
