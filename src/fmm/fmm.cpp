#include "fmm/fmm.hpp"

#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "double_layer/stresslet_block.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

ComplexVector all_nodes(const std::vector<Curve>& curves) {
  Index n = 0;
  for (const Curve& curve : curves) n += curve.size();
  ComplexVector nodes(n);
  Index first = 0;
  for (const Curve& curve : curves) {
    nodes.segment(first, curve.size()) = curve.x;
    first += curve.size();
  }
  return nodes;
}

template <class Vector>
Vector in_tree_order(const Vector& v, const std::vector<Index>& order) {
  Vector result(v.size());
  for (std::size_t i = 0; i < order.size(); ++i) result[static_cast<Index>(i)] = v[order[i]];
  return result;
}

// The columns of a box in the expansions of all boxes.
auto of_box(Expansion& all, Index box, Index columns) {
  return all.middleCols(box * columns, columns);
}
auto of_box(const Expansion& all, Index box, Index columns) {
  return all.middleCols(box * columns, columns);
}

std::span<const Index> list_of(const Lists& lists, Index box) {
  const auto k = static_cast<std::size_t>(box);
  return {lists.entries.data() + lists.begin[k],
          static_cast<std::size_t>(lists.begin[k + 1] - lists.begin[k])};
}

// Pairs of points that cost as much as a translation of an order.
Index direct_pairs(int order) {
  return order * order / 2;
}

}  // namespace

FmmSettings FmmSettings::for_tolerance(double tolerance) {
  if (!(tolerance > 0.0)) {
    throw std::invalid_argument("the tolerance of an FMM must be > 0, got " +
                                std::to_string(tolerance));
  }
  const double digits = std::log10(1.0 / std::max(tolerance, 1e-14));
  const int order = std::max(3, static_cast<int>(std::ceil(3.03 * digits - 2.6)));
  return {order, 2 * order + 15};
}

StressletFmm::StressletFmm(const std::vector<Curve>& curves, const FmmSettings& settings)
    : StressletFmm(curves, all_nodes(curves), settings) {}

StressletFmm::StressletFmm(const std::vector<Curve>& curves, const ComplexVector& targets,
                           const FmmSettings& settings)
    : translations_(settings.order),
      sources_(all_nodes(curves), settings.leaf_size),
      targets_(targets, settings.leaf_size),
      interactions_(find_interactions(targets_, sources_, direct_pairs(settings.order))) {
  const Index n = sources_.points().size();
  ComplexVector normal(n);
  Eigen::VectorXd weight(n);
  Index first = 0;
  for (const Curve& curve : curves) {
    weight.segment(first, curve.size()) = weights(curve);
    normal.segment(first, curve.size()) = normals(curve);
    first += curve.size();
  }
  weight = in_tree_order(weight, sources_.order());
  weighted_normal_ = in_tree_order(normal, sources_.order()).cwiseProduct(weight);
  x_ = sources_.points().real();
  y_ = sources_.points().imag();
  nx_ = std::numbers::inv_pi * weighted_normal_.real();
  ny_ = std::numbers::inv_pi * weighted_normal_.imag();
  least2_ = 0.25 * weight.array().square();
}

StressletSources StressletFmm::strengths(const ComplexVector& density) const {
  constexpr double quarter = 0.25 * std::numbers::inv_pi;
  const ComplexVector eta = in_tree_order(density, sources_.order());
  const ComplexVector a = quarter * weighted_normal_.cwiseProduct(eta);
  const ComplexVector b = 2.0 * quarter * weighted_normal_.conjugate().cwiseProduct(eta);
  return {x_, y_, a.real(), a.imag(), b.real()};
}

Expansion StressletFmm::outgoing(const StressletSources& sources) const {
  const std::vector<Box>& boxes = sources_.boxes();
  const std::vector<Index>& levels = sources_.levels();
  const Index columns = translations_.order() + 1;
  Expansion all = Expansion::Zero(4, columns * static_cast<Index>(boxes.size()));
  for (std::size_t level = levels.size() - 1; level-- > 0;) {
#pragma omp parallel for schedule(dynamic, 16)
    for (Index b = levels[level]; b < levels[level + 1]; ++b) {
      const Box& box = boxes[static_cast<std::size_t>(b)];
      if (box.is_leaf()) add_outgoing(box, sources, of_box(all, b, columns));
      for (Index c = box.first_child; c < box.last_child; ++c) {
        translations_.outgoing(boxes[static_cast<std::size_t>(c)],
                               of_box(std::as_const(all), c, columns), box,
                               of_box(all, b, columns));
      }
    }
  }
  return all;
}

