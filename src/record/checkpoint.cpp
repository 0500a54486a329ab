// Writes and reads the file `checkpoint` of a run: names, counts and hexadecimal floats as words of
// a text, with a checksum at the end.
#include "record/checkpoint.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <span>
#include <stdexcept>

#include "record/atomic_file.hpp"
#include "record/record_error.hpp"
#include "text/fingerprint.hpp"

namespace stokesbook {

namespace {

// The version number must rise with every change of the contents, including those of the history.
const std::string magic = "stokesbook checkpoint 3\n";

std::string checksum_line(std::string_view body) {
  return "checksum " + fingerprint(body) + '\n';
}

void append_number_line(std::string& text, double x) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.begin(), buffer.end(), x, std::chars_format::hex);
  text.append(buffer.begin(), end.ptr) += '\n';
}

void append_numbers(std::string& text, const std::string& name, std::span<const double> numbers) {
  text += name + ' ' + std::to_string(numbers.size()) + '\n';
  for (const double x : numbers) append_number_line(text, x);
}

void append_numbers(std::string& text, const std::string& name, const Eigen::VectorXd& numbers) {
  const auto size = static_cast<std::size_t>(numbers.size());
  append_numbers(text, name, std::span(numbers.data(), size));
}

/// Reads words and numbers from a text, one after another.
class WordReader {
 public:
  explicit WordReader(std::string_view text) : rest_(text) {}

  std::string word() {
    const std::string_view found = rest_.substr(0, rest_.find_first_of(" \n"));
    rest_.remove_prefix(std::min(found.size() + 1, rest_.size()));
    return std::string(found);
  }

  template <std::integral Integer>
  Integer integer() {
    Integer value{};
    const std::string text = word();
    check(text, std::from_chars(text.data(), text.data() + text.size(), value));
    return value;
  }

  double number() {
    double value{};
    const std::string text = word();
    const char* const end = text.data() + text.size();
    check(text, std::from_chars(text.data(), end, value, std::chars_format::hex));
    return value;
  }

  /// Reads a count n, then n numbers.
  std::vector<double> numbers() {
    std::vector<double> values;
    for (auto left = integer<std::size_t>(); left > 0; --left) values.push_back(number());
    return values;
  }

  Eigen::VectorXd vector() {
    const std::vector<double> values = numbers();
    return Eigen::VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size()));
  }

  /// Skips a word that the format prescribes here; any other word is an error.
  void expect(const std::string& expected) {
    const std::string found = word();
    if (found != expected) {
      throw std::invalid_argument("'" + expected + "' expected, '" + found + "' found");
    }
  }

 private:
  static void check(const std::string& text, std::from_chars_result result) {
    if (result.ec != std::errc{} || result.ptr != text.data() + text.size()) {
      throw std::invalid_argument("'" + text + "' is not a number");
    }
  }

  std::string_view rest_;
};

SavedRun parse(std::string_view text) {
  WordReader reader(text);
  SavedRun saved;
  reader.expect("scene");
  saved.scene = reader.word();
  reader.expect("program");
  saved.program = reader.word();
  reader.expect("t");
  saved.checkpoint.t = reader.number();
  reader.expect("step");
  saved.checkpoint.step = reader.integer<long long>();
  reader.expect("tables");
  for (auto left = reader.integer<std::size_t>(); left > 0; --left) {
    const std::string name = reader.word();
    saved.table_sizes[name] = reader.integer<std::uintmax_t>();
  }
  reader.expect("frames");
  saved.frame_times = reader.numbers();
  reader.expect("state");
  saved.checkpoint.state = reader.vector();
  reader.expect("history");
  for (auto left = reader.integer<std::size_t>(); left > 0; --left) {
    const std::string name = reader.word();
    saved.checkpoint.history[name] = reader.vector();
  }
  return saved;
}

void check_history_names(const Checkpoint& checkpoint) {
  for (const auto& [name, values] : checkpoint.history) {
    if (name.empty() || name.find_first_of(" \n") != std::string::npos) {
      throw std::invalid_argument("checkpoint: the history's name '" + name + "' is not one word");
    }
  }
}

}  // namespace

std::string to_text(const SavedRun& saved) {
  const Checkpoint& checkpoint = saved.checkpoint;
  check_history_names(checkpoint);
  std::string text = magic + "scene " + saved.scene + "\nprogram " + saved.program + "\nt ";
  append_number_line(text, checkpoint.t);
  text += "step " + std::to_string(checkpoint.step) + '\n';
  text += "tables " + std::to_string(saved.table_sizes.size()) + '\n';
  for (const auto& [name, size] : saved.table_sizes) {
    text += name + ' ' + std::to_string(size) + '\n';
  }
  append_numbers(text, "frames", saved.frame_times);
  append_numbers(text, "state", checkpoint.state);
  text += "history " + std::to_string(checkpoint.history.size()) + '\n';
  for (const auto& [name, numbers] : checkpoint.history) append_numbers(text, name, numbers);
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
    return parse(std::string_view(text).substr(magic.size()));
  } catch (const std::invalid_argument& error) {
    throw RecordError(path, error.what());
  }
}

}  // namespace stokesbook
