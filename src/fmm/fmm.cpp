// Sums double-layer nodes and point forces by the fast multipole method (chapter 08): upward pass
// (P2M, M2M), conversion of multipole to local expansions (M2L), downward pass (L2L), and
// evaluation at the targets of the leaves (L2P and direct sums). Chooses the order of expansions
// and the size of leaves for a tolerance.
#include "fmm/fmm.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "double_layer/kernels.hpp"
#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// A level with at most this many boxes is done by one thread: others would start too late to help.
constexpr Index few_boxes = 64;

// Makes the tree of the nodes, each with half of its weight as margin, followed by the points.
Quadtree tree_of(const StressletNodes& nodes, const ComplexVector& points, Index leaf_size) {
  ComplexVector all(nodes.size() + points.size());
  all.head(nodes.size()).real() = nodes.x;
  all.head(nodes.size()).imag() = nodes.y;
  all.tail(points.size()) = points;
  Eigen::VectorXd margins = Eigen::VectorXd::Zero(all.size());
  margins.head(nodes.size()) = nodes.least2.cwiseSqrt();
  return {all, margins, leaf_size};
}

// Adds the velocities that a point force causes at the first `count` targets of a group.
void add_velocities(const PointForce& point, Index count, const VectorGroup& targets,
                    VectorGroup& sum) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const Complex r = Complex{targets.x[i], targets.y[i]} - point.position;
    const Complex velocity = stokeslet(r, point.force, 1.0, 1.0) + rotlet(r, point.torque, 1.0);
    sum.x[i] += velocity.real();
    sum.y[i] += velocity.imag();
  }
}

// Throws if a target coincides with a point force, where the velocity is not finite.
void require_apart(const Quadtree& targets, Index target_count, const ComplexVector& points) {
  std::map<std::pair<double, double>, Index> point_at;
  for (Index j = 0; j < points.size(); ++j) point_at[{points[j].real(), points[j].imag()}] = j;
  if (point_at.empty()) return;
  for (Index i = 0; i < targets.size(); ++i) {
    const Index target = targets.order[static_cast<std::size_t>(i)];
    if (target >= target_count) continue;  // a point force is no target
    const auto found = point_at.find({targets.x[i], targets.y[i]});
    const Index point = found == point_at.end() ? -1 : found->second;
    require(point < 0, "target ", target, " of an FMM coincides with point force ", point, " at (",
            targets.x[i], ", ", targets.y[i], "): move one of them");
  }
}

// Returns the smallest disk that contains the disks of two boxes.
Box enclose(const Box& a, const Box& b) {
  const double distance = std::abs(b.centre - a.centre);
  if (distance + b.radius <= a.radius) return a;
  if (distance + a.radius <= b.radius) return b;
  Box disk;
  disk.radius = 0.5 * (distance + a.radius + b.radius);
  disk.centre = a.centre + (disk.radius - a.radius) / distance * (b.centre - a.centre);
  return disk;
}

// Returns a box that is moved by a vector.
Box moved(Box box, Complex vector) {
  box.centre += vector;
  return box;
}

// Returns points that are moved by a vector.
VectorGroup moved(const VectorGroup& points, Complex vector) {
  VectorGroup result = points;
  for (double& x : result.x) x += vector.real();
  for (double& y : result.y) y += vector.imag();
  return result;
}

// Calls work(first field, number of fields) for blocks of four, two or one fields. The number is a
// constant of the compiler.
template <class Work>
void in_blocks(Index fields, const Work& work) {
  Index field = 0;
  for (; field + 4 <= fields; field += 4) work(field, std::integral_constant<int, 4>{});
  for (; field + 2 <= fields; field += 2) work(field, std::integral_constant<int, 2>{});
  if (field < fields) work(field, std::integral_constant<int, 1>{});
}

}  // namespace

FmmSettings FmmSettings::for_tolerance(double tolerance) {
  require(tolerance > 0.0, "the tolerance of an FMM must be > 0, got ", tolerance);
  constexpr double rounding = 1e-14;
  const double digits = -std::log10(std::clamp(tolerance, rounding, 1.0));
  const int order = std::max(3, static_cast<int>(std::ceil(3.03 * digits - 0.6)));
  return {order, 2 * order + 32};
}

Index break_even(const FmmSettings& settings) {
  return 300 + 18 * settings.order;
}

