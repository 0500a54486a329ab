#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "suspension/solver/solver.hpp"

namespace stokesbook::verification::hard_cases {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// What came of a hard case.
struct Finding {
  double tolerance = unknown;  ///< that was asked for
  double error = unknown;      ///< against a closed form, a symmetry or a finer solution
  double estimate = unknown;   ///< of that error, by the solver itself
  long long iterations = 0;    ///< of GMRES
  std::string refusal = {};    ///< why there is no answer; empty: there is one
};

/// What must come of a case. Either will do where rounding decides.
enum class Due { answer, refusal, either };

/// A question that is hard, and what must come of it.
struct HardCase {
  std::string chapter;                  ///< that it is about, "06"
  std::string asked;                    ///< for people
  std::function<Finding()> find;        ///< asks
  Due due = Due::answer;                ///< what must come of it
  std::vector<std::string> words = {};  ///< of a refusal
};

/// Tells whether a case went as it must: an answer whose error and estimate are within the
/// tolerance, or a refusal that says what it is about.
bool is_met(const HardCase& hard, const Finding& finding);

/// Distance of a solution from what is known, a velocity.
using Measure = std::function<double(const Solution&)>;

/// A number in a sentence, by a format of printf.
std::string text(const char* format, double number);

/// Larger one of the differences of velocities and, times a length, of angular velocities.
double distance_of_motions(const RigidMotion& a, const RigidMotion& b, double length);

/// Compares with the same scene, asked for three more digits.
Measure against_finer(const Scene& scene);

/// Solves a scene's start, and compares; refusals are findings.
Finding solve(const Scene& scene, const Measure& error);

/// A free body at rest with automatic nodes.
Body body(const Shape& shape, Complex position, double orientation = 0.0);

/// A scene with an accuracy to be kept.
Scene scene(const BackgroundFlow& flow, std::vector<Body> bodies, double tolerance);

/// Two circles of radius 1 so far apart, in extension along the line of their centres.
Scene circles_in_extension(double gap, double tolerance);

/// @name The cases
/// @{
std::vector<HardCase> answers();   ///< one instant, which has an answer
std::vector<HardCase> crowds();    ///< instants of many bodies
std::vector<HardCase> sums();      ///< fast sums
std::vector<HardCase> contacts();  ///< runs in which bodies are pressed together
std::vector<HardCase> problems();  ///< of complementarity
std::vector<HardCase> motions();   ///< runs
std::vector<HardCase> refusals();  ///< what must not be answered
/// @}

}  // namespace stokesbook::verification::hard_cases
