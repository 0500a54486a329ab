#include "record/run_info.hpp"

#include <nlohmann/json.hpp>

namespace stokesbook {

std::string to_json(const RunInfo& info) {
  const nlohmann::ordered_json json = {
      {"version", info.version},
      {"git_hash", info.git_hash},
      {"compiler", info.compiler},
      {"flags", info.flags},
      {"machine", info.machine},
      {"threads", info.threads},
      {"plan", info.plan},
      {"totals",
       {{"steps", info.totals.steps},
        {"rejected_steps", info.totals.rejected_steps},
        {"solves", info.totals.solves},
        {"gmres_iterations", info.totals.gmres_iterations},
        {"matvecs", info.totals.matvecs}}},
      {"resolution",
       {{"first_nodes", info.resolution.first_nodes},
        {"most_nodes", info.resolution.most_nodes},
        {"error_estimate", info.resolution.error_estimate}}},
      {"wall_seconds", info.wall_seconds},
      {"peak_memory", info.peak_memory},
      {"exit_status", info.exit_status},
      {"message", info.message},
  };
  // A path in a message need not be UTF-8; losing a letter of it beats losing the file.
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace stokesbook
