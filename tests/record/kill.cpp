// Tests that a run which is killed, or meets a full disk, can be resumed with the same results.

#include <algorithm>
#include <chrono>
#include <csignal>
#include <random>
#include <thread>
#include <vector>

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "folder.hpp"
#include "record/atomic_file.hpp"
#include "record/checkpoint.hpp"
#include "sample_run.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

constexpr int last_step = 14;

/// Returns a folder in memory if there is one: on a disk, nearly all kills would hit a process that
/// waits for the disk.
std::filesystem::path fast_place() {
  const std::filesystem::path memory = "/dev/shm";
  return ::access(memory.c_str(), W_OK) == 0 ? memory : std::filesystem::temp_directory_path();
}

/// Starts a process that runs `work` and ends with the status that `work` returns.
template <class Work>
pid_t start_process(Work work) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(work());
  return child;
}

int wait_for(pid_t child) {
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

/// Runs `work` in a process that is killed after some time. Returns whether the process was killed
/// before the work was done.
template <class Work>
bool killed_after(double seconds, Work work) {
  const pid_t child = start_process(work);
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  ::kill(child, SIGKILL);
  return WIFSIGNALED(wait_for(child));
}

/// Returns the time that `work` takes in a folder of its own, seconds.
template <class Work>
double seconds_of(Work work) {
  using clock = std::chrono::steady_clock;
  const Folder folder(fast_place());
  const clock::time_point start = clock::now();
  work(folder.path());
  return std::chrono::duration<double>(clock::now() - start).count();
}

int run_sample(const std::filesystem::path& directory) {
  run_or_resume(directory, sample_contents(), last_step);
  return 0;
}

std::map<std::string, std::string> uninterrupted_run() {
  const Folder folder(fast_place());
  run_sample(folder.path());
  return read_all(folder.path());
}

/// Checks the files that a killed run leaves. Only the last record of a growing file may be
/// incomplete.
void check_files(const Folder& folder, const std::map<std::string, std::string>& expected) {
  for (const auto& [name, text] : read_all(folder.path())) {
    if (name.ends_with(".csv") || name.ends_with(".html")) {
      BOOST_TEST(expected.at(name).starts_with(text), name);
    }
    if (name.ends_with(".vtp") || name.ends_with(".vti")) {
      BOOST_TEST(text.ends_with("</VTKFile>\n"), name);
    }
    if (!name.ends_with(".pvd")) continue;
    for (std::size_t at = 0; (at = text.find("file=\"", at)) != std::string::npos; ++at) {
      const std::string file = text.substr(at + 6, text.find('"', at + 6) - at - 6);
      BOOST_TEST(std::filesystem::exists(folder.at(file)), file);
    }
  }
}

const std::string long_record = std::string(300'000, 'x') + '\n';

int write_long_records(const std::filesystem::path& directory) {
  write_atomically(directory / "a", "head\n", SafeFrom::kill);
  AppendFile file = AppendFile::reopen(directory / "a", 5);
  for (int k = 0; k < 20; ++k) {
    file.append(long_record);
    if (k % 2 == 0) file.sync();
  }
  return 0;
}

// The rows of one written time fill many pages of trajectory.csv.
constexpr std::size_t n_crowd = 400;
constexpr std::size_t steps_a_frame = 3;

RunContents crowd_contents() {
  RunContents contents = sample_contents();
  contents.outlines.bodies.assign(n_crowd, contents.outlines.bodies[0]);
  contents.outlines.walls.clear();
  contents.vtk = contents.svg = contents.fields = contents.contacts = false;
  return contents;
}

int run_crowd(const std::filesystem::path& directory) {
  RunDirectory run = RunDirectory::create(directory, crowd_contents(), ExistingRun::refuse);
  for (int k = 0; k < 20; ++k) {
    Frame frame{.t = k / 7.0, .bodies = {}, .walls = {}};
    frame.bodies.assign(n_crowd, sample_frame(k).bodies[0]);
    for (std::size_t j = 0; j < steps_a_frame; ++j) run.write_step({.t = frame.t});
    run.write_frame(frame);
    run.save({.t = frame.t, .step = k, .state = {}, .history = {}});
  }
  return 0;
}

/// Returns the complete records of a text, each of which ends with `end`.
std::string complete(const std::string& text, std::string_view end) {
  const std::size_t last = text.rfind(end);
  return last == std::string::npos ? std::string{} : text.substr(0, last + end.size());
}

/// Counts the complete rows of a table.
std::size_t rows_of(const std::filesystem::path& path) {
  const std::string text = complete(read(path), "\n");
  std::size_t rows = 0;
  std::ptrdiff_t columns = 0;
  for (std::size_t at = 0; at < text.size(); ++rows) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1);
    const std::ptrdiff_t commas = std::count(&text[at], &text[end], ',');
    if (at == 0) columns = commas;
    if (commas != columns) BOOST_TEST(commas == columns, path << ", row " << rows);
    at = end + 1;
  }
  return rows - 1;
}

/// Counts the complete frames of an animation.
std::size_t frames_of(const std::filesystem::path& path) {
  const std::string begin = "<script type=\"application/json\" class=\"frame\">";
  const std::string end = "</script>\n";
  const std::string text = complete(read(path), end);
  std::size_t frames = 0;
  for (std::size_t at = 0; (at = text.find(begin, at)) != std::string::npos; ++frames) {
    at += begin.size();
    const auto frame = nlohmann::json::parse(text.substr(at, text.find(end, at) - at));
    BOOST_TEST(frame.at(1).size() == n_crowd);
  }
  return frames;
}

