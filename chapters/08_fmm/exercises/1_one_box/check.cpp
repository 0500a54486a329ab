// Check of exercise 08.1: the library's expansions, the kernel, and the direct sum.
#include "chapters/check.hpp"

#include <numbers>

#include "fmm/expansions.hpp"
#include "support/vectors.hpp"

using namespace stokesbook;
using Eigen::Index;
using exercise::expect;
using std::numbers::pi;
using test::random_vector;

struct Sources {
  ComplexVector t, a;
  Eigen::VectorXd b;
};

ComplexVector phi_coefficients(const Sources& sources, Complex centre, double radius, int order);
ComplexVector psi_coefficients(const Sources& sources, Complex centre, double radius, int order);
Complex multipole_velocity(const ComplexVector& phi, const ComplexVector& psi, Complex centre,
                           double radius, Complex z);
ComplexVector one_level(const Sources& sources, int side, int order);

namespace {

constexpr int order = 12;

// Normals times weight and densities of some nodes, and their strengths.
struct Nodes {
  Nodes(const ComplexVector& places, unsigned seed)
      : t(places), n(random_vector(t.size(), seed)), eta(random_vector(t.size(), seed + 1)) {}

  Sources sources() const {
    const ComplexVector a = n.cwiseProduct(eta) / (4.0 * pi);
    return {t, a, n.conjugate().cwiseProduct(eta).real() / (2.0 * pi)};
  }

  // Rows A and B.
  Eigen::Matrix2Xcd coefficients(const Box& box) const {
    const Eigen::VectorXd x = t.real(), y = t.imag(), nx = n.real() / pi, ny = n.imag() / pi,
                          ex = eta.real(), ey = eta.imag(),
                          least2 = Eigen::VectorXd::Zero(t.size());
    Expansion sum = Expansion::Zero(4, order + 1);
    p2m(box,
        StressletBlock{x.data(), y.data(), nx.data(), ny.data(), least2.data(), t.size(), ex.data(),
                       ey.data()},
        sum);
    Eigen::Matrix2Xcd both(2, order);
    for (Index k = 0; k < order; ++k) {
      both(0, k) = {sum(0, k + 1), sum(1, k + 1)};
      both(1, k) = {sum(2, k + 1), sum(3, k + 1)};
    }
    return both;
  }

  ComplexVector t, n, eta;
};

Box box_at(Complex centre, double radius) {
  Box box;
  box.centre = centre;
  box.radius = radius;
  return box;
}

struct Case {
  std::string name;
  Box box;
  Nodes nodes;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Box& box : {box_at({0.0, 0.0}, 1.0), box_at({3.0, -2.0}, 0.5)}) {
    const ComplexVector places =
        (box.centre + 0.7 * box.radius * random_vector(7, 1).array()).matrix();
    all.push_back(
        {"7 sources about " + exercise::text(box.centre) + ", radius " + exercise::text(box.radius),
         box,
         {places, 2}});
  }
  return all;
}

void check_phi() {
  for (const auto& [name, box, nodes] : cases()) {
    const ComplexVector exact = nodes.coefficients(box).row(0);
    const Eigen::ArrayXcd w = (nodes.t.array() - box.centre) / box.radius;
    Nodes late = nodes;
    late.eta = (nodes.eta.array() * w).matrix();  // W^k for W^(k-1)
    expect({.what = name,
            .got = phi_coefficients(nodes.sources(), box.centre, box.radius, order),
            .expected = exact,
            .tolerance = 1e-12,
            .mistakes = {{ComplexVector(late.coefficients(box).row(0)), "the power of W is k - 1"},
                         {box.radius * exact, "the factor 1/R is missing"}}});
  }
}

void check_psi() {
  for (const auto& [name, box, nodes] : cases()) {
    const Sources sources = nodes.sources();
    const ComplexVector exact = nodes.coefficients(box).row(1);
    // What differs: conj(c)/R (k - 1) A_(k-1), and all of the double pole.
    ComplexVector origin = exact, simple(order);
    const ComplexVector phi = nodes.coefficients(box).row(0);
    const Eigen::ArrayXcd w = (nodes.t.array() - box.centre) / box.radius;
    for (Index k = 1; k <= order; ++k) {
      if (k > 1) {
        origin[k - 1] +=
            std::conj(box.centre) / box.radius * static_cast<double>(k - 1) * phi[k - 2];
      }
      simple[k - 1] = -(sources.b.array() * w.pow(static_cast<double>(k - 1))).sum() / box.radius;
    }
    expect({.what = name,
            .got = psi_coefficients(sources, box.centre, box.radius, order),
            .expected = exact,
            .tolerance = 1e-12,
            .mistakes = {{origin, "conj(t) has to be measured from the centre: psi is psi_c"},
                         {simple, "the double pole is missing: (k - 1) a conj(W) W^(k-2)"},
                         {-exact, "psi has the minus of the formula"}}});
  }
}

