#include "suspension/density_history.hpp"

#include <algorithm>

#include "trapezoid/fourier.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

// Weight of value k in the polynomial through the values at some times.
double lagrange_weight(const std::vector<double>& times, std::size_t k, double t) {
  double weight = 1.0;
  for (std::size_t m = 0; m < times.size(); ++m) {
    if (m != k) weight *= (t - times[m]) / (times[k] - times[m]);
  }
  return weight;
}

// Interpolates one component's density from some nodes to others.
ComplexVector moved(const ComplexVector& density, const Resolution& from, const Resolution& to) {
  if (from == to) return density;
  if (!from.is_graded() && !to.is_graded()) return resample(density, to.n_nodes);
  const TrigonometricPolynomial polynomial(density);
  ComplexVector result(to.n_nodes);
  Index j = 0;
  for (const GradedParameter& node : graded_parameters(to.grading, to.n_nodes)) {
    result[j++] = polynomial(graded_position(from.grading, node.t)).value;
  }
  return result;
}

}  // namespace

void DensityHistory::add(double t, const Configuration& configuration, const References& references,
                         const ComplexVector& density) {
  Entry entry{t, resolutions_of(references), density};
  Index first = 0;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const Index n = references[k]->curve.size();
    entry.density.segment(first, n) *= std::polar(1.0, -configuration[k].orientation);
    first += n;
  }
  std::erase_if(entries_, [t](const Entry& earlier) { return earlier.t == t; });
  if (entries_.size() == most_) entries_.pop_front();
  entries_.push_back(std::move(entry));
}

void DensityHistory::reverse(double t) {
  for (Entry& entry : entries_) {
    entry.t = t + (t - entry.t);
    entry.density = -entry.density;
  }
}

ComplexVector DensityHistory::guess(double t, const Configuration& configuration,
                                    const References& references) const {
  if (entries_.empty()) return {};
  std::vector<double> times;
  for (const Entry& entry : entries_) times.push_back(entry.t);
  std::vector<Complex> all;
  std::vector<Index> first(entries_.size(), 0);
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const Resolution& to = references[k]->resolution;
    ComplexVector sum = ComplexVector::Zero(to.n_nodes);
    for (std::size_t e = 0; e < entries_.size(); ++e) {
      const Resolution& from = entries_[e].resolutions[k];
      sum += lagrange_weight(times, e, t) *
             moved(entries_[e].density.segment(first[e], from.n_nodes), from, to);
      first[e] += from.n_nodes;
    }
    sum *= std::polar(1.0, configuration[k].orientation);
    all.insert(all.end(), sum.begin(), sum.end());
  }
  return Eigen::Map<const ComplexVector>(all.data(), static_cast<Index>(all.size()));
}

std::vector<VectorXd> DensityHistory::packed() const {
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
    for (const Complex value : entry.density) {
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
    entry.density.resize(nodes);
    for (Complex& value : entry.density) {
      value = {*next, *(next + 1)};
      next += 2;
    }
    entries_.push_back(std::move(entry));
  }
}

}  // namespace stokesbook
