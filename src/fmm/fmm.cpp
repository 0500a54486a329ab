#include "fmm/fmm.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "double_layer/kernels.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// Pairs of points that cost as much as a translation of an order.
Index direct_pairs(int order) {
  return order * order / 2;
}

// Boxes of points as large as those of the targets, among which they are spread.
Index point_leaf_size(Index leaf_size, Index points, Index targets) {
  return std::clamp<Index>(leaf_size * points / std::max<Index>(targets, 1), 1, leaf_size);
}

Index box_count(const Quadtree& tree) {
  return static_cast<Index>(tree.boxes().size());
}

// A target at a point force has no velocity.
void check_distances(const Quadtree& targets, const Quadtree& points, const Lists<Range>& near) {
  for (Index b = 0; b < box_count(targets); ++b) {
    const Box& box = targets.boxes()[static_cast<std::size_t>(b)];
    for (const Range range : near.of(b)) {
      for (Index j = range.first; j < range.last; ++j) {
        for (Index i = box.first; i < box.last; ++i) {
          if (targets.x()[i] != points.x()[j] || targets.y()[i] != points.y()[j]) continue;
          std::ostringstream message;
          message << "target " << targets.order()[static_cast<std::size_t>(i)]
                  << " of an FMM is at point " << points.order()[static_cast<std::size_t>(j)]
                  << ", (" << points.x()[j] << ", " << points.y()[j] << ")";
          throw std::invalid_argument(message.str());
        }
      }
    }
  }
}

// Points of a tree from the first on, and the last one again where they do not fill the group.
VectorGroup group_of(const Quadtree& tree, Index first, Index last) {
  VectorGroup group;
  for (Index i = 0; i < VectorGroup::size; ++i) {
    const Index point = std::min(first + i, last - 1);
    group.x[static_cast<std::size_t>(i)] = tree.x()[point];
    group.y[static_cast<std::size_t>(i)] = tree.y()[point];
  }
  return group;
}

// Adds the velocities of a point at the first targets of a group.
void add_velocities(const PointForce& point, Index count, const VectorGroup& targets,
                    VectorGroup& sum) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const Complex r = Complex{targets.x[i], targets.y[i]} - point.position;
    const Complex velocity = stokeslet(r, point.force, 1.0, 1.0) + rotlet(r, point.torque, 1.0);
    sum.x[i] += velocity.real();
    sum.y[i] += velocity.imag();
  }
}

// Adds the outgoing expansions of a tree's boxes, from the leaves up.
template <class AddLeaf>
void sum_outgoing(const Quadtree& tree, const Translations& translations, Index fields,
                  const AddLeaf& add_leaf, Expansions& outgoing) {
  const std::vector<Box>& boxes = tree.boxes();
  const std::vector<Index>& levels = tree.levels();
  for (std::size_t level = levels.size() - 1; level-- > 0;) {
#pragma omp parallel for schedule(dynamic, 8)
    for (Index b = levels[level]; b < levels[level + 1]; ++b) {
      const Box& box = boxes[static_cast<std::size_t>(b)];
      outgoing.clear(b);
      for (Index field = 0; field < fields; ++field) {
        auto sum = outgoing(b, field);
        if (box.is_leaf()) add_leaf(box, field, sum);
        for (Index c = box.first_child; c < box.last_child; ++c) {
          translations.outgoing(boxes[static_cast<std::size_t>(c)],
                                std::as_const(outgoing)(c, field), box, sum);
        }
      }
    }
  }
}

// Adds the incoming expansions of the parents, from the root down.
void pass_incoming(const Quadtree& tree, const Translations& translations, Index fields,
                   Expansions& incoming) {
  const std::vector<Box>& boxes = tree.boxes();
  const std::vector<Index>& levels = tree.levels();
  for (std::size_t level = 1; level + 1 < levels.size(); ++level) {
#pragma omp parallel for schedule(dynamic, 8)
    for (Index b = levels[level]; b < levels[level + 1]; ++b) {
      const Box& box = boxes[static_cast<std::size_t>(b)];
      for (Index field = 0; field < fields; ++field) {
        translations.incoming(boxes[static_cast<std::size_t>(box.parent)],
                              std::as_const(incoming)(box.parent, field), box, incoming(b, field));
      }
    }
  }
}

