// Generates the boxed random packings of disks with which the literature measures solvers of dense
// suspensions.
#include "support/boxed_packing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "trapezoid/require.hpp"

namespace stokesbook::test {

namespace {

// Draws uniform numbers from [0, 1) with 53 bits.
class Uniform {
 public:
  explicit Uniform(unsigned seed) : twister_(seed) {}
  double operator()() {
    const auto high = static_cast<double>(twister_() >> 5),
               low = static_cast<double>(twister_() >> 6);
    return (high * 67108864.0 + low) / 9007199254740992.0;
  }

 private:
  std::mt19937 twister_;
};

// Places in a square of the given width about the origin, and their least distance.
struct Start {
  double distance = 0.0;
  std::vector<Complex> places;
};

// Rows at equal distances; odd rows have `columns` places, even rows as many, or if they are
// staggered one less.
Start rows_of_places(int rows, int columns, double width, bool staggered) {
  const double dx = width / (columns - 1), dy = width / (rows - 1);
  Start start{std::min(dx, staggered ? std::min(std::hypot(0.5 * dx, dy), 2.0 * dy) : dy), {}};
  for (int row = 0; row < rows; ++row) {
    const bool is_short = staggered && row % 2 == 1;
    for (int column = 0; column < columns - (is_short ? 1 : 0); ++column) {
      start.places.emplace_back(-0.5 * width + (column + (is_short ? 0.5 : 0.0)) * dx,
                                -0.5 * width + row * dy);
    }
  }
  return start;
}

Start best_start(int count, double width) {
  const int side = std::max(2, static_cast<int>(std::ceil(std::sqrt(count))));
  Start best = rows_of_places(side, side, width, false);
  for (int rows = 2; rows <= 3 * side; ++rows) {
    const int longer = (rows + 1) / 2, shorter = rows / 2;
    const int columns = std::max(2, (count + shorter + rows - 1) / (longer + shorter));
    Start staggered = rows_of_places(rows, columns, width, true);
    if (staggered.distance > best.distance) best = std::move(staggered);
  }
  best.places.resize(static_cast<std::size_t>(count));
  return best;
}

// Finds the disks near a place by the cells of a square grid, which are wider than a distance.
class Grid {
 public:
  Grid(double width, double distance, const std::vector<Complex>& places)
      : count_(std::max(1, static_cast<int>(width / distance))),
        width_(width),
        cells_(static_cast<std::size_t>(count_ * count_)) {
    for (std::size_t k = 0; k < places.size(); ++k) cell(places[k]).push_back(k);
  }

  bool any_within(double distance, Complex place, std::size_t own,
                  const std::vector<Complex>& places) const {
    const int i = index(place.real()), j = index(place.imag());
    for (int y = std::max(0, j - 1); y <= std::min(count_ - 1, j + 1); ++y) {
      for (int x = std::max(0, i - 1); x <= std::min(count_ - 1, i + 1); ++x) {
        for (const std::size_t k : cells_[static_cast<std::size_t>(y * count_ + x)]) {
          if (k != own && std::norm(places[k] - place) < distance * distance) return true;
        }
      }
    }
    return false;
  }

  void move(std::size_t own, Complex from, Complex to) {
    std::erase(cell(from), own);
    cell(to).push_back(own);
  }

 private:
  int index(double x) const {
    return std::clamp(static_cast<int>((x / width_ + 0.5) * count_), 0, count_ - 1);
  }
  std::vector<std::size_t>& cell(Complex place) {
    return cells_[static_cast<std::size_t>(index(place.imag()) * count_ + index(place.real()))];
  }

  int count_;
  double width_;
  std::vector<std::vector<std::size_t>> cells_;
};

}  // namespace

std::vector<Complex> boxed_packing(int count, double fraction, double gap, unsigned seed,
                                   int sweeps) {
  const double width = std::sqrt(count * std::numbers::pi / fraction) - 2.0, least = 2.0 + gap;
  auto [distance, places] = best_start(count, width);
  require(distance >= least, "a box for ", count, " disks at the area fraction ", fraction,
          " starts with the distance ", distance, ", less than ", least);
  Grid grid(width, least, places);
  Uniform uniform(seed);
  double step = std::max(0.05, 0.5 * (distance - least));
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    int accepted = 0;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const double radius = step * std::sqrt(uniform());
      const Complex moved = places[k] + std::polar(radius, 2.0 * std::numbers::pi * uniform());
      if (std::abs(moved.real()) > 0.5 * width || std::abs(moved.imag()) > 0.5 * width ||
          grid.any_within(least, moved, k, places)) {
        continue;
      }
      grid.move(k, places[k], moved);
      places[k] = moved;
      ++accepted;
    }
    const double rate = static_cast<double>(accepted) / count;
    step *= rate > 0.55 ? 1.1 : rate < 0.45 ? 0.9 : 1.0;
  }
  return places;
}

}  // namespace stokesbook::test
