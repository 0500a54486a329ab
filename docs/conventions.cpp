// Checks the conventions of the book by identities. Each identity fixes a sign or a scale, which is
// computed in two ways.
// conventions [FOLDER] prints all identities, and writes each to FOLDER/conventions_NAME.txt for
// the page of conventions. The exit status is 0 if all hold.
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>

#include <Eigen/LU>

#include "closure/bordered_system.hpp"
#include "double_layer/double_layer.hpp"
#include "double_layer/kernels.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "null_space/null_space.hpp"
#include "trapezoid/curve.hpp"

using namespace stokesbook;
using std::numbers::pi;

namespace {

constexpr double mu = 1.3;
const Complex force{1.0, 0.5};
const double torque = 0.7;

const Curve body = sample(Ellipse{.a = 2.0, .b = 1.0}, 64, Side::fluid_outside);
const Curve wall = sample(Ellipse{.a = 2.0, .b = 1.0}, 64, Side::fluid_inside);

// Collects the lines of one identity after another, and whether all of them held.
class Identities {
 public:
  explicit Identities(std::string folder) : folder_(std::move(folder)) {}

  void begin(const std::string& name) {
    write();
    name_ = name;
  }

  void check(const char* what, double left, double right) {
    report(what, number(left), number(right), std::abs(left - right), std::abs(right));
  }

  void check(const char* what, Complex left, Complex right) {
    report(what, number(left.real()) + number(left.imag()),
           number(right.real()) + number(right.imag()), std::abs(left - right), std::abs(right));
  }

  bool finish() {
    write();
    return all_hold_;
  }

 private:
  void write() {
    if (name_.empty()) return;
    std::cout << name_ << '\n' << lines_.str() << '\n';
    if (!folder_.empty()) std::ofstream(folder_ + "/conventions_" + name_ + ".txt") << lines_.str();
    lines_.str("");
  }

  static std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, " %13.9f", value);
    return text;
  }

  void report(const std::string& what, const std::string& left, const std::string& right,
              double difference, double size) {
    const bool holds = difference <= 1e-10 * std::max(1.0, size);
    all_hold_ = all_hold_ && holds;
    char text[32];
    std::snprintf(text, sizeof text, "%.0e", difference);
    lines_ << what << '\n'
           << "  computed  " << left << '\n'
           << "  expected  " << right << '\n'
           << "  difference     " << text << (holds ? "" : ": FAILED") << '\n';
  }

  std::string folder_, name_;
  std::ostringstream lines_;
  bool all_hold_ = true;
};

// Returns the integral over arclength, int f ds, by the trapezoid rule.
Complex integral(const Curve& curve, const ComplexVector& f) {
  return weights(curve).cwiseProduct(f).sum();
}

// Returns the flux of a velocity out of the fluid, int u.n ds.
double flux(const Curve& curve, const ComplexVector& u) {
  return integral(curve, normals(curve).conjugate().cwiseProduct(u)).real();
}

ComplexVector rigid_motion(const ComplexVector& x) {
  return (Complex{0.6, -0.8} + 1.5 * imaginary * x.array()).matrix();
}

// Returns a smooth density without symmetry.
ComplexVector some_density(Eigen::Index n) {
  ComplexVector eta(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const double t = 2.0 * pi * static_cast<double>(j) / static_cast<double>(n);
    eta[j] = {std::cos(t) + 0.3 * std::sin(3.0 * t), std::exp(std::sin(t)) - 0.5};
  }
  return eta;
}

// Returns D eta on the curve itself, the principal value.
ComplexVector principal_value(const Curve& curve, const ComplexVector& eta) {
  const Eigen::VectorXd value = double_layer_matrix(curve) * interleaved(eta);
  return deinterleaved(value);
}

