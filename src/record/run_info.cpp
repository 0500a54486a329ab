// Writes the file `run.json` of a run, and reads the exit status from it.
#include "record/run_info.hpp"

#include <system_error>

#include <nlohmann/json.hpp>

#include "record/atomic_file.hpp"

namespace stokesbook {

namespace {

nlohmann::ordered_json totals_of(const RunInfo& info) {
  const RunTotals& totals = info.totals;
  nlohmann::ordered_json entries = {{"steps", totals.steps},
                                    {"rejected_steps", totals.rejected_steps},
                                    {"solves", totals.solves},
                                    {"gmres_iterations", totals.gmres_iterations},
                                    {"matvecs", totals.matvecs}};
  if (info.has_contact) {
    entries.update({{"ncp_iterations", totals.ncp_iterations},
                    {"contact_solves", totals.contact_solves},
                    {"contact_seconds", totals.contact_seconds},
                    {"halved_by_contact", totals.halved_by_contact},
                    {"largest_force_imbalance", totals.largest_force_imbalance},
                    {"largest_torque_imbalance", totals.largest_torque_imbalance},
                    {"energy_injected", totals.energy_injected}});
  }
  return entries;
}

/// Reads an entry of the file; json::parse() and the conversion throw errors about its contents.
template <class Value>
Value read_entry(const std::filesystem::path& path, const char* pointer) {
  try {
    const nlohmann::json entries = nlohmann::json::parse(read_text(path));
    return entries.at(nlohmann::json::json_pointer(pointer)).get<Value>();
  } catch (const nlohmann::json::exception& damage) {
    throw RecordError(path, "is damaged: " + std::string(damage.what()));
  }
}

}  // namespace

std::string to_json(const RunInfo& info) {
  nlohmann::ordered_json entries = {
      {"version", info.version},
      {"git_hash", info.git_hash},
      {"compiler", info.compiler},
      {"flags", info.flags},
      {"machine", info.machine},
      {"threads", info.threads},
      {"plan", info.plan},
      {"totals", totals_of(info)},
      {"resolution",
       {{"first_nodes", info.resolution.first_nodes},
        {"most_nodes", info.resolution.most_nodes},
        {"velocity_error", info.resolution.velocity_error},
        {"configuration_error", info.resolution.configuration_error},
        {"field_errors", info.resolution.field_errors}}},
      {"wall_seconds", info.wall_seconds},
      {"peak_memory", info.peak_memory},
      {"exit_status", nullptr},
      {"message", info.message},
  };
  if (info.exit_status) entries["exit_status"] = *info.exit_status;
  if (const auto& uniform = info.uniform_velocity) {
    entries["uniform_velocity"] = {uniform->real(), uniform->imag()};
  }
  // A path in a message may have bytes that are not UTF-8. The library replaces these bytes; it
  // would throw otherwise, and the file would be lost.
  return entries.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

std::optional<int> exit_status_of(const std::filesystem::path& run) {
  const std::filesystem::path path = run / "run.json";
  std::error_code unreadable;
  if (!std::filesystem::exists(path, unreadable)) return std::nullopt;
  if (read_entry<nlohmann::json>(path, "/exit_status").is_null()) return std::nullopt;
  return read_entry<int>(path, "/exit_status");
}

std::vector<int> most_nodes_of(const std::filesystem::path& run) {
  return read_entry<std::vector<int>>(run / "run.json", "/resolution/most_nodes");
}

}  // namespace stokesbook