FmmWorkspace::FmmWorkspace(const Fmm& plan, Index fields)
    : ex_(plan.sources().size(), fields),
      ey_(plan.sources().size(), fields),
      points_(static_cast<std::size_t>(plan.point_count_ * fields)),
      multipole_(plan.sources().box_count(), fields, plan.translations_.order()),
      local_(plan.targets().box_count(), fields, plan.translations_.order()),
      cell_(plan.images_.far ? 2 : 0, 1, plan.translations_.order()),
      velocity_(plan.target_count_, fields) {}

Fmm::Fmm(const std::vector<Curve>& curves, const ComplexVector& points, const FmmSettings& settings,
         const FmmImagePlan& images)
    : Fmm(settings, StressletNodes(curves), points, nullptr, images) {}

Fmm::Fmm(const std::vector<Curve>& curves, const ComplexVector& points,
         const ComplexVector& targets, const FmmSettings& settings, const FmmImagePlan& images)
    : Fmm(settings, StressletNodes(curves), points, &targets, images) {}

Fmm::Fmm(const FmmSettings& settings, const StressletNodes& nodes, const ComplexVector& points,
         const ComplexVector* targets, const FmmImagePlan& images)
    : translations_(settings.order),
      node_count_(nodes.size()),
      point_count_(points.size()),
      target_count_(targets != nullptr ? targets->size() : node_count_),
      sources_(tree_of(nodes, points, settings.leaf_size)),
      nx_(sources_.size()),
      ny_(sources_.size()),
      least2_(sources_.size()),
      points_before_{0} {
  if (targets != nullptr) targets_.emplace(*targets, Eigen::VectorXd{}, settings.leaf_size);
  // p^2 / 2 pairs of points cost as much as one M2L translation (08.14).
  const Index direct_pairs = settings.order * settings.order / 2;
  interactions_.push_back(find_interactions(this->targets(), sources_, direct_pairs));
  if (images && sources_.size() > 0 && this->targets().size() > 0) {
    cell_ = enclose(sources_.boxes.front(), this->targets().boxes.front());
    images_ = images(cell_.radius, settings.order);
    for (const Complex w : images_.near) {
      interactions_.push_back(find_interactions(this->targets(), sources_, direct_pairs, w));
    }
  }
  for (Index i = 0; i < sources_.size(); ++i) {
    const Index source = sources_.order[static_cast<std::size_t>(i)];
    const bool is_node = source < node_count_;
    nx_[i] = is_node ? nodes.nx[source] : 0.0;
    ny_[i] = is_node ? nodes.ny[source] : 0.0;
    least2_[i] = is_node ? nodes.least2[source] : 1.0;  // not 0: the kernel divides by it
    points_before_.push_back(points_before_.back() + (is_node ? 0 : 1));
  }
  require_apart(this->targets(), target_count_, points);
}

FmmWorkspace Fmm::workspace(Index fields) const {
  require(fields >= 1, "an FMM workspace requires at least one field, got ", fields);
  return {*this, fields};
}

void Fmm::check(const FmmStrengths& strengths, const FmmWorkspace& work) const {
  const Index fields = work.velocity_.cols();
  const auto& [density, force, torque] = strengths;
  const auto fits = [&](const auto& columns, Index rows) {
    return columns.rows() == rows && columns.cols() == fields;
  };
  const bool without_points = force.rows() == 0 && torque.rows() == 0;
  require(
      work.ex_.rows() == sources_.size() && work.velocity_.rows() == target_count_ &&
          std::ssize(work.points_) == point_count_ * fields &&
          work.multipole_.columns() ==
              sources_.box_count() * fields * (translations_.order() + 1) &&
          work.local_.columns() == targets().box_count() * fields * (translations_.order() + 1) &&
          work.cell_.columns() == (images_.far ? 2 : 0) * (translations_.order() + 1) &&
          fits(density, node_count_) &&
          (without_points || (fits(force, point_count_) && fits(torque, point_count_))),
      "sizes do not agree: the plan has ", node_count_, " nodes, ", point_count_, " points and ",
      target_count_, " targets; the workspace has ", fields, " fields and ", work.velocity_.rows(),
      " targets; the densities are ", density.rows(), " x ", density.cols(), ", the forces ",
      force.rows(), " x ", force.cols(), ", the torques ", torque.rows(), " x ", torque.cols());
}

