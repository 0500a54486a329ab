// Check of exercise 09.2: linear flows, whose steps are known; two disks by solves of the library.
#include "chapters/check.hpp"

#include <array>
#include <fstream>

#include "study/plot.hpp"
#include "suspension/bodies/configuration.hpp"
#include "suspension/motion/stepping.hpp"
#include "time_stepping/runge_kutta.hpp"

using namespace stokesbook;
using Eigen::VectorXd;
using exercise::expect;

using Flow = std::function<VectorXd(const VectorXd& q)>;
using OneStep = std::function<VectorXd(const Flow& f, const VectorXd& q, double h)>;

double return_error(const OneStep& step, const Flow& f, const VectorXd& start, double t_end,
                    int steps);
double measured_order(const VectorXd& steps, const VectorXd& errors);
int order_of_return(int p);
double steps_needed(double tolerance, double error, double steps, double p);

namespace {

OneStep step_of(const Tableau& tableau) {
  return [&tableau](const Flow& f, const VectorXd& q, double h) -> VectorXd {
    const Rate rate = [&](double, const VectorXd& state) { return f(state); };
    return q + h * (runge_kutta_stages(tableau, rate, {0.0, q, f(q)}, h) * tableau.b);
  };
}

// A turn of the plane. Euler's steps multiply by 1 + i h and by 1 - i h, Heun's by
// 1 - h^2/2 + i h and its conjugate.
void check_return_error(int steps) {
  const double t_end = 1.5, h = t_end / steps;
  const Flow turn = [](const VectorXd& q) -> VectorXd { return Eigen::Vector2d{-q[1], q[0]}; };
  const VectorXd start = Eigen::Vector2d{0.6, 0.8};
  const auto expect_of = [&](const Tableau& tableau, const std::string& name, auto factor) {
    const auto after = [&](Complex one, Complex other) {
      return std::abs(std::pow(one, steps) * std::pow(other, steps) - 1.0);
    };
    const Complex there = factor(h), half = factor(0.5 * h);
    expect({.what = name + ", " + std::to_string(steps) + " steps",
            .got = return_error(step_of(tableau), turn, start, t_end, steps),
            .expected = after(there, std::conj(there)),
            .tolerance = 1e-9,
            .mistakes = {{after(there, there), "the flow has not been reversed"},
                         {after(half, std::conj(half)),
                          "this turns back at t_end/2: the way back takes "
                          "t_end as well"},
                         {std::abs(std::pow(there, steps) - 1.0), "this has not come back yet"},
                         {0.0, "the way back has to be computed too: it does not hit the start"}}});
  };
  expect_of(euler(), "Euler", [](double s) { return Complex{1.0, s}; });
  expect_of(heun(), "Heun", [](double s) { return Complex{1.0 - 0.5 * s * s, s}; });
}

void check_measured_order(double order) {
  const VectorXd steps{{10.0, 20.0, 50.0, 80.0}};
  const VectorXd errors = 3.0 * steps.array().pow(-order);
  const VectorXd centred = steps.array() - steps.mean();
  const double rate = -centred.dot(errors.array().log().matrix()) / centred.squaredNorm();
  expect({.what = "errors 3 M^-" + exercise::text(order),
          .got = measured_order(steps, errors),
          .expected = order,
          .tolerance = 1e-10,
          .mistakes = {{-order, "the order is positive where errors fall"},
                       {rate, "this is a rate: steps need a logarithm too"},
                       {1.0 / order, "this is the line of M over errors"}}});
}

// For q' = q and h > 0 the error of a step there and one back is c h^r, found from two steps.
void check_order_of_return() {
  const Flow growth = [](const VectorXd& q) -> VectorXd { return q; };
  const Flow decay = [](const VectorXd& q) -> VectorXd { return -q; };
  const std::array<const Tableau*, 4> tableaus{&euler(), &heun(), &bogacki_shampine32(),
                                               &runge_kutta4()};
  for (int p = 1; p <= 4; ++p) {
    const OneStep step = step_of(*tableaus[static_cast<std::size_t>(p - 1)]);
    const auto left = [&](double h) {
      const VectorXd one = VectorXd::Ones(1);
      return std::abs(step(decay, step(growth, one, h), h)[0] - 1.0);
    };
    // One order is lost over 1/h steps.
    const double order = std::round(std::log2(left(0.1) / left(0.05))) - 1.0;
    const int got = order_of_return(p);
    expect({.what = "p = " + std::to_string(p),
            .got = static_cast<double>(got),
            .expected = order,
            .tolerance = 0.0,
            .mistakes = {{static_cast<double>(p),
                          "methods of even order gain one: errors of the way back "
                          "undo those of the way there"},
                         {p + 1.0, "the errors of both ways add up where p is odd"},
                         {2.0 * p, "only the leading error of a step cancels"}}});
  }
}

void check_steps_needed() {
  for (const double p : {1.0, 3.0, 5.0}) {
    const double exact = 100.0 * std::pow(1e4, 1.0 / p);
    expect({.what = "order " + exercise::text(p) + ", error 1e-2 with 100 steps, tolerance 1e-6",
            .got = steps_needed(1e-6, 1e-2, 100.0, p),
            .expected = exact,
            .tolerance = 1e-12,
            .mistakes = {{100.0 * std::pow(1e4, p), "the order is a root here: (e/tol)^(1/p)"},
                         {100.0 * std::pow(1e-4, 1.0 / p), "fewer steps do not err less"},
                         {exact / 100.0, "this is the factor: times the steps of the run"}}});
  }
}

// Two disks in shear, from the configuration of the chapter's picture, nearer to each other.
void check_experiment() {
  Scene scene;
  scene.flow = ShearFlow{1.0};
  for (const Complex position : {Complex{-3.0, 0.6}, Complex{}}) {
    scene.bodies.push_back({.shape = Circle{0.5}, .position = position, .n_nodes = 32});
  }
  scene.solver.tolerance = 1e-5;
  scene.solver.gmres_tol = 1e-12;
  const SuspensionSolver solver(scene);
  const Instant initial = solver.start();
  const Resolutions nodes = resolutions_of(solver.solve(initial).discretisation);
  int solves = 0;
  const Flow disks = [&](const VectorXd& q) {
    ++solves;
    return to_rate(solver.solve_nearby(solver.instant(to_configuration(q)), nodes));
  };

  struct Entry {
    std::string name;
    const Tableau& tableau;
    int order;
    int fewest;
  };
  const std::array<Entry, 3> methods{{{"Euler", euler(), 1, 80},
                                      {"Heun", heun(), 2, 20},
                                      {"Runge-Kutta 4", runge_kutta4(), 4, 20}}};
  std::ofstream table("return.csv");
  table << "method,steps,solves,error\n";
  study::Plot plot{.title = "Two disks there and back",
                   .x_label = "solves",
                   .y_label = "distance from the start"};
  for (const auto& [name, tableau, order, fewest] : methods) {
    study::PlotLine line{name};
    VectorXd steps(3), errors(3);
    for (Eigen::Index k = 0; k < 3; ++k) {
      solves = 0;
      steps[k] = fewest << k;
      errors[k] =
          return_error(step_of(tableau), disks, to_state(initial.configuration), 8.0, fewest << k);
      table << '"' << name << "\"," << steps[k] << ',' << solves << ',' << errors[k] << '\n';
      line.points.push_back({static_cast<double>(solves), errors[k]});
    }
    plot.lines.push_back(line);
    expect({.what = name,
            .got = measured_order(steps, errors),
            .expected = static_cast<double>(order_of_return(order)),
            .tolerance = 0.12});
  }
  std::ofstream("return.svg") << study::draw_plot(plot);
}

}  // namespace

int main() {
  return exercise::run({{.title = "there and back",
                         .formula = "|Psi_h^M Phi_h^M q - q|, Phi_h a step of f, Psi_h one of -f",
                         .hint = "the reversed flow has the rate -f(q)",
                         .check =
                             [] {
                               for (const int steps : {5, 12}) check_return_error(steps);
                             }},
                        {.title = "the measured order",
                         .formula = "log error = c - p log M",
                         .hint = "a least-squares line, with logarithms on both axes",
                         .check =
                             [] {
                               for (const double order : {1.0, 2.5, 4.0})
                                 check_measured_order(order);
                             }},
                        {.title = "the order of the return",
                         .formula = "c h^(p+1) + c (-h)^(p+1)",
                         .hint = "a step of the reversed flow is a step with -h",
                         .check = check_order_of_return},
                        {.title = "the steps needed",
                         .formula = "M (error/tolerance)^(1/p)",
                         .hint = "error = C M^-p; the constant is known from the run",
                         .check = check_steps_needed},
                        {.title = "the experiment",
                         .builds_on = {1, 2, 3},
                         .formula = "the slopes are the orders of task 3",
                         .hint = "look at return.svg",
                         .check = check_experiment}});
}