// Calls work(first field, how many as a constant) for four, two or one of them at a time.
template <class Work>
void in_blocks(Index fields, const Work& work) {
  Index field = 0;
  for (; field + 4 <= fields; field += 4) work(field, std::integral_constant<int, 4>{});
  for (; field + 2 <= fields; field += 2) work(field, std::integral_constant<int, 2>{});
  if (field < fields) work(field, std::integral_constant<int, 1>{});
}

}  // namespace

FmmWorkspace::FmmWorkspace(const Fmm& plan, Index fields)
    : ex_(plan.nodes().size(), fields),
      ey_(plan.nodes().size(), fields),
      points_(static_cast<std::size_t>(plan.points().size() * fields)),
      from_nodes_(box_count(plan.nodes()), fields, plan.order()),
      from_points_(box_count(plan.points()), fields, plan.order()),
      incoming_(box_count(plan.targets()), fields, plan.order()),
      velocity_(plan.targets().size(), fields) {}

// The curves' nodes after each other.
struct Fmm::Nodes {
  explicit Nodes(const std::vector<Curve>& curves) {
    Index n = 0;
    for (const Curve& curve : curves) n += curve.size();
    x.resize(n);
    normal.resize(n);
    half_weight.resize(n);
    Index first = 0;
    for (const Curve& curve : curves) {
      x.segment(first, curve.size()) = curve.x;
      normal.segment(first, curve.size()) = normals(curve);
      half_weight.segment(first, curve.size()) = 0.5 * weights(curve);
      first += curve.size();
    }
  }

  ComplexVector x, normal;
  Eigen::VectorXd half_weight;
};

Fmm::Fmm(const std::vector<Curve>& curves, const ComplexVector& points, const FmmSettings& settings)
    : Fmm(Nodes(curves), points, nullptr, settings) {}

Fmm::Fmm(const std::vector<Curve>& curves, const ComplexVector& points,
         const ComplexVector& targets, const FmmSettings& settings)
    : Fmm(Nodes(curves), points, &targets, settings) {}

Fmm::Fmm(const Nodes& nodes, const ComplexVector& points, const ComplexVector* targets,
         const FmmSettings& settings)
    : translations_(settings.order),
      nodes_(nodes.x, nodes.half_weight, settings.leaf_size),
      points_(points, {},
              point_leaf_size(settings.leaf_size, points.size(),
                              targets != nullptr ? targets->size() : nodes.x.size())),
      nx_(nodes.x.size()),
      ny_(nodes.x.size()),
      least2_(nodes.x.size()) {
  if (targets != nullptr) targets_.emplace(*targets, Eigen::VectorXd{}, settings.leaf_size);
  node_interactions_ = find_interactions(this->targets(), nodes_, direct_pairs(settings.order));
  point_interactions_ = find_interactions(this->targets(), points_, direct_pairs(settings.order));
  check_distances(this->targets(), points_, point_interactions_.near);
  for (Index i = 0; i < nodes_.size(); ++i) {
    const Index node = nodes_.order()[static_cast<std::size_t>(i)];
    const double half_weight = nodes.half_weight[node];
    const Complex normal = 2.0 * half_weight * std::numbers::inv_pi * nodes.normal[node];
    nx_[i] = normal.real();
    ny_[i] = normal.imag();
    least2_[i] = half_weight * half_weight;
  }
}

FmmWorkspace Fmm::workspace(Index fields) const {
  if (fields < 1) {
    throw std::invalid_argument("an FMM sums at least one field, got " + std::to_string(fields));
  }
  return {*this, fields};
}

