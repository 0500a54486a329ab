// Guesses the density of an instant: extrapolates earlier densities, in the frames of their
// components, by the polynomial in time through them (09.13).
#include "suspension/solver/density_history.hpp"

#include <algorithm>
#include <cmath>

#include "trapezoid/fourier.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXd;

namespace {

// Times whose distance is below this part of the span of all times count as one time. Such times
// occur before and after a reversal, and differ by rounding: a polynomial through the densities of
// both would amplify the errors that GMRES leaves.
constexpr double same_time = 1e-6;

// Weight w_k (09.13) of the value at time k in the polynomial through the values at some times.
double lagrange_weight(const std::vector<double>& times, std::size_t k, double t) {
  double weight = 1.0;
  for (std::size_t m = 0; m < times.size(); ++m) {
    if (m != k) weight *= (t - times[m]) / (times[k] - times[m]);
  }
  return weight;
}

// Interpolates the densities of one component to other nodes of its shape.
MatrixXcd moved(const MatrixXcd& densities, const Resolution& from, const DiscretisedShape& to) {
  if (from == to.resolution) return densities;
  if (!from.is_graded() && !to.resolution.is_graded()) {
    const Index n = to.resolution.n_nodes;
    MatrixXcd result(n, densities.cols());
    for (Index m = 0; m < densities.cols(); ++m) result.col(m) = resample(densities.col(m), n);
    return result;
  }
  return interpolated(densities, graded_positions(from.grading, to.parameters));
}

}  // namespace

double DensityHistory::rounding_at(double t) const {
  double span = 0.0;
  for (const Entry& entry : entries_) span = std::max(span, std::abs(entry.t - t));
  return same_time * span;
}

void DensityHistory::add(double t, const Configuration& configuration,
                         const Discretisation& discretisation, MatrixXcd densities) {
  // The density of each component is stored in the frame of the component.
  Index first = 0;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const Index n = discretisation[k]->curve.size();
    densities.middleRows(first, n) *= std::polar(1.0, -configuration[k].orientation);
    first += n;
  }
  const double rounding = rounding_at(t);
  std::erase_if(entries_,
                [=](const Entry& earlier) { return std::abs(earlier.t - t) <= rounding; });
  if (entries_.size() == most_) entries_.pop_front();
  entries_.push_back({t, resolutions_of(discretisation), std::move(densities)});
}

void DensityHistory::reverse(double t) {
  // The density at t - s, with the other sign, becomes the density at t + s.
  for (Entry& entry : entries_) {
    entry.t = t + (t - entry.t);
    entry.densities = -entry.densities;
  }
}

MatrixXcd DensityHistory::guess(double t, const Configuration& configuration,
                                const Discretisation& discretisation) const {
  if (entries_.empty()) return {0, 1};
  std::vector<double> times;
  Index nodes = 0;
  for (const Entry& entry : entries_) times.push_back(entry.t);
  for (const auto& discretised : discretisation) nodes += discretised->resolution.n_nodes;
  MatrixXcd result = MatrixXcd::Zero(nodes, entries_.front().densities.cols());
  std::vector<Index> first(entries_.size(), 0);
  Index own = 0;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const DiscretisedShape& to = *discretisation[k];
    auto sum = result.middleRows(own, to.resolution.n_nodes);
    // The sum over e of w_e eta(t_e) (09.13), in the frame of component k.
    for (std::size_t e = 0; e < entries_.size(); ++e) {
      const Resolution& from = entries_[e].resolutions[k];
      sum += lagrange_weight(times, e, t) *
             moved(entries_[e].densities.middleRows(first[e], from.n_nodes), from, to);
      first[e] += from.n_nodes;
    }
    sum *= std::polar(1.0, configuration[k].orientation);
    own += to.resolution.n_nodes;
  }
  return result;
}

std::vector<VectorXd> DensityHistory::packed() const {
  // For each entry: t; for each component n_nodes, strength, number of clusters, and parameter and
  // width of each cluster; then all values of the densities, column by column.
  std::vector<VectorXd> packed;
  for (const Entry& entry : entries_) {
    std::vector<double> numbers{entry.t};
    for (const auto& [n_nodes, grading] : entry.resolutions) {
      numbers.insert(numbers.end(), {static_cast<double>(n_nodes), grading.strength,
                                     static_cast<double>(grading.clusters.size())});
      for (const Cluster& cluster : grading.clusters) {
        numbers.insert(numbers.end(), {cluster.parameter, cluster.width});
      }
    }
    for (const Complex value : entry.densities.reshaped()) {
      numbers.insert(numbers.end(), {value.real(), value.imag()});
    }
    packed.push_back(
        Eigen::Map<const VectorXd>(numbers.data(), static_cast<Index>(numbers.size())));
  }
  return packed;
}

void DensityHistory::unpack(const std::vector<VectorXd>& packed, std::size_t components) {
  entries_.clear();
  for (const VectorXd& numbers : packed) {
    auto next = numbers.begin();
    Entry entry{*next++, Resolutions(components), {}};
    Index nodes = 0;
    for (auto& [n_nodes, grading] : entry.resolutions) {
      n_nodes = static_cast<int>(*next++);
      grading.strength = *next++;
      grading.clusters.resize(static_cast<std::size_t>(*next++));
      for (Cluster& cluster : grading.clusters) {
        cluster.parameter = *next++;
        cluster.width = *next++;
      }
      nodes += n_nodes;
    }
    entry.densities.resize(nodes, (numbers.end() - next) / (2 * nodes));
    for (Complex& value : entry.densities.reshaped()) {
      value = {*next, *(next + 1)};
      next += 2;
    }
    entries_.push_back(std::move(entry));
  }
}

}  // namespace stokesbook
