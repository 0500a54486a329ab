// Chapter 08: the flow of many bodies' nodes by one level of boxes, written out, beside the direct
// sum and the whole method; and what one box of the tree sees of the others.
//
//   chapter_08 [DIRECTORY]    prints tables; draws chapter_08_tree.svg into the directory
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "double_layer/stresslet_sum.hpp"
#include "fmm/fmm.hpp"
#include "record/atomic_file.hpp"
#include "record/svg.hpp"
#include "trapezoid/curve.hpp"

using namespace stokesbook;
using Eigen::Index;

namespace {

/// Ellipses between two circles of radius 0.3 and 1, placed like the seeds of a sunflower.
std::vector<Curve> scene(Index bodies) {
  std::vector<Curve> curves{sample(Circle{0.3}, 128, Side::fluid_outside),
                            sample(Circle{1.0}, 256, Side::fluid_inside)};
  const double size = 0.6 / std::sqrt(static_cast<double>(bodies));
  const Curve ellipse = sample(Ellipse{size, 0.5 * size}, 32, Side::fluid_outside);
  for (Index k = 0; k < bodies; ++k) {
    const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(bodies);
    const double radius = std::sqrt(0.14 + 0.76 * share), angle = 2.4 * static_cast<double>(k);
    curves.push_back(place(ellipse, std::polar(radius, angle), 3.0 * angle));
  }
  return curves;
}

/// Waves along the nodes.
ComplexVector density_of(Index n) {
  ComplexVector density(n);
  for (Index j = 0; j < n; ++j) {
    const double t = 0.2 * static_cast<double>(j);
    density[j] = {0.3 + std::cos(t), std::sin(1.7 * t)};
  }
  return density;
}

/// Nodes and densities in the order of a tree, in which the nodes of a box follow each other.
struct SortedNodes : StressletNodes {
  SortedNodes(const std::vector<Curve>& curves, const ComplexVector& density, const Quadtree& tree)
      : StressletNodes(curves), ex(density(tree.order).real()), ey(density(tree.order).imag()) {
    for (Eigen::VectorXd* part : {&x, &y, &nx, &ny, &least2}) *part = (*part)(tree.order).eval();
  }

  StressletBlock of(const Box& box) const {
    const Index i = box.first;
    return {&x[i], &y[i], &nx[i], &ny[i], &least2[i], box.size(), &ex[i], &ey[i]};
  }

  Eigen::VectorXd ex, ey;
};

/// Velocities, and the operations that they took in kernel evaluations: pairs of nodes, and p^2/2
/// for an expansion converted.
struct Sum {
  ComplexVector velocity;
  double operations = 0.0;
};

double conversion(int order) {
  return 0.5 * order * order;
}

// [separated]
/// Whether both expansions of a pair of boxes fall like 2^-k.
bool well_separated(const Box& target, const Box& source) {
  const double distance = std::abs(target.centre - source.centre);
  return source.radius < 0.5 * (distance - target.radius) &&
         target.radius < 0.5 * (distance - source.radius);
}
// [separated]

/// Velocities at the nodes of a box: near boxes directly, the others by one local expansion.
void add_velocities(const Box& box, const Expansion& local, const std::vector<Box>& near,
                    const SortedNodes& nodes, const Quadtree& tree, ComplexVector& velocity) {
  for (Index first = box.first; first < box.last; first += VectorGroup::size) {
    VectorGroup targets;
    std::array<VectorGroup, 1> sum{};
    const Index count = std::min<Index>(VectorGroup::size, box.last - first);
    for (Index i = 0; i < count; ++i) {
      targets.x[static_cast<std::size_t>(i)] = nodes.x[first + i];
      targets.y[static_cast<std::size_t>(i)] = nodes.y[first + i];
    }
    for (const Box& source : near) add_velocities<1>(nodes.of(source), targets, sum);
    l2p(box, local, targets, sum[0]);
    for (Index i = 0; i < count; ++i) {
      const auto lane = static_cast<std::size_t>(i);
      velocity[tree.order[static_cast<std::size_t>(first + i)]] = {sum[0].x[lane], sum[0].y[lane]};
    }
  }
}

/// The sum with one level of boxes: the leaves of a tree whose levels it does not use.
Sum one_level(const std::vector<Curve>& curves, const ComplexVector& density, int order,
              Index leaf_size) {
  const ComplexVector points = all_nodes(curves);
  const Quadtree tree(points, {}, leaf_size);
  const SortedNodes nodes(curves, density, tree);
  const Translations translations(order);
  const std::vector<Box>& boxes = tree.boxes;
  const auto count = static_cast<Index>(boxes.size());

  Expansions multipole(count, 1, order);
  for (Index b = 0; b < count; ++b) {
    const Box& box = boxes[static_cast<std::size_t>(b)];
    multipole.clear(b);
    if (box.is_leaf()) p2m(box, nodes.of(box), multipole(b, 0));
  }

  Sum sum{ComplexVector(points.size())};
  for (const Box& target : boxes) {
    if (!target.is_leaf()) continue;
    std::vector<Index> far;
    std::vector<Box> near;
    for (Index s = 0; s < count; ++s) {
      const Box& source = boxes[static_cast<std::size_t>(s)];
      if (!source.is_leaf()) continue;
      if (well_separated(target, source)) {
        far.push_back(s);
      } else {
        near.push_back(source);
        sum.operations += static_cast<double>(target.size() * source.size());
      }
    }
    sum.operations += conversion(order) * static_cast<double>(far.size());
    Expansion local = Expansion::Zero(4, order + 1);
    translations.m2l(boxes, multipole, far, 0, target, local);
    add_velocities(target, local, near, nodes, tree, sum.velocity);
  }
  return sum;
}

/// The sum with all levels: the library's.
Sum all_levels(const std::vector<Curve>& curves, const ComplexVector& density, int order,
               Index leaf_size) {
  const Fmm plan(curves, {}, {order, leaf_size});
  Sum sum{plan.velocity(density)};
  const std::vector<Box>& boxes = plan.targets().boxes;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    sum.operations += conversion(order) * static_cast<double>(plan.interactions().far[b].size());
    for (const Range range : plan.interactions().near[b]) {
      sum.operations += static_cast<double>(boxes[b].size() * (range.last - range.first));
    }
  }
  return sum;
}