StressletBlock Fmm::nodes(Range sources, Index field, const FmmWorkspace& work) const {
  const Index first = sources.first;
  return {sources_.x.data() + first,
          sources_.y.data() + first,
          nx_.data() + first,
          ny_.data() + first,
          least2_.data() + first,
          sources.last - first,
          work.ex_.col(field).data() + first,
          work.ey_.col(field).data() + first,
          work.ex_.rows()};
}

std::span<const PointForce> Fmm::points(Range sources, Index field,
                                        const FmmWorkspace& work) const {
  if (work.without_points_) return {};
  const PointForce* const all = work.points_.data() + field * point_count_;
  return {all + points_before_[static_cast<std::size_t>(sources.first)],
          all + points_before_[static_cast<std::size_t>(sources.last)]};
}

void Fmm::sort_strengths(const FmmStrengths& strengths, FmmWorkspace& work) const {
  check(strengths, work);
  work.without_points_ = strengths.force.rows() == 0;
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < sources_.size(); ++i) {
    const Index source = sources_.order[static_cast<std::size_t>(i)];
    const Index point = source - node_count_;
    for (Index field = 0; field < work.velocity_.cols(); ++field) {
      const Complex density = point < 0 ? strengths.density(source, field) : 0.0;
      work.ex_(i, field) = density.real();
      work.ey_(i, field) = density.imag();
      if (point < 0 || work.without_points_) continue;
      const Index place = points_before_[static_cast<std::size_t>(i)] + field * point_count_;
      work.points_[static_cast<std::size_t>(place)] = {{sources_.x[i], sources_.y[i]},
                                                       strengths.force(point, field),
                                                       strengths.torque(point, field)};
    }
  }
}

// Upward pass: leaves form multipole expansions (P2M), parents collect those of their children
// (M2M).
void Fmm::sum_multipoles(FmmWorkspace& work) const {
  const std::vector<Box>& boxes = sources_.boxes;
  const std::vector<Index>& levels = sources_.levels;
  for (std::size_t level = levels.size() - 1; level-- > 0;) {
#pragma omp parallel for schedule(dynamic, 8) if (levels[level + 1] - levels[level] > few_boxes)
    for (Index b = levels[level]; b < levels[level + 1]; ++b) {
      const Box& box = boxes[static_cast<std::size_t>(b)];
      const Range sources{box.first, box.last};
      work.multipole_.clear(b);
      for (Index field = 0; field < work.velocity_.cols(); ++field) {
        auto sum = work.multipole_(b, field);
        if (box.is_leaf()) {
          p2m(box, nodes(sources, field, work), sum);
          for (const PointForce& point : points(sources, field, work)) p2m(box, point, sum);
        }
        for (Index c = box.first_child; c < box.last_child; ++c) {
          translations_.m2m(boxes[static_cast<std::size_t>(c)], work.multipole_(c, field), box,
                            sum);
        }
      }
    }
  }
}

// Converts multipole expansions to local expansions (M2L) for all boxes. Downward pass: children
// add the local expansions of their parents (L2L).
void Fmm::sum_locals(FmmWorkspace& work) const {
  const std::vector<Box>& boxes = targets().boxes;
  const std::vector<Index>& levels = targets().levels;
  const Index fields = work.velocity_.cols();
#pragma omp parallel for schedule(dynamic, 8)
  for (Index b = 0; b < targets().box_count(); ++b) {
    work.local_.clear(b);
    for (Index field = 0; field < fields; ++field) {
      for (const Interactions& image : interactions_) {
        translations_.m2l(sources_.boxes, work.multipole_, image.far[static_cast<std::size_t>(b)],
                          field, moved(boxes[static_cast<std::size_t>(b)], -image.shift),
                          work.local_(b, field));
      }
    }
  }
  if (images_.far) add_far_images(work);
  for (std::size_t level = 1; level + 1 < levels.size(); ++level) {
#pragma omp parallel for schedule(dynamic, 8) if (levels[level + 1] - levels[level] > few_boxes)
    for (Index b = levels[level]; b < levels[level + 1]; ++b) {
      const Box& box = boxes[static_cast<std::size_t>(b)];
      for (Index field = 0; field < fields; ++field) {
        translations_.l2l(boxes[static_cast<std::size_t>(box.parent)],
                          work.local_(box.parent, field), box, work.local_(b, field));
      }
    }
  }
}

