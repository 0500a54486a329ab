// Chapter 11: two contacts and the cones of their problem; pivots on Murty's matrix; disks that are
// drawn together, and the forces that keep them apart.
//
//   chapter_11 [DIRECTORY]    prints tables; draws chapter_11_cones.svg and chapter_11_network.svg
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "lcp/barzilai_borwein.hpp"
#include "lcp/contact_loop.hpp"
#include "lcp/newton.hpp"
#include "lcp/projected_gauss_seidel.hpp"
#include "record/atomic_file.hpp"
#include "record/svg.hpp"

using namespace stokesbook;
using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

Matrix2d matrix2(double a, double b, double c, double d) {
  return (Matrix2d() << a, b, c, d).finished();
}

// [two]
void print_two_contacts(const Matrix2d& matrix, const Vector2d& offset) {
  const LcpResult result = lemke({matrix, offset});
  std::printf("  M = (%g %g; %g %g), q = (%g, %g): ", matrix(0, 0), matrix(0, 1), matrix(1, 0),
              matrix(1, 1), offset[0], offset[1]);
  if (result.status == LcpStatus::ray) {
    const Vector2d v = result.ray, product = matrix.transpose() * v;
    std::printf("a ray v = (%g, %g), M^T v = (%g, %g), q v = %g\n", v[0], v[1], product[0],
                product[1], offset.dot(v));
    return;
  }
  const Vector2d z = result.z, w = offset + matrix * z;
  std::printf("z = (%g, %g), w = (%g, %g), %d pivots\n", z[0], z[1], w[0], w[1], result.iterations);
}
// [two]

void print_pairs() {
  std::puts("Two contacts, by Lemke's method");
  const Matrix2d apart = matrix2(2.0, 1.0, 1.0, 2.0), opposed = matrix2(1.0, -1.0, -1.0, 1.0);
  print_two_contacts(apart, {1.0, -1.0});
  print_two_contacts(apart, {-2.0, -3.0});
  print_two_contacts(apart, {-1.0, -3.0});
  print_two_contacts(opposed, {-1.0, 2.0});
  print_two_contacts(opposed, {-1.0, -1.0});
}

// [murty]
LcpProblem murty(Index m) {
  MatrixXd matrix = MatrixXd::Identity(m, m);
  matrix.triangularView<Eigen::StrictlyLower>().setConstant(2.0);
  return {matrix, -VectorXd::Ones(m)};
}
// [murty]

void print_murty() {
  std::puts("\nMurty's matrix: pivots, steps, sweeps, products\n");
  std::puts("     m   Lemke   Fischer   minimum map   Gauss-Seidel   Barzilai-Borwein");
  for (const Index m : {2, 4, 8, 12, 16}) {
    const LcpProblem problem = murty(m);
    std::printf("%6d%8d%10d%14d%15d%19d\n", static_cast<int>(m),
                lemke(problem, {.max_iterations = 100000}).iterations,
                fischer_newton(problem).iterations, minimum_map_newton(problem).iterations,
                projected_gauss_seidel(problem).iterations, barzilai_borwein(problem).iterations);
  }
}

constexpr double separation = 0.05;

/// Disks of radius 1/2: centres (x_0, y_0, x_1, ...), what they do when nothing is in their way,
/// and the forces between them.
struct Disks {
  VectorXd centres;
  std::vector<ContactKey> keys = {};
  VectorXd forces = {};
};

// [rows]
/// Pairs that end nearer than twice the separation. A row's name is its pair's.
ContactRows rows_of(const VectorXd& end) {
  const Index n = end.size();
  std::vector<double> gaps;
  std::vector<ContactKey> keys;
  std::vector<Eigen::Triplet<double>> entries;
  for (Index i = 0; i < n; i += 2) {
    for (Index j = i + 2; j < n; j += 2) {
      const Vector2d apart = end.segment<2>(j) - end.segment<2>(i);
      const double gap = apart.norm() - 1.0 - separation;
      if (gap > separation) continue;
      const Index row = static_cast<Index>(gaps.size());
      const Vector2d normal = apart.normalized();
      for (const int axis : {0, 1}) {
        entries.emplace_back(row, j + axis, normal[axis]);
        entries.emplace_back(row, i + axis, -normal[axis]);
      }
      gaps.push_back(gap);
      keys.push_back({i * n + j, 0});
    }
  }
  const Index m = static_cast<Index>(gaps.size());
  GapGradient gradient(m, n);
  gradient.setFromTriplets(entries.begin(), entries.end());
  return {VectorXd::Map(gaps.data(), m), gradient, {}, keys};
}
// [rows]