void print_errors() {
  const std::vector<Curve> curves = scene(120);
  const StressletSum direct(curves);
  const ComplexVector density = density_of(direct.size()), exact = direct(density);
  const auto error = [&](const Sum& sum) { return (sum.velocity - exact).norm() / exact.norm(); };
  std::printf("error by the order, %td nodes\n\n%8s %14s %14s\n", direct.size(), "order",
              "one level", "all levels");
  for (int order = 4; order <= 40; order += 6) {
    std::printf("%8d %14.1e %14.1e\n", order, error(one_level(curves, density, order, 80)),
                error(all_levels(curves, density, order, 80)));
  }
}

/// One level has the better of some leaf sizes about the best one.
void print_operations() {
  constexpr int order = 18;
  std::printf("\noperations a node, order %d\n\n%8s %14s %14s %14s\n", order, "nodes", "direct sum",
              "one level", "all levels");
  for (const Index bodies : {120, 240, 480, 960}) {
    const std::vector<Curve> curves = scene(bodies);
    const ComplexVector density = density_of(all_nodes(curves).size());
    const auto n = static_cast<double>(density.size());
    double one = n * n;
    for (const double size : {0.5, 1.0, 2.0}) {
      const Index leaf_size = std::lround(size * std::cbrt(n * order * order / 13.0));
      one = std::min(one, one_level(curves, density, order, leaf_size).operations);
    }
    const double all = all_levels(curves, density, order, 68).operations;
    std::printf("%8.0f %14.0f %14.0f %14.0f\n", n, n, one / n, all / n);
  }
}

/// @name The picture: the leaves of a tree, and what acts on one of them
/// @{
constexpr double half = 205.0, panel = 420.0, gap = 20.0;  // pixels
const std::string leaf_colour = "#d6336c", near_colour = "#e8710a";
const std::array<std::string, 6> far_colours{"#7048e8", "#4263eb", "#1c7ed6",
                                             "#0ca678", "#94a716", "#b08900"};

Complex to_pixel(Complex z) {
  return {0.5 * panel + half * z.real(), 0.5 * panel - half * z.imag()};
}

/// The bounding rectangle of a box's nodes.
std::string rectangle(const Quadtree& tree, const Box& box) {
  const auto [left, right] = std::minmax_element(&tree.x[box.first], &tree.x[box.last - 1] + 1);
  const auto [low, high] = std::minmax_element(&tree.y[box.first], &tree.y[box.last - 1] + 1);
  const Complex a = to_pixel({*left, *high}) - Complex{1.0, 1.0},
                b = to_pixel({*right, *low}) + Complex{1.0, 1.0};
  return svg::polygon(
      ComplexVector{{a, Complex{b.real(), a.imag()}, b, Complex{a.real(), b.imag()}}});
}