/// Checks that files contain all that was saved, and at most the frame after it. Returns the number
/// of frames that were saved.
std::size_t check_crowd(const Folder& folder) {
  const bool begun = std::filesystem::exists(folder.at("checkpoint"));
  const std::size_t saved = begun ? read_saved_run(folder.at("checkpoint")).frame_times.size() : 0;
  const auto check = [&](const std::string& name, auto count, std::size_t a_frame) {
    if (!begun && !std::filesystem::exists(folder.at(name))) return;
    const std::size_t found = count(folder.at(name));
    BOOST_TEST(found >= saved * a_frame, name << ": " << found << ", saved " << saved);
    BOOST_TEST(found <= (saved + 1) * a_frame, name << ": " << found << ", saved " << saved);
  };
  check("trajectory.csv", rows_of, n_crowd);
  check("rheology.csv", rows_of, 1);
  check("steps.csv", rows_of, steps_a_frame);
  check("animation.html", frames_of, 1);
  return saved;
}

/// Kills a process that writes records of many pages: the kill may split a record. Reopening the
/// file cuts off the incomplete record.
void kill_records_of_many_pages(int times) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> moment(0.0, seconds_of(write_long_records));
  int split = 0;
  for (int trial = 0; trial < times || (split == 0 && trial < 1000); ++trial) {
    const Folder folder(fast_place());
    killed_after(moment(generator), [&] { return write_long_records(folder.path()); });
    if (!std::filesystem::exists(folder.at("a"))) continue;
    const std::string text = read(folder.at("a")), whole = complete(text, "\n");
    BOOST_TEST((whole.size() - 5) % long_record.size() == 0u);
    if (whole.size() < text.size()) ++split;
    AppendFile::reopen(folder.at("a"), whole.size());
    BOOST_TEST((read(folder.at("a")) == whole));
  }
  BOOST_TEST(split > 0);  // otherwise no kill came during a write
}

/// Checks the files and the age of the checkpoint after kills, for frames of many pages.
void kill_frames_of_many_pages(int times) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> moment(0.0, seconds_of(run_crowd));
  int under_way = 0;
  for (int trial = 0; trial < times || (under_way <= times / 5 && trial < 1000); ++trial) {
    const Folder folder(fast_place());
    const bool killed = killed_after(moment(generator), [&] { return run_crowd(folder.path()); });
    if (check_crowd(folder) > 0 && killed) ++under_way;
  }
  BOOST_TEST(under_way > times / 5);
}

void kill_sample_runs(int times) {
  const std::map<std::string, std::string> expected = uninterrupted_run();
  BOOST_TEST((uninterrupted_run() == expected));
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> moment(0.0, seconds_of(run_sample));
  int killed = 0;
  int resumed = 0;
  // A busy machine makes most moments too early or too late, so more trials may be necessary.
  const int wanted = times / 5;
  for (int trial = 0; trial < times || (std::min(killed, resumed) <= wanted && trial < 1000);
       ++trial) {
    const Folder folder(fast_place());
    if (killed_after(moment(generator), [&] { return run_sample(folder.path()); })) ++killed;
    check_files(folder, expected);
    if (run_or_resume(folder.path(), sample_contents(), last_step)) ++resumed;
    BOOST_TEST((read_all(folder.path()) == expected), "trial " << trial);
  }
  // The test requires that many kills came during the run.
  BOOST_TEST(killed > wanted);
  BOOST_TEST(resumed > wanted);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(interruptions)

BOOST_AUTO_TEST_CASE(killed_at_random_moments) {
  kill_records_of_many_pages(5);
  kill_frames_of_many_pages(5);
  kill_sample_runs(5);
}

BOOST_AUTO_TEST_CASE(killed_at_many_random_moments, *boost::unit_test::label("full")) {
  kill_records_of_many_pages(50);
  kill_frames_of_many_pages(50);
  kill_sample_runs(50);
}

/// A limit on the size of files simulates a disk that takes only a part of a record.
BOOST_AUTO_TEST_CASE(disk_full) {
  const std::map<std::string, std::string> expected = uninterrupted_run();
  const Folder folder;
  RunContents tables_only = sample_contents();
  tables_only.vtk = tables_only.svg = tables_only.html = tables_only.fields = false;
  const pid_t child = start_process([&] {
    const rlimit limit{1500, 1500};
    std::signal(SIGXFSZ, SIG_IGN);
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try {
      run_or_resume(folder.path(), tables_only, last_step);
    } catch (const RecordError& error) {
      write(folder.at("message"), error.what());
      return 3;
    }
    return 0;
  });
  const int status = wait_for(child);
  BOOST_TEST((WIFEXITED(status) && WEXITSTATUS(status) == 3));
  BOOST_TEST(read(folder.at("message")) ==
             folder.at("trajectory.csv").string() + ": writing failed: File too large");
  const std::string rows = read(folder.at("trajectory.csv"));
  BOOST_TEST(rows.back() == '\n');
  BOOST_TEST(expected.at("trajectory.csv").starts_with(rows));
  run_or_resume(folder.path(), tables_only, last_step);
  BOOST_TEST(read(folder.at("trajectory.csv")) == expected.at("trajectory.csv"));
}

BOOST_AUTO_TEST_SUITE_END()