Complex kernel(const Sources& sources, Index j, Complex r) {
  const Complex c = std::conj(r);
  return sources.a[j] / r + sources.b[j] / c + r * std::conj(sources.a[j]) / (c * c);
}

void check_velocity() {
  for (const auto& [name, box, nodes] : cases()) {
    const Eigen::Matrix2Xcd both = nodes.coefficients(box);
    for (const double angle : {0.3, 2.5, 4.4}) {
      const Complex zeta = std::polar(20.0 * box.radius, angle), z = box.centre + zeta;
      Complex exact{};
      for (Index j = 0; j < nodes.t.size(); ++j)
        exact += kernel(nodes.sources(), j, z - nodes.t[j]);
      Complex slope{};
      for (Index k = 1; k <= order; ++k) {
        slope -= static_cast<double>(k) / zeta * both(0, k - 1) *
                 std::pow(box.radius / zeta, static_cast<double>(k));
      }
      expect({.what = name + ", at a distance of 20 radii",
              .got = multipole_velocity(both.row(0), both.row(1), box.centre, box.radius, z),
              .expected = exact,
              .tolerance = 1e-10,
              .mistakes = {{exact - box.centre * std::conj(slope),
                            "the slope is multiplied by z - c, not by z"},
                           {exact + 2.0 * zeta * std::conj(slope), "phi' has a minus"}}});
    }
  }
}

void check_one_level() {
  const Index n = 900;
  const Complex corner{1.0, 1.0};
  const Nodes nodes((0.5 * (random_vector(n, 5).array() + corner)).matrix(), 6);
  const Sources sources = nodes.sources();
  for (const int side : {3, 6}) {
    ComplexVector exact = ComplexVector::Zero(n), near = exact;
    const auto box = [&](Complex z) {
      return std::pair{static_cast<int>(z.real() * side), static_cast<int>(z.imag() * side)};
    };
    for (Index i = 0; i < n; ++i) {
      for (Index j = 0; j < n; ++j) {
        if (i == j) continue;
        const auto [x, y] = box(sources.t[i]);
        const auto [other_x, other_y] = box(sources.t[j]);
        const Complex velocity = kernel(sources, j, sources.t[i] - sources.t[j]);
        exact[i] += velocity;
        if (std::max(std::abs(x - other_x), std::abs(y - other_y)) <= 1) near[i] += velocity;
      }
    }
    // The ratio is below sqrt(2)/3, and p rho^p = 2e-9 at p = 32, of each of the sources.
    expect({.what = std::to_string(n) + " sources, " + std::to_string(side) + " x " +
                    std::to_string(side) + " boxes, order 32",
            .got = one_level(sources, side, 32),
            .expected = exact,
            .tolerance = 1e-8,
            .mistakes = {{near, "far boxes are left out"},
                         {ComplexVector(exact - near), "near boxes are left out"}}});
  }
}

}  // namespace

int main() {
  return exercise::run({{.title = "the coefficients of phi",
                         .formula = "A_k = (1/R) sum a W^(k-1)",
                         .hint = "a geometric series in R W/zeta",
                         .check = check_phi},
                        {.title = "the coefficients of psi",
                         .formula = "B_k = -(1/R) sum (b W^(k-1) - (k-1) a conj(W) W^(k-2))",
                         .hint = "differentiate the geometric series for the double pole",
                         .check = check_psi},
                        {.title = "the velocity far away",
                         .formula = "u = phi - zeta conj(phi') - conj(psi_c)",
                         .hint = "phi' = -(1/zeta) sum k A_k (R/zeta)^k",
                         .check = check_velocity},
                        {.title = "one level of boxes",
                         .builds_on = {1, 2, 3},
                         .formula = "near boxes directly, far boxes by their expansions",
                         .hint = "boxes are near if row and column differ by at most one",
                         .check = check_one_level}});
}
