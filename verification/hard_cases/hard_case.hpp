#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "suspension/solver/solver.hpp"

namespace stokesbook::verification::hard_cases {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Result of a hard case.
struct Finding {
  double tolerance = unknown;  ///< required tolerance
  double error = unknown;      ///< difference from a closed form, a symmetry or a finer solution
  double estimate = unknown;   ///< solver's own estimate of the error
  long long iterations = 0;    ///< GMRES iterations
  std::string refusal = {};    ///< reason why there is no answer; empty if there is one
};

/// Names the required kind of result. The value `either` accepts both kinds, and is used where
/// rounding errors decide between them.
enum class Due { answer, refusal, either };

/// A hard problem, and the required kind of result.
struct HardCase {
  std::string chapter;                  ///< chapter that it belongs to, "06"
  std::string asked;                    ///< description for the reader
  std::function<Finding()> find;        ///< solves the problem
  Due due = Due::answer;                ///< required kind of result
  std::vector<std::string> words = {};  ///< words that the message of a refusal must contain
};

/// Returns whether a result is as required: an answer whose error and estimate are within the
/// tolerance, or a refusal whose message contains the words.
bool is_met(const HardCase& hard, const Finding& finding);

/// Returns the difference of a solution from the known result, as a velocity.
using Measure = std::function<double(const Solution&)>;

/// Writes a number into a sentence, by a format of printf.
std::string text(const char* format, double number);

/// Returns the larger of the differences of velocities and of angular velocities times a length.
double distance_of_motions(const RigidMotion& a, const RigidMotion& b, double length);

/// Compares with a solution of the same scene to three more digits.
Measure against_finer(const Scene& scene);

/// Solves a scene's start and measures the error; a refusal is recorded in the result.
Finding solve(const Scene& scene, const Measure& error);

/// Returns a free body at rest with automatic nodes.
Body body(const Shape& shape, Complex position, double orientation = 0.0);

/// Returns a scene with a solver tolerance.
Scene scene(const BackgroundFlow& flow, std::vector<Body> bodies, double tolerance);

/// Returns two circles of radius 1 with a gap, in extension along the line of centres.
Scene circles_in_extension(double gap, double tolerance);

/// @name The cases
/// @{
std::vector<HardCase> answers();   ///< single instants that have an answer
std::vector<HardCase> crowds();    ///< instants of many bodies
std::vector<HardCase> sums();      ///< fast sums
std::vector<HardCase> contacts();  ///< runs in which bodies are pressed together
std::vector<HardCase> problems();  ///< complementarity problems
std::vector<HardCase> motions();   ///< runs without contact
std::vector<HardCase> refusals();  ///< problems that the solver must refuse
/// @}

}  // namespace stokesbook::verification::hard_cases
