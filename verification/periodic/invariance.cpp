// Describes one problem in several ways, which must not change the motions.
#include <algorithm>
#include <cmath>
#include <functional>

#include "defects.hpp"
#include "experiments.hpp"
#include "support/cells.hpp"

namespace stokesbook::verification::periodic {

using namespace study;
using test::Cell;
using test::CellBody;
using test::CellMotion;

namespace {

const Complex first_vector{2.2, 0.1}, second_vector{0.5, 1.9};

// A description, the factor by which it turns all vectors, and the velocity of body 1 that it adds.
struct Description {
  Cell cell;
  Complex turn = 1.0;
  Complex more = 0.0;
};

void move(CellBody& body, Complex shift) {
  body.curve = place(body.curve, shift, 0.0);
  body.centre += shift;
}

std::vector<Description> descriptions(const Cell& given) {
  std::vector<Description> all;
  for (const Complex w :
       {first_vector - 2.0 * second_vector,
        3.0 * first_vector + second_vector}) {  // body 1 moved by a lattice vector
    Description& moved = all.emplace_back(
        Description{given, 1.0, given.linear_velocity(w) - given.linear_velocity(0.0)});
    move(moved.cell.bodies[1], w);
  }
  Description& shifted = all.emplace_back(Description{given});  // everything moved
  shifted.cell.origin += Complex{0.7, -0.4};
  for (CellBody& body : shifted.cell.bodies) move(body, {0.7, -0.4});
  for (const Lattice& other :
       {Lattice(first_vector, second_vector + first_vector),
        Lattice(first_vector + 3.0 * second_vector, 2.0 * first_vector + 7.0 * second_vector)}) {
    all.emplace_back(Description{given}).cell.lattice = other;
  }
  const Complex turn = std::polar(1.0, 0.6);
  Description& turned = all.emplace_back(Description{given, turn});
  turned.cell.lattice = Lattice(turn * first_vector, turn * second_vector);
  turned.cell.strain *= turn * turn;
  turned.cell.mean_velocity *= turn;
  for (CellBody& body : turned.cell.bodies) {
    body.curve = place(body.curve, 0.0, 0.6);
    body.centre *= turn;
    body.force *= turn;
  }
  Description& twice = all.emplace_back(Description{given});  // two cells as one
  twice.cell.lattice = Lattice(2.0 * first_vector, second_vector);
  for (const CellBody& body : given.bodies) {
    twice.cell.bodies.push_back(body);
    move(twice.cell.bodies.back(), first_vector);
  }
  return all;
}

std::vector<CellMotion> motions(const Cell& cell, Defect defect) {
  return solve(cell, {44, 100000}, {}, images_with(cell.lattice, defect)).bodies;
}

Measure changes(Defect defect) {
  return [=](Size) {
    Cell given = test::three_bodies(48);
    given.bodies[2].force = {0.4, -1.0};  // the forces do not balance
    const std::vector<CellMotion> exact = motions(given, defect);
    std::vector<Measurement> measurements;
    for (const Description& description : descriptions(given)) {
      const std::vector<CellMotion> found = motions(description.cell, defect);
      double change = 0.0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Complex velocity = found[k].velocity / description.turn;
        const Complex stresslet = found[k].stresslet / (description.turn * description.turn);
        change = std::max(
            {change, std::abs(velocity - (k == 1 ? description.more : 0.0) - exact[k].velocity),
             std::abs(found[k].omega - exact[k].omega), std::abs(stresslet - exact[k].stresslet)});
      }
      measurements.push_back({.x = static_cast<double>(measurements.size() + 1), .error = change});
    }
    return measurements;
  };
}

}  // namespace

Experiment invariances() {
  return {.key = "invariances",
          .title = "Seven other descriptions of three loaded bodies in a cell",
          .x = "description k",
          .error = "largest change of velocities, rotations and stresslets",
          .axes = Axes::no_law,
          .lines = {{.key = "change",
                     .label = "seven descriptions",
                     .measure = changes(nullptr),
                     .claim = Claim{.id = "14_19",
                                    .statement = "Motions and stresslets do not depend on how a "
                                                 "periodic problem is described.",
                                    .law = Identity{1e-12},
                                    .reason = "body moved by a lattice vector (1, 2), everything "
                                              "moved (3), other bases (4, 5), frame turned (6), "
                                              "two cells as one (7)",
                                    .api = {"stokesbook::Lattice", "stokesbook::images_in"}},
                     .control = Control{"no term with conj(A_0)", changes(without_the_forces)}}}};
}

}  // namespace stokesbook::verification::periodic
