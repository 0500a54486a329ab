// Prints what a run computes: its plan, its progress with an estimate of the remaining time, and at
// the end its cost and error estimates.
#include "cli/run_report.hpp"

#include <cmath>
#include <cstdio>

#include <unistd.h>

#include "cli/message.hpp"
#include "text/number_text.hpp"

namespace stokesbook {

using std::chrono::duration;
using std::chrono::steady_clock;

Progress::Progress(double t_start, double t_final, bool quiet)
    : t_start_(t_start), t_final_(t_final), quiet_(quiet), terminal_(isatty(STDOUT_FILENO) != 0) {}

void Progress::step(const StepInfo& info) {
  const auto now = steady_clock::now();
  const bool last = info.t >= t_final_;
  const double pause = terminal_ ? 0.1 : 5.0;
  if (quiet_ || (!last && duration<double>(now - last_print_).count() < pause)) return;
  last_print_ = now;
  const double elapsed = duration<double>(now - start_).count();
  // The remaining time at the mean speed so far.
  const double left = elapsed * (t_final_ - info.t) / (info.t - t_start_);
  std::printf(
      "%st = %.4g of %.4g, dt %.3g, gap %.3g, %d contacts, %d GMRES iterations, %.3g s left%s",
      terminal_ ? "\r\033[K" : "", info.t, t_final_, info.dt, info.min_gap, info.contacts,
      info.gmres_iterations, left, terminal_ ? "" : "\n");
  std::fflush(stdout);
  open_line_ = terminal_;
}

void Progress::finish() {
  if (open_line_) std::printf("\n");
  open_line_ = false;
}

void print_plan(const std::string& title, const std::vector<std::string>& plan) {
  if (!title.empty()) std::printf("%s\n", for_terminal(title).c_str());
  for (const std::string& line : plan) std::printf("  %s\n", line.c_str());
  std::fflush(stdout);
}

void print_motions(const Frame& frame) {
  std::printf("%6s %24s %24s %24s\n", "body", "ux", "uy", "omega");
  for (std::size_t k = 0; k < frame.bodies.size(); ++k) {
    const BodyState& body = frame.bodies[k];
    std::printf("%6zu %24.15g %24.15g %24.15g\n", k, body.velocity.real() + 0.0,
                body.velocity.imag() + 0.0, body.omega + 0.0);  // -0 becomes 0
  }
}

void print_cell(const Rheology& rheology) {
  const auto text = [](double number) { return short_number(number, 12); };
  const auto& [stress, contact, viscosity, pressure, by_traction] = *rheology.cell;
  std::printf("mean stress of the cell: 11 %s, 12 %s, 21 %s, 22 %s\n", text(stress(0, 0)).c_str(),
              text(stress(0, 1)).c_str(), text(stress(1, 0)).c_str(), text(stress(1, 1)).c_str());
  std::printf("viscosity %s, first normal stress difference %s, particle pressure %s\n",
              text(viscosity).c_str(), text(rheology.cell->normal_stress_difference()).c_str(),
              text(pressure).c_str());
  std::printf("dissipation that the bodies add: %s from stresslets and loads, %s from tractions\n",
              text(rheology.dissipation).c_str(), text(by_traction).c_str());
  if (const Complex mean = rheology.uniform_velocity; !std::isnan(mean.real())) {
    std::printf("mean velocity of the cell beside [flow]: (%s, %s)\n", text(mean.real()).c_str(),
                text(mean.imag()).c_str());
  }
}

void print_matrix_errors(const MatrixErrors& errors) {
  std::printf(
      "matrices: asymmetry of resistance %s, of mobility %s; error of their product %s; all "
      "relative to the diagonal\n",
      short_number(errors.resistance_asymmetry).c_str(),
      short_number(errors.mobility_asymmetry).c_str(), short_number(errors.inverse_error).c_str());
}

void print_report(const RunInfo& info, const std::filesystem::path& out) {
  const RunTotals& totals = info.totals;
  std::printf(
      "%lld steps, %lld more rejected, %lld solves, %lld GMRES iterations, %.1f s, %lld MB; "
      "results in %s\n",
      totals.steps, totals.rejected_steps, totals.solves, totals.gmres_iterations,
      info.wall_seconds, info.peak_memory / 1'000'000, out.c_str());
  std::printf("error estimates: of velocities, relative to their scale, %s",
              short_number(info.resolution.velocity_error).c_str());
  if (totals.steps > 0) {
    std::printf("; of positions in radii and angles, by all steps together, %s",
                short_number(info.resolution.configuration_error).c_str());
  }
  std::printf("\n");
  const char* before = "error estimates of fields, relative to their largest values: ";
  for (const auto& [quantity, error] : info.resolution.field_errors) {
    std::printf("%s%s %s", before, quantity.c_str(), short_number(error).c_str());
    before = ", ";
  }
  if (!info.resolution.field_errors.empty()) std::printf("\n");
  if (const auto& uniform = info.uniform_velocity) {
    std::printf(
        "the fluid at infinity has the velocity (%s, %s) beside [flow], for zero net force: "
        "flow.gauge_length would prescribe it\n",
        short_number(uniform->real()).c_str(), short_number(uniform->imag()).c_str());
  }
  if (!info.has_contact) return;
  std::printf(
      "contact: %lld solves of %lld iterations in %.1f s, %lld steps halved; imbalance of forces "
      "at most %s, of torques %s; energy injected %s\n",
      totals.contact_solves, totals.ncp_iterations, totals.contact_seconds,
      totals.halved_by_contact, short_number(totals.largest_force_imbalance).c_str(),
      short_number(totals.largest_torque_imbalance).c_str(),
      short_number(totals.energy_injected).c_str());
}

void warn_of_estimates(const RunResolution& resolution, double tolerance) {
  const std::string limit = short_number(tolerance);
  for (const auto& [quantity, error] : resolution.field_errors) {
    if (error <= tolerance) continue;
    std::fprintf(stderr,
                 "stokes: the error estimate of the field %s is up to %s, above solver.tolerance = "
                 "%s: n_nodes is too small, or automatic nodes have reached their limit\n",
                 quantity.c_str(), short_number(error).c_str(), limit.c_str());
  }
  if (resolution.velocity_error <= tolerance) return;
  if (std::isinf(resolution.velocity_error)) {
    std::fprintf(stderr,
                 "stokes: the error of velocities could not be estimated in steps whose "
                 "velocity_error in steps.csv is inf\n");
  } else {
    std::fprintf(stderr,
                 "stokes: the error estimate of velocities is up to %s, above solver.tolerance = "
                 "%s; steps.csv has it for each step\n",
                 short_number(resolution.velocity_error).c_str(), limit.c_str());
  }
}

}  // namespace stokesbook