std::string rectangles(const Quadtree& tree, const std::vector<Box>& boxes) {
  std::string data;
  for (const Box& box : boxes) data += rectangle(tree, box);
  return data;
}

std::string filled(const std::string& data, const std::string& colour, double opacity) {
  return svg::path(data, "fill=\"" + colour + "\" stroke=\"" + colour + "\"" +
                             svg::attribute("fill-opacity", opacity));
}

std::string dots(const Quadtree& tree) {
  std::string data;
  for (Index i = 0; i < tree.size(); ++i) {
    const Complex z = to_pixel({tree.x[i], tree.y[i]});
    data += svg::line(z, z);
  }
  return svg::path(data, "stroke=\"currentColor\" stroke-width=\"1.3\" stroke-linecap=\"round\"");
}

std::vector<Box> leaves_of(const Quadtree& tree) {
  std::vector<Box> leaves;
  std::ranges::copy_if(tree.boxes, std::back_inserter(leaves), &Box::is_leaf);
  return leaves;
}

/// What acts on a leaf: near leaves, and far boxes by the level of the box that they act on, which
/// is the leaf or contains it.
struct Seen {
  std::vector<Box> near;
  std::vector<std::vector<Box>> far;
};

Seen seen_from(Index leaf, const Quadtree& tree) {
  const Interactions lists = find_interactions(tree, tree, 0);
  Seen seen;
  for (const Range range : lists.near[static_cast<std::size_t>(leaf)]) {
    for (const Box& box : leaves_of(tree)) {
      if (range.first <= box.first && box.last <= range.last) seen.near.push_back(box);
    }
  }
  for (Index b = leaf; b >= 0; b = tree.boxes[static_cast<std::size_t>(b)].parent) {
    seen.far.emplace_back();
    for (const Index source : lists.far[static_cast<std::size_t>(b)]) {
      seen.far.back().push_back(tree.boxes[static_cast<std::size_t>(source)]);
    }
  }
  std::ranges::reverse(seen.far);
  return seen;
}

/// The leaf whose centre is nearest to a point.
Index leaf_at(const Quadtree& tree, Complex z) {
  const std::vector<Box>& boxes = tree.boxes;
  const auto distance = [z](const Box& box) {
    return box.is_leaf() ? std::abs(box.centre - z) : std::numeric_limits<double>::infinity();
  };
  return std::ranges::min_element(boxes, {}, distance) - boxes.begin();
}

/// A line of the legend, in one of two columns.
std::string entry(int place, const std::string& colour, const std::string& text) {
  const Complex at{1.0 + (panel + gap) * (place % 2), panel + 16.0 + 22.0 * (place / 2)};
  return filled(svg::polygon(ComplexVector{
                    {at, at + 14.0, at + Complex{14.0, 12.0}, at + Complex{0.0, 12.0}}}),
                colour, 0.35) +
         svg::label(at + Complex{22.0, 11.0}, text);
}

std::string picture_of_tree() {
  const Quadtree tree(all_nodes(scene(120)), {}, 40);
  const Index leaf = leaf_at(tree, {0.42, 0.3});
  const Seen seen = seen_from(leaf, tree);
  int place = 0;
  std::string boxes, legend = entry(place++, leaf_colour, "one of the leaves");
  legend += entry(place++, near_colour, "near leaves, summed directly");
  for (std::size_t level = 0; level < seen.far.size(); ++level) {
    if (seen.far[level].empty()) continue;
    const std::string& colour = far_colours[std::min(level, far_colours.size() - 1)];
    boxes += filled(rectangles(tree, seen.far[level]), colour, 0.25);
    legend += entry(place++, colour, "far from its box of level " + std::to_string(level));
  }
  boxes += filled(rectangles(tree, seen.near), near_colour, 0.35) +
           filled(rectangle(tree, tree.boxes[static_cast<std::size_t>(leaf)]), leaf_colour, 0.9);
  return svg::open({2.0 * panel + gap, panel + 22.0 * ((place + 1) / 2) + 16.0},
                   "The leaves of a tree, and what acts on one of them") +
         "<g opacity=\"0.55\">" + filled(rectangles(tree, leaves_of(tree)), "currentColor", 0.07) +
         "</g>\n" + dots(tree) + "<g transform=\"translate(" + svg::number(panel + gap) + " 0)\">" +
         boxes + dots(tree) + "</g>\n" + legend + "</svg>\n";
}
/// @}

}  // namespace

int main(int argc, char** argv) {
  print_errors();
  print_operations();
  if (argc > 1) {
    write_atomically(std::filesystem::path(argv[1]) / "chapter_08_tree.svg", picture_of_tree(),
                     SafeFrom::kill);
  }
}
