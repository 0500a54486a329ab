// Writes and reads the file `checkpoint` of a run: a line of JSON between a line with the version
// of the format and a line with a checksum.
#include "record/checkpoint.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include <nlohmann/json.hpp>

#include "record/atomic_file.hpp"
#include "text/fingerprint.hpp"
#include "text/number_text.hpp"

namespace stokesbook {

namespace {

using nlohmann::json;

// The version number must rise with every change of the contents, including those of the history.
const std::string magic = "stokesbook checkpoint 7\n";

std::string checksum_line(std::string_view body) {
  return "checksum " + fingerprint(body) + '\n';
}

/// Returns a JSON array: the count of the numbers, which shows whether a damaged text has lost
/// some, and the numbers. JSON has no infinities: they become texts, "inf".
json to_json(const auto& numbers) {
  json list = json::array({numbers.size()});
  for (const double x : numbers) list.push_back(std::isfinite(x) ? json(x) : json(number_text(x)));
  return list;
}

/// Returns a count; a conversion would also accept negative numbers and fractions.
std::uintmax_t count_in(const json& number) {
  if (number.is_number_unsigned()) return number.get<std::uintmax_t>();
  throw std::invalid_argument("'" + number.dump() + "' is not a count");
}

/// Checks a count that is stored beside what it counts.
void require_count(std::size_t found, const json& count, std::string_view counted) {
  if (found == count_in(count)) return;
  throw std::invalid_argument("has " + std::to_string(found) + ' ' + std::string(counted) +
                              " where it states " + count.dump());
}

std::vector<double> numbers_in(const json& list) {
  std::vector<double> numbers;
  for (const json& x : list) {
    numbers.push_back(x.is_string() ? parse_number<double>(x.get<std::string>()).value()
                                    : x.get<double>());
  }
  require_count(numbers.size() - 1, list.at(0), "numbers");
  numbers.erase(numbers.begin());
  return numbers;
}

Eigen::VectorXd vector_in(const json& list) {
  const std::vector<double> numbers = numbers_in(list);
  return Eigen::VectorXd::Map(numbers.data(), std::ssize(numbers));
}

SavedRun parse(std::string_view text) {
  const json data = json::parse(text);
  SavedRun saved;
  data.at("scene").get_to(saved.scene);
  data.at("program").get_to(saved.program);
  data.at("t").get_to(saved.checkpoint.t);
  saved.checkpoint.step = static_cast<long long>(count_in(data.at("step")));
  for (const auto& [name, size] : data.at("tables").items()) {
    saved.table_sizes[name] = count_in(size);
  }
  saved.frame_times = numbers_in(data.at("frames"));
  saved.checkpoint.state = vector_in(data.at("state"));
  for (const auto& [name, numbers] : data.at("history").items()) {
    saved.checkpoint.history[name] = vector_in(numbers);
  }
  require_count(saved.checkpoint.history.size(), data.at("vectors"), "vectors");
  return saved;
}

}  // namespace

std::string to_text(const SavedRun& saved) {
  const auto& [t, step, state, history] = saved.checkpoint;
  json data{{"scene", saved.scene},
            {"program", saved.program},
            {"t", t},
            {"step", step},
            {"tables", saved.table_sizes},
            {"frames", to_json(saved.frame_times)},
            {"state", to_json(state)},
            {"vectors", history.size()},
            {"history", json::object()}};
  for (const auto& [name, numbers] : history) data["history"][name] = to_json(numbers);
  const std::string text = magic + data.dump() + '\n';
  return text + checksum_line(text);
}

SavedRun read_saved_run(const std::filesystem::path& path) {
  const std::string text = read_text(path);
  if (!text.starts_with(magic)) {
    throw RecordError(path, "is not a checkpoint that this version can read");
  }
  const std::size_t body = text.size() - std::min(text.size(), checksum_line({}).size());
  if (text.substr(body) != checksum_line(text.substr(0, body))) {
    throw RecordError(path, "is damaged or cut short (its checksum does not fit)");
  }
  try {
    return parse(std::string_view(text).substr(0, body).substr(magic.size()));
  } catch (const std::exception& error) {
    throw RecordError(path, error.what());
  }
}

}  // namespace stokesbook