// [step]
/// A step of disks that are drawn to the origin, each moved by the force on it alone: B = 1.
ContactResult step(const VectorXd& centres, double dt) {
  const ContactStep step{
      .free_velocity = -centres,
      .dt = dt,
      .separation = separation,
      .tolerance = 1e-3 * separation,
      .rows = [&](const VectorXd& velocity) { return rows_of(centres + dt * velocity); },
      .respond = [](const Eigen::SparseMatrix<double>& forces) -> MatrixXd { return forces; }};
  return resolve_contact(step);
}
// [step]

/// Points of a lattice, a little off their places.
VectorXd start() {
  VectorXd centres(38);
  Index k = 0;
  for (int a = -2; a <= 2; ++a) {
    for (int b = -2; b <= 2; ++b) {
      if (std::abs(a + b) > 2) continue;
      const double off = 0.2 * std::sin(7.0 * a + 3.0 * b);
      centres[k++] = 1.8 * (a + 0.5 * b) + off;
      centres[k++] = 1.8 * std::sqrt(0.75) * b - off;
    }
  }
  return centres;
}

double least_gap(const VectorXd& centres) {
  const ContactRows rows = rows_of(centres);
  return rows.gap.size() > 0 ? rows.gap.minCoeff() : separation;
}

// [run]
Disks run() {
  Disks disks{start()};
  std::puts("\nDisks that are drawn together\n");
  std::puts("     t     dt   rows   forces   problems   least gap   largest    power   net force");
  double t = 0.0;
  for (int k = 0; t < 2.0 - 1e-9; ++k) {
    double dt = 0.25;
    ContactResult result = step(disks.centres, dt);
    while (result.status != ContactStatus::resolved && dt > 1e-4) {
      dt *= 0.5;
      result = step(disks.centres, dt);
    }
    if (result.status != ContactStatus::resolved) throw std::runtime_error(result.reason);
    t += dt;
    disks = {disks.centres + dt * result.velocity, result.keys, result.multipliers};
    const Index forces = (result.multipliers.array() > 0.0).count();
    const double largest = forces > 0 ? result.multipliers.maxCoeff() : 0.0;
    const Vector2d net{result.force(Eigen::seq(0, 37, 2)).sum(),
                       result.force(Eigen::seq(1, 37, 2)).sum()};
    std::printf("%6.3f%7.3f%7d%9d%11d%12.1e%10.3f%9.0e%12.0e\n", t, dt,
                static_cast<int>(result.keys.size()), static_cast<int>(forces), result.iterations,
                least_gap(disks.centres), largest, result.power, net.norm());
  }
  return disks;
}
// [run]

/// @name Pictures
/// @{
std::string stroke(const std::string& colour, double width) {
  return "fill=\"none\" stroke-linecap=\"round\" stroke=\"" + colour + "\"" +
         svg::attribute("stroke-width", width);
}

std::string fill(const std::string& colour) {
  return "fill-opacity=\"0.28\" fill=\"" + colour + "\"";
}

Complex as_complex(const Vector2d& x) {
  return {x[0], x[1]};
}