// Returns the limit of D eta at node 0 from the side to which `direction` times the normal points.
// The polynomial through the values at 10 distances is evaluated at distance 0.
Complex limit(const Shape& shape, Side side, double direction) {
  const Curve fine = sample(shape, 1 << 16, side);
  const StressletSum layer({fine});
  constexpr Eigen::Index count = 10;
  ComplexVector targets(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    targets[k] = fine.x[0] + direction * 3e-3 * static_cast<double>(k + 1) * normals(fine)[0];
  }
  const ComplexVector values = layer(targets, some_density(fine.size()));
  Complex sum{};
  double weight = count;
  for (Eigen::Index k = 1; k <= count; ++k) {
    sum += weight * values[k - 1];
    weight *= -static_cast<double>(count - k) / static_cast<double>(k + 1);
  }
  return sum;
}

// Returns sigma n of a velocity and a pressure at a point, by central differences of order 6.
Complex traction(const std::function<Complex(Complex)>& velocity, double pressure, Complex x,
                 Complex n) {
  const auto derivative = [&](Complex direction) {
    const Complex h = 2e-3 * direction;
    const auto difference = [&](double k) { return velocity(x + k * h) - velocity(x - k * h); };
    return (45.0 * difference(1.0) - 9.0 * difference(2.0) + difference(3.0)) / (60.0 * 2e-3);
  };
  const Complex du1 = derivative(1.0), du2 = derivative(imaginary);
  const double shear = du2.real() + du1.imag();
  return -pressure * n + mu * Complex{2.0 * du1.real() * n.real() + shear * n.imag(),
                                      shear * n.real() + 2.0 * du2.imag() * n.imag()};
}

// Returns the motion of one free body, by the dense reduced system.
RigidMotion motion_of(const StokesProblem& problem) {
  const DenseSystem system = assemble(problem, ClosureForm::reduced);
  const Eigen::VectorXd density = system.matrix.partialPivLu().solve(system.rhs);
  return complete_dense(problem, ClosureForm::reduced, density).motions.at(0);
}

void plane(Identities& identities) {
  //! [plane]
  const Complex arm{1.0, 0.0}, push{0.0, 1.0};
  identities.check("e1 turned by +90 degrees", perp(arm), imaginary);
  identities.check("torque of a push up, right of c", cross(arm, push), 1.0);
  //! [plane]
}

void normal(Identities& identities) {
  //! [normal]
  for (const Curve& curve : {body, wall}) {
    identities.check(curve.side == Side::fluid_inside ? "int x.n ds, wall" : "int x.n ds, body",
                     flux(curve, curve.x), 2.0 * curve.sign() * area(curve));
  }
  identities.check("int kappa ds, body", curvatures(body).dot(weights(body)), 2.0 * pi);
  //! [normal]
}

void rigid(Identities& identities) {
  //! [rigid]
  const Curve fine_body = sample(Ellipse{.a = 2.0, .b = 1.0}, 600, Side::fluid_outside);
  const Curve fine_wall = sample(Ellipse{.a = 2.0, .b = 1.0}, 600, Side::fluid_inside);
  const ComplexVector inside = ComplexVector{{Complex{0.3, 0.2}}};
  const ComplexVector outside = ComplexVector{{Complex{2.5, 0.5}}};
  const Complex v = rigid_motion(inside)[0];
  const ComplexVector of_body = rigid_motion(fine_body.x);

  identities.check("D v, body, inside it", StressletSum({fine_body})(inside, of_body)[0], v);
  identities.check("D v, body, in the fluid", StressletSum({fine_body})(outside, of_body)[0],
                   Complex{});
  identities.check("D v, wall, in the fluid", StressletSum({fine_wall})(inside, of_body)[0], -v);
  identities.check("D v, body, on the curve", principal_value(body, rigid_motion(body.x))[0],
                   0.5 * rigid_motion(body.x)[0]);
  //! [rigid]
}

void jump(Identities& identities) {
  //! [jump]
  const ComplexVector eta = some_density(body.size());
  const Complex on_curve = principal_value(body, eta)[0];
  const double into_fluid = -1.0, into_body = +1.0;  // factors of n

  identities.check("D eta, from the fluid", limit(Ellipse{2.0, 1.0}, body.side, into_fluid),
                   on_curve - 0.5 * eta[0]);
  identities.check("D eta, from the body", limit(Ellipse{2.0, 1.0}, body.side, into_body),
                   on_curve + 0.5 * eta[0]);
  //! [jump]
}