void Fmm::check(const FmmStrengths& strengths, const FmmWorkspace& work) const {
  const Index fields = work.velocity_.cols();
  const auto fits = [&](Index rows, Index columns, Index count) {
    return rows == count && columns == fields;
  };
  const bool without_points = strengths.force.rows() == 0 && strengths.torque.rows() == 0;
  if (work.ex_.rows() == nodes_.size() && work.velocity_.rows() == targets().size() &&
      fits(strengths.density.rows(), strengths.density.cols(), nodes_.size()) &&
      (without_points ||
       (fits(strengths.force.rows(), strengths.force.cols(), points_.size()) &&
        fits(strengths.torque.rows(), strengths.torque.cols(), points_.size())))) {
    return;
  }
  std::ostringstream message;
  message << "an FMM of " << nodes_.size() << " nodes and " << points_.size()
          << " points, with a workspace for " << fields << " fields, got densities of size "
          << strengths.density.rows() << " x " << strengths.density.cols() << ", forces "
          << strengths.force.rows() << " x " << strengths.force.cols() << ", torques "
          << strengths.torque.rows() << " x " << strengths.torque.cols();
  throw std::invalid_argument(message.str());
}

StressletBlock Fmm::block(Range nodes, Index field, const FmmWorkspace& work) const {
  const Index first = nodes.first;
  return {nodes_.x().data() + first,
          nodes_.y().data() + first,
          nx_.data() + first,
          ny_.data() + first,
          least2_.data() + first,
          nodes.last - first,
          work.ex_.col(field).data() + first,
          work.ey_.col(field).data() + first,
          work.ex_.rows()};
}

std::span<const PointForce> FmmWorkspace::points(Range range, Index field) const {
  const auto count = static_cast<Index>(points_.size()) / velocity_.cols();
  const PointForce* const first = points_.data() + field * count;
  return {first + range.first, first + range.last};
}

void Fmm::sum_far(const FmmStrengths& strengths, FmmWorkspace& work) const {
  check(strengths, work);
  const Index fields = work.velocity_.cols(), n = nodes_.size(), m = points_.size();
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < n; ++i) {
    const Index node = nodes_.order()[static_cast<std::size_t>(i)];
    for (Index field = 0; field < fields; ++field) {
      work.ex_(i, field) = strengths.density(node, field).real();
      work.ey_(i, field) = strengths.density(node, field).imag();
    }
  }
  const bool without_points = strengths.force.rows() == 0;
  for (Index i = 0; i < m; ++i) {
    const Index point = points_.order()[static_cast<std::size_t>(i)];
    for (Index field = 0; field < fields; ++field) {
      work.points_[static_cast<std::size_t>(i + field * m)] = {
          {points_.x()[i], points_.y()[i]},
          without_points ? Complex{} : strengths.force(point, field),
          without_points ? 0.0 : strengths.torque(point, field)};
    }
  }
  sum_outgoing(
      nodes_, translations_, fields,
      [&](const Box& box, Index field, Eigen::Ref<Expansion> sum) {
        add_outgoing(box, block({box.first, box.last}, field, work), sum);
      },
      work.from_nodes_);
  sum_outgoing(
      points_, translations_, fields,
      [&](const Box& box, Index field, Eigen::Ref<Expansion> sum) {
        for (const PointForce& point : work.points({box.first, box.last}, field)) {
          add_outgoing(box, point, sum);
        }
      },
      work.from_points_);
  const Index boxes = box_count(targets());
#pragma omp parallel for schedule(dynamic, 8)
  for (Index b = 0; b < boxes; ++b) {
    const Box& box = targets().boxes()[static_cast<std::size_t>(b)];
    work.incoming_.clear(b);
    for (Index field = 0; field < fields; ++field) {
      translations_.convert(nodes_.boxes(), work.from_nodes_, node_interactions_.far.of(b), field,
                            box, work.incoming_(b, field));
      translations_.convert(points_.boxes(), work.from_points_, point_interactions_.far.of(b),
                            field, box, work.incoming_(b, field));
    }
  }
  pass_incoming(targets(), translations_, fields, work.incoming_);
}

