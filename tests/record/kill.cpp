/// A run that is killed, or meets a full disk, goes on as if nothing had happened.

#include <algorithm>
#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include <boost/test/unit_test.hpp>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "folder.hpp"
#include "record/record_error.hpp"
#include "sample_run.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

constexpr int last_step = 14;

/// A place in memory, if there is one: on a disk nearly all kills would hit a process that waits
/// for it.
std::filesystem::path fast_place() {
  const std::filesystem::path memory = "/dev/shm";
  return ::access(memory.c_str(), W_OK) == 0 ? memory : std::filesystem::temp_directory_path();
}

/// Starts a process that does some work and then ends with the status that the work returns.
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

int run_sample(const std::filesystem::path& directory) {
  run_or_resume(directory, sample_contents(), last_step);
  return 0;
}

std::map<std::string, std::string> uninterrupted_run() {
  const Folder folder(fast_place());
  run_sample(folder.path());
  return read_all(folder.path());
}

/// Checks what a reader relies on while the run is not resumed.
void check_files(const Folder& folder) {
  for (const auto& [name, text] : read_all(folder.path())) {
    if (name.ends_with(".csv") && !text.empty()) BOOST_TEST(text.back() == '\n', name);
    if (name.ends_with(".html") && !text.empty()) BOOST_TEST(text.ends_with("</script>\n"), name);
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

}  // namespace

BOOST_AUTO_TEST_SUITE(interruptions)

BOOST_AUTO_TEST_CASE(killed_at_random_moments) {
  using clock = std::chrono::steady_clock;
  const std::map<std::string, std::string> expected = uninterrupted_run();
  const clock::time_point start = clock::now();
  BOOST_TEST((uninterrupted_run() == expected));
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> moment(
      0.0, std::chrono::duration<double>(clock::now() - start).count());
  int killed = 0;
  int resumed = 0;
  // Fifty times, and more where a busy machine makes most moments too early or too late.
  for (int trial = 0; trial < 50 || (std::min(killed, resumed) <= 10 && trial < 1000); ++trial) {
    const Folder folder(fast_place());
    const pid_t child = start_process([&] { return run_sample(folder.path()); });
    std::this_thread::sleep_for(std::chrono::duration<double>(moment(generator)));
    ::kill(child, SIGKILL);
    if (WIFSIGNALED(wait_for(child))) ++killed;
    check_files(folder);
    if (run_or_resume(folder.path(), sample_contents(), last_step)) ++resumed;
    BOOST_TEST((read_all(folder.path()) == expected), "trial " << trial);
  }
  // Most moments must have been moments of the run, or nothing has been tested.
  BOOST_TEST(killed > 10);
  BOOST_TEST(resumed > 10);
}

/// A limit on the size of files stands for a disk that takes a part of a record only.
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
