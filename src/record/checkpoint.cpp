// Writes and reads the file `checkpoint` of a run: names, counts and hexadecimal floats as words of
// a text, with a checksum at the end.
#include "record/checkpoint.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "record/atomic_file.hpp"
#include "text/fingerprint.hpp"
#include "text/number_text.hpp"
#include "text/word_list.hpp"

namespace stokesbook {

namespace {

// The version number must rise with every change of the contents, including those of the history.
const std::string magic = "stokesbook checkpoint 3\n";

std::string checksum_line(std::string_view body) {
  return "checksum " + fingerprint(body) + '\n';
}

std::string count_line(const std::string& name, auto count) {
  return name + ' ' + std::to_string(count) + '\n';
}

std::string number_line(double x) {
  return number_text(x, std::chars_format::hex) + '\n';
}

std::string number_lines(const std::string& name, const auto& numbers) {
  return count_line(name, numbers.size()) + joined(numbers, "", number_line);
}

/// Reads words and numbers from a text, one after another.
class WordReader {
 public:
  explicit WordReader(std::string_view text) : rest_(text) {}

  /// Reads a word, which may be empty, up to a blank or the end of the line.
  std::string word() {
    const std::string_view found = rest_.substr(0, rest_.find_first_of(" \n"));
    rest_.remove_prefix(std::min(found.size() + 1, rest_.size()));
    return std::string(found);
  }

  /// Skips a word that the format prescribes here; any other word is an error.
  WordReader& after(const std::string& expected) {
    const std::string found = word();
    if (found == expected) return *this;
    throw std::invalid_argument("'" + expected + "' expected, '" + found + "' found");
  }

  /// Reads a number; floating-point numbers have a format.
  template <class Number>
  Number number(auto... format) {
    const std::string text = word();
    if (const auto value = parse_number<Number>(text, format...)) return *value;
    throw std::invalid_argument("'" + text + "' is not a number");
  }

  std::size_t count() { return number<std::size_t>(); }

  double real() { return number<double>(std::chars_format::hex); }

  /// Reads a count n, then n numbers.
  std::vector<double> reals() {
    std::vector<double> values;
    for (std::size_t left = count(); left > 0; --left) values.push_back(real());
    return values;
  }

  Eigen::VectorXd vector() {
    const std::vector<double> values = reals();
    return Eigen::VectorXd::Map(values.data(), std::ssize(values));
  }

 private:
  std::string_view rest_;
};

SavedRun parse(std::string_view text) {
  WordReader reader(text);
  SavedRun saved;
  saved.scene = reader.after("scene").word();
  saved.program = reader.after("program").word();
  saved.checkpoint.t = reader.after("t").real();
  saved.checkpoint.step = reader.after("step").number<long long>();
  for (std::size_t left = reader.after("tables").count(); left > 0; --left) {
    const std::string name = reader.word();
    saved.table_sizes[name] = reader.number<std::uintmax_t>();
  }
  saved.frame_times = reader.after("frames").reals();
  saved.checkpoint.state = reader.after("state").vector();
  for (std::size_t left = reader.after("history").count(); left > 0; --left) {
    const std::string name = reader.word();
    saved.checkpoint.history[name] = reader.vector();
  }
  return saved;
}

}  // namespace

std::string to_text(const SavedRun& saved) {
  const auto& [t, step, state, history] = saved.checkpoint;
  std::string text = magic + "scene " + saved.scene + "\nprogram " + saved.program + "\nt " +
                     number_line(t) + count_line("step", step) +
                     count_line("tables", saved.table_sizes.size());
  for (const auto& [name, size] : saved.table_sizes) text += count_line(name, size);
  text += number_lines("frames", saved.frame_times) + number_lines("state", state) +
          count_line("history", history.size());
  for (const auto& [name, numbers] : history) {
    if (name.empty() || name.find_first_of(" \n") != std::string::npos) {
      throw std::invalid_argument("checkpoint: the history's name '" + name + "' is not one word");
    }
    text += number_lines(name, numbers);
  }
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