void flux_of_double_layer(Identities& identities) {
  //! [flux]
  const ComplexVector eta = some_density(body.size());
  const ComplexVector at_body = principal_value(body, eta) - 0.5 * eta;
  const ComplexVector at_wall = principal_value(wall, eta) - 0.5 * eta;

  identities.check("flux of D eta, body", flux(body, at_body), -flux(body, eta));
  identities.check("flux of D eta, wall", flux(wall, at_wall), 0.0);
  identities.check("N0 n on the wall, over n", null_space_velocity(wall, normals(wall))[0],
                   -normals(wall)[0]);
  //! [flux]
}

void stokeslet_force(Identities& identities) {
  //! [force]
  const auto velocity = [](Complex x) { return stokeslet(x, force, mu, 1.0); };
  ComplexVector f(body.size());  // traction of the body on the fluid: n points into the body
  for (Eigen::Index j = 0; j < body.size(); ++j) {
    const double pressure = dot(body.x[j], force) / (2.0 * pi * std::norm(body.x[j]));
    f[j] = traction(velocity, pressure, body.x[j], normals(body)[j]);
  }
  identities.check("int sigma n ds, Stokeslet F", integral(body, f), force);
  //! [force]
}

void rotlet_torque(Identities& identities) {
  //! [torque]
  const auto velocity = [](Complex x) { return rotlet(x, torque, mu); };
  ComplexVector moment(body.size());
  for (Eigen::Index j = 0; j < body.size(); ++j) {
    moment[j] = cross(body.x[j], traction(velocity, 0.0, body.x[j], normals(body)[j]));
  }
  identities.check("int x^perp.sigma n ds, rotlet L", integral(body, moment), torque);
  //! [torque]
}

void mobility(Identities& identities) {
  //! [mobility]
  const double a = 0.7, ell = 1.0;
  Component disk;
  disk.curve = sample(Circle{a}, 32, Side::fluid_outside);
  disk.force = force;
  disk.torque = torque;
  StokesProblem problem;
  problem.viscosity = mu;
  problem.gauge_length = ell;
  problem.components = {disk};
  const RigidMotion pushed = motion_of(problem);
  identities.check("U of a pushed disk", pushed.velocity,
                   force / (4.0 * pi * mu) * (0.5 - std::log(a / ell)));
  identities.check("omega of a twisted disk", pushed.omega, torque / (4.0 * pi * mu * a * a));

  problem.components[0].force = problem.components[0].torque = 0.0;
  problem.background = disk.curve.x.imag().cast<Complex>();  // shear flow (y, 0)
  identities.check("omega of a disk in shear", motion_of(problem).omega, -0.5);
  //! [mobility]
}

// The kernels below are defined as in the documentation of other codes; r, n and eta are defined as
// in this book.
const Complex r{0.8, -0.3}, n = std::polar(1.0, 0.4), eta{0.2, 0.9};

void nanorods(Identities& identities) {
  //! [nanorods]
  const Complex lambda = force / mu;            // Stokeslet strength of nanorods
  const double xi = -torque / (4.0 * pi * mu);  // rotlet strength of nanorods, clockwise
  const double rho2 = std::norm(r);
  const Complex its_stokeslet =
      (-0.5 * std::log(rho2) * lambda + r * dot(r, lambda) / rho2) / (4.0 * pi);
  const Complex its_rotlet = xi * Complex{r.imag(), -r.real()} / rho2;
  identities.check("Stokeslet", its_stokeslet, stokeslet(r, force, mu, 1.0));
  identities.check("rotlet", its_rotlet, rotlet(r, torque, mu));
  //! [nanorods]
}