/// The four cones of M, each spanned by e_i or -M_i for i = 1 and 2.
std::string cones(const Matrix2d& matrix, Complex origin) {
  const char* colours[] = {"#868e96", "#1c7ed6", "#e8710a", "#2b8a3e"};
  const auto pixel = [&](const Vector2d& x) { return origin + 75.0 * std::conj(as_complex(x)); };
  std::string picture;
  for (int set = 0; set < 4; ++set) {
    Vector2d sides[2];
    for (int i = 0; i < 2; ++i) {
      sides[i] = set >> i & 1 ? Vector2d(-matrix.col(i)) : Vector2d(Matrix2d::Identity().col(i));
      sides[i].normalize();
    }
    ComplexVector corners(22);
    corners[0] = origin;
    for (Index k = 0; k < 21; ++k) {
      const double part = static_cast<double>(k) / 20.0;
      const Vector2d between = (1.0 - part) * sides[0] + part * sides[1];
      corners[k + 1] = pixel(between.norm() > 1e-9 ? Vector2d(between.normalized()) : sides[0]);
    }
    picture += svg::path(svg::polygon(corners), fill(colours[set]));
    for (const Vector2d& side : sides) {
      picture += svg::path(svg::line(origin, pixel(side)), stroke("currentColor", 1.0));
    }
  }
  return picture;
}

std::string dot(Complex place, const std::string& text) {
  return svg::path(svg::line(place, place), stroke("currentColor", 6.0)) +
         svg::label(place + Complex{7.0, 4.0}, text);
}

std::string picture_of_cones() {
  const Complex left{105.0, 110.0}, middle{325.0, 110.0}, right{545.0, 110.0};
  const Complex q = left + Complex{-45.0, 53.0};
  const std::string path = "stroke-dasharray=\"5 4\" " + stroke("currentColor", 1.5);
  return svg::open({650.0, 260.0}, "Complementary cones of three matrices") +
         cones(matrix2(2.0, 1.0, 1.0, 2.0), left) +
         svg::path(svg::line(q, q + Complex{110.0, -110.0}), path) + dot(q, "q") +
         cones(matrix2(1.0, -1.0, -1.0, 1.0), middle) + dot(middle + Complex{-45.0, 45.0}, "q") +
         cones(matrix2(1.0, 2.0, 2.0, 1.0), right) + dot(right + Complex{-45.0, 45.0}, "q") +
         svg::label({25.0, 222.0}, "M = (2 1; 1 2)") +
         svg::label({25.0, 242.0}, "one cone for each q") +
         svg::label({245.0, 222.0}, "M = (1 -1; -1 1)") +
         svg::label({245.0, 242.0}, "none for this q: a ray") +
         svg::label({465.0, 222.0}, "M = (1 2; 2 1)") +
         svg::label({465.0, 242.0}, "three for this q") + "</svg>\n";
}

std::string picture_of_network(const Disks& disks) {
  const auto pixel = [](const Vector2d& x) {
    return Complex{300.0, 250.0} + 85.0 * std::conj(as_complex(x));
  };
  const Index n = disks.centres.size();
  std::string picture = svg::open({600.0, 500.0}, "Forces between disks that are drawn together");
  for (Index i = 0; i < n; i += 2) {
    ComplexVector outline(48);
    for (Index k = 0; k < 48; ++k) {
      outline[k] = pixel(disks.centres.segment<2>(i)) +
                   std::polar(0.5 * 85.0, 2.0 * pi * static_cast<double>(k) / 48.0);
    }
    picture += svg::path(svg::polygon(outline), "stroke=\"currentColor\" " + fill("#868e96"));
  }
  const double largest = disks.forces.maxCoeff();
  for (std::size_t k = 0; k < disks.keys.size(); ++k) {
    const double force = disks.forces[static_cast<Index>(k)];
    if (force <= 0.0) continue;
    const Index i = disks.keys[k].contact / n, j = disks.keys[k].contact % n;
    picture +=
        svg::path(svg::line(pixel(disks.centres.segment<2>(i)), pixel(disks.centres.segment<2>(j))),
                  stroke("#e8710a", std::max(0.5, 12.0 * force / largest)));
  }
  return picture + "</svg>\n";
}
/// @}

}  // namespace

int main(int argc, char** argv) {
  print_pairs();
  print_murty();
  const Disks disks = run();
  if (argc > 1) {
    const std::filesystem::path directory = argv[1];
    write_atomically(directory / "chapter_11_cones.svg", picture_of_cones(), SafeFrom::kill);
    write_atomically(directory / "chapter_11_network.svg", picture_of_network(disks),
                     SafeFrom::kill);
  }
}