// Adds the far images of all sources to the local expansions of the targets' root: M2M to the cell,
// the map of the images, and L2L.
void Fmm::add_far_images(FmmWorkspace& work) const {
  for (Index field = 0; field < work.velocity_.cols(); ++field) {
    for (Index b = 0; b < 2; ++b) work.cell_.clear(b);
    translations_.m2m(sources_.boxes.front(), work.multipole_(0, field), cell_, work.cell_(0, 0));
    images_.far(work.cell_(0, 0), work.cell_(1, 0));
    translations_.l2l(cell_, work.cell_(1, 0), targets().boxes.front(), work.local_(0, field));
  }
}

// Computes all expansions, which velocities and derivatives have in common.
void Fmm::expand(const FmmStrengths& strengths, FmmWorkspace& work) const {
  sort_strengths(strengths, work);
  sum_multipoles(work);
  sum_locals(work);
}

// Evaluates the velocities of some fields at a group of targets of a leaf: direct sums over the
// near sources, and the local expansion (L2P).
template <int fields>
void Fmm::sum_group(Index b, Index first, Index field, FmmWorkspace& work) const {
  const Box& box = targets().boxes[static_cast<std::size_t>(b)];
  const VectorGroup group = group_of(targets().x, targets().y, first, box.last);
  const Index count = std::min<Index>(VectorGroup::size, box.last - first);
  std::array<VectorGroup, fields> sum{};
  for (const Interactions& image : interactions_) {
    const VectorGroup from_image = moved(group, -image.shift);
    for (const Range range : image.near[static_cast<std::size_t>(b)]) {
      add_velocities<fields>(nodes(range, field, work), from_image, sum);
      for (Index f = 0; f < fields; ++f) {
        for (const PointForce& point : points(range, field + f, work)) {
          add_velocities(point, count, from_image, sum[static_cast<std::size_t>(f)]);
        }
      }
    }
  }
  for (Index f = 0; f < fields; ++f) {
    VectorGroup& velocity = sum[static_cast<std::size_t>(f)];
    l2p(box, work.local_(b, field + f), group, velocity);
    for (Index i = 0; i < count; ++i) {
      const Index target = targets().order[static_cast<std::size_t>(first + i)];
      if (target >= target_count_) continue;  // a point force is no target
      const auto lane = static_cast<std::size_t>(i);
      work.velocity_(target, field + f) = {velocity.x[lane], velocity.y[lane]};
    }
  }
}

const Eigen::MatrixXcd& Fmm::velocity(const FmmStrengths& strengths, FmmWorkspace& work) const {
  expand(strengths, work);
#pragma omp parallel for schedule(dynamic, 4)
  for (Index b = 0; b < targets().box_count(); ++b) {
    const Box& box = targets().boxes[static_cast<std::size_t>(b)];
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
  const Box& box = targets().boxes[static_cast<std::size_t>(b)];
  const Complex z{targets().x[target], targets().y[target]};
  FlowDerivatives sum = l2p_derivatives(box, work.local_(b, field), z);
  for (const Interactions& image : interactions_) {
    const Complex from_image = z - image.shift;
    for (const Range range : image.near[static_cast<std::size_t>(b)]) {
      add_derivatives(nodes(range, field, work), from_image, sum);
      for (const PointForce& point : points(range, field, work)) {
        const Complex r = from_image - point.position;
        sum += stokeslet_derivatives(r, point.force, 1.0);
        sum += rotlet_derivatives(r, point.torque, 1.0);
      }
    }
  }
  return sum;
}

const std::vector<FlowDerivatives>& Fmm::derivatives(const FmmStrengths& strengths,
                                                     FmmWorkspace& work) const {
  expand(strengths, work);
  const Index fields = work.velocity_.cols();
  work.derivatives_.resize(static_cast<std::size_t>(target_count_ * fields));
#pragma omp parallel for schedule(dynamic, 4)
  for (Index b = 0; b < targets().box_count(); ++b) {
    const Box& box = targets().boxes[static_cast<std::size_t>(b)];
    if (!box.is_leaf()) continue;
    for (Index field = 0; field < fields; ++field) {
      for (Index i = box.first; i < box.last; ++i) {
        const Index target = targets().order[static_cast<std::size_t>(i)];
        if (target >= target_count_) continue;  // a point force is no target
        work.derivatives_[static_cast<std::size_t>(target + field * target_count_)] =
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