// Velocities of some fields at sixteen targets of a leaf.
template <int fields>
void Fmm::sum_group(Index b, Index first, Index field, FmmWorkspace& work) const {
  const Box& box = targets().boxes()[static_cast<std::size_t>(b)];
  const VectorGroup group = group_of(targets(), first, box.last);
  std::array<VectorGroup, fields> sum{};
  for (const Range range : node_interactions_.near.of(b)) {
    add_velocities<fields>(block(range, field, work), group, sum);
  }
  const Index count = std::min<Index>(VectorGroup::size, box.last - first);
  for (Index f = 0; f < fields; ++f) {
    VectorGroup& velocity = sum[static_cast<std::size_t>(f)];
    add_velocities(box, std::as_const(work.incoming_)(b, field + f), group, velocity);
    for (const Range range : point_interactions_.near.of(b)) {
      for (const PointForce& point : work.points(range, field + f)) {
        add_velocities(point, count, group, velocity);
      }
    }
    for (Index i = 0; i < count; ++i) {
      const auto lane = static_cast<std::size_t>(i);
      work.velocity_(targets().order()[static_cast<std::size_t>(first + i)], field + f) = {
          velocity.x[lane], velocity.y[lane]};
    }
  }
}

const Eigen::MatrixXcd& Fmm::velocity(const FmmStrengths& strengths, FmmWorkspace& work) const {
  sum_far(strengths, work);
  const Index boxes = box_count(targets());
#pragma omp parallel for schedule(dynamic, 4)
  for (Index b = 0; b < boxes; ++b) {
    const Box& box = targets().boxes()[static_cast<std::size_t>(b)];
    if (!box.is_leaf()) continue;
    in_blocks(work.velocity_.cols(), [&](Index field, auto fields) {
      for (Index first = box.first; first < box.last; first += VectorGroup::size) {
        sum_group<fields>(b, first, field, work);
      }
    });
  }
  return work.velocity_;
}

Eigen::MatrixXcd Fmm::velocity(const FmmStrengths& strengths) const {
  FmmWorkspace work = workspace(strengths.density.cols());
  return velocity(strengths, work);
}

FlowDerivatives Fmm::derivatives_at(Index b, Index target, Index field,
                                    const FmmWorkspace& work) const {
  const Box& box = targets().boxes()[static_cast<std::size_t>(b)];
  const Complex z{targets().x()[target], targets().y()[target]};
  FlowDerivatives sum = stokesbook::derivatives(box, work.incoming_(b, field), z);
  for (const Range range : node_interactions_.near.of(b)) {
    add_derivatives(block(range, field, work), z, sum);
  }
  for (const Range range : point_interactions_.near.of(b)) {
    for (const PointForce& point : work.points(range, field)) {
      sum += stokeslet_derivatives(z - point.position, point.force, 1.0);
      sum += rotlet_derivatives(z - point.position, point.torque, 1.0);
    }
  }
  return sum;
}

const std::vector<FlowDerivatives>& Fmm::derivatives(const FmmStrengths& strengths,
                                                     FmmWorkspace& work) const {
  sum_far(strengths, work);
  const Index boxes = box_count(targets()), m = targets().size(), fields = work.velocity_.cols();
  work.derivatives_.resize(static_cast<std::size_t>(m * fields));
#pragma omp parallel for schedule(dynamic, 4)
  for (Index b = 0; b < boxes; ++b) {
    const Box& box = targets().boxes()[static_cast<std::size_t>(b)];
    if (!box.is_leaf()) continue;
    for (Index field = 0; field < fields; ++field) {
      for (Index i = box.first; i < box.last; ++i) {
        const Index target = targets().order()[static_cast<std::size_t>(i)];
        work.derivatives_[static_cast<std::size_t>(target + field * m)] =
            derivatives_at(b, i, field, work);
      }
    }
  }
  return work.derivatives_;
}

std::vector<FlowDerivatives> Fmm::derivatives(const FmmStrengths& strengths) const {
  FmmWorkspace work = workspace(strengths.density.cols());
  return derivatives(strengths, work);
}

}  // namespace stokesbook