void bie2d(Identities& identities) {
  //! [bie2d]
  const double s = body.sign();
  const Complex outward = s * n;  // the normal of bie2d always points outwards
  const Complex tau = s * eta;    // the density of bie2d
  const double rho2 = std::norm(r);
  const Complex its_stokeslet =
      (std::log(1.0 / std::sqrt(rho2)) * force + r * dot(r, force) / rho2) / (4.0 * pi * mu);
  const Complex its_double_layer = r * dot(r, tau) * dot(r, outward) / (pi * rho2 * rho2);
  identities.check("single layer", its_stokeslet, stokeslet(r, force, mu, 1.0));
  identities.check("double layer", its_double_layer, stresslet(r, n, eta));
  //! [bie2d]
}

void chunkie(Identities& identities) {
  //! [chunkie]
  const Complex travel = imaginary * n;  // clockwise on bodies: the fluid is on the left
  const Complex its_normal{travel.imag(), -travel.real()};  // right of the direction of travel
  const double rho2 = std::norm(r);
  const Complex its_double_layer = r * dot(r, eta) * dot(r, its_normal) / (pi * rho2 * rho2);
  identities.check("double layer", its_double_layer, stresslet(r, n, eta));
  //! [chunkie]
}

void fmm2d(Identities& identities) {
  //! [fmm2d]
  const Complex stoklet = force / (2.0 * pi * mu), strslet = -eta / (2.0 * pi), strsvec = n;
  const double rho2 = std::norm(r);
  const Complex its_stokeslet =
      r * dot(r, stoklet) / (2.0 * rho2) - 0.5 * std::log(std::sqrt(rho2)) * stoklet;
  const Complex its_stresslet = -2.0 * r * dot(r, strslet) * dot(r, strsvec) / (rho2 * rho2);
  identities.check("Stokeslet", its_stokeslet, stokeslet(r, force, mu, 1.0));
  identities.check("stresslet", its_stresslet, stresslet(r, n, eta));
  //! [fmm2d]
}

// Returns the integral over z from -reach to reach of a kernel of R = |(rho, z)|, by the midpoint
// rule in t, where z = rho sinh(t).
Complex along_third_dimension(double rho, double reach,
                              const std::function<Complex(double)>& kernel) {
  constexpr int count = 400;
  const double end = std::asinh(reach / rho), h = 2.0 * end / count;
  Complex sum{};
  for (int k = 0; k < count; ++k) {
    const double distance = rho * std::cosh(-end + (k + 0.5) * h);
    sum += h * distance * kernel(distance);
  }
  return sum;
}

void sctl(Identities& identities) {
  //! [sctl]
  const double rho = std::abs(r), reach = 1e6;  // sources at (y, z) with |z| < reach
  const Complex f = force / mu;
  const auto stokes3d_fxu = [&](double distance) {
    return (f / distance + r * dot(r, f) / std::pow(distance, 3)) / (8.0 * pi);
  };
  const auto stokes3d_dxu = [&](double distance) {
    return 3.0 / (4.0 * pi) * r * dot(r, eta) * dot(r, n) / std::pow(distance, 5);
  };
  identities.check("int Stokes3D_FxU dz", along_third_dimension(rho, reach, stokes3d_fxu),
                   stokeslet(r, force, mu, 2.0 * reach));
  identities.check("int Stokes3D_DxU dz", along_third_dimension(rho, reach, stokes3d_dxu),
                   stresslet(r, n, eta));
  //! [sctl]
}

}  // namespace

int main(int argc, char** argv) {
  Identities identities(argc > 1 ? argv[1] : "");
  const std::pair<const char*, void (*)(Identities&)> all[] = {{"plane", plane},
                                                               {"normal", normal},
                                                               {"rigid", rigid},
                                                               {"jump", jump},
                                                               {"flux", flux_of_double_layer},
                                                               {"force", stokeslet_force},
                                                               {"torque", rotlet_torque},
                                                               {"mobility", mobility},
                                                               {"nanorods", nanorods},
                                                               {"bie2d", bie2d},
                                                               {"chunkie", chunkie},
                                                               {"fmm2d", fmm2d},
                                                               {"sctl", sctl}};
  for (const auto& [name, check] : all) {
    identities.begin(name);
    check(identities);
  }
  return identities.finish() ? 0 : 1;
}