Expansion StressletFmm::incoming(const Expansion& outgoing) const {
  const std::vector<Box>& boxes = targets_.boxes();
  const std::vector<Index>& levels = targets_.levels();
  const Index columns = translations_.order() + 1;
  Expansion all = Expansion::Zero(4, columns * static_cast<Index>(boxes.size()));
  for (std::size_t level = 0; level + 1 < levels.size(); ++level) {
#pragma omp parallel for schedule(dynamic, 16)
    for (Index b = levels[level]; b < levels[level + 1]; ++b) {
      const Box& box = boxes[static_cast<std::size_t>(b)];
      auto sum = of_box(all, b, columns);
      translations_.convert(sources_.boxes(), outgoing, list_of(interactions_.far, b), box, sum);
      if (box.parent >= 0) {
        translations_.incoming(boxes[static_cast<std::size_t>(box.parent)],
                               of_box(std::as_const(all), box.parent, columns), box, sum);
      }
    }
  }
  return all;
}

ComplexVector StressletFmm::operator()(const ComplexVector& density) const {
  const Expansion far = incoming(outgoing(strengths(density)));
  const ComplexVector eta = in_tree_order(density, sources_.order());
  const Eigen::VectorXd ex = eta.real(), ey = eta.imag();
  const ComplexVector& points = targets_.points();
  const Index columns = translations_.order() + 1;
  const auto count = static_cast<Index>(targets_.boxes().size());
  ComplexVector sum = ComplexVector::Zero(points.size());
#pragma omp parallel for schedule(dynamic, 4)
  for (Index b = 0; b < count; ++b) {
    const Box& box = targets_.boxes()[static_cast<std::size_t>(b)];
    if (!box.is_leaf()) continue;
    add_velocity(box, of_box(far, b, columns), points, sum);
    const std::span<const Index> near = list_of(interactions_.near, b);
    for (std::size_t range = 0; range < near.size(); range += 2) {
      const Index first = near[range];
      add_velocities({&x_[first], &y_[first], &nx_[first], &ny_[first], &ex[first], &ey[first],
                      &least2_[first], near[range + 1] - first},
                     points, box.first, box.last, sum);
    }
  }
  ComplexVector velocity(points.size());
  for (std::size_t i = 0; i < targets_.order().size(); ++i) {
    velocity[targets_.order()[i]] = sum[static_cast<Index>(i)];
  }
  return velocity;
}

std::vector<FlowDerivatives> StressletFmm::derivatives(const ComplexVector& density) const {
  const Expansion far = incoming(outgoing(strengths(density)));
  const ComplexVector eta = in_tree_order(density, sources_.order());
  const Eigen::VectorXd ex = eta.real(), ey = eta.imag();
  const Index columns = translations_.order() + 1;
  const auto count = static_cast<Index>(targets_.boxes().size());
  std::vector<FlowDerivatives> flow(targets_.order().size());
#pragma omp parallel for schedule(dynamic, 4)
  for (Index b = 0; b < count; ++b) {
    const Box& box = targets_.boxes()[static_cast<std::size_t>(b)];
    if (!box.is_leaf()) continue;
    const std::span<const Index> near = list_of(interactions_.near, b);
    for (Index i = box.first; i < box.last; ++i) {
      const Complex z = targets_.points()[i];
      FlowDerivatives sum = stokesbook::derivatives(box, of_box(far, b, columns), z);
      for (std::size_t range = 0; range < near.size(); range += 2) {
        const Index first = near[range];
        add_derivatives({&x_[first], &y_[first], &nx_[first], &ny_[first], &ex[first], &ey[first],
                         &least2_[first], near[range + 1] - first},
                        z, sum);
      }
      flow[static_cast<std::size_t>(targets_.order()[static_cast<std::size_t>(i)])] = sum;
    }
  }
  return flow;
}

}  // namespace stokesbook
