// Measures the cost and the gain of waiting threads that sleep, see src/cli/waiting_threads.cpp.
#include "waiting.hpp"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <vector>

#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "stopwatch.hpp"
#include "taylor_green.hpp"

namespace stokesbook {

namespace {

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// Starts processes that compute until this object is destroyed.
class BusyProcesses {
 public:
  explicit BusyProcesses(int count) {
    for (int k = 0; k < count; ++k) {
      const pid_t child = fork();
      if (child == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        for (std::atomic<unsigned> turns = 0;; ++turns) {
        }
      }
      if (child > 0) children_.push_back(child);
    }
  }
  BusyProcesses(const BusyProcesses&) = delete;
  BusyProcesses& operator=(const BusyProcesses&) = delete;
  ~BusyProcesses() {
    for (const pid_t child : children_) {
      kill(child, SIGKILL);
      waitpid(child, nullptr, 0);
    }
  }

 private:
  std::vector<pid_t> children_;
};

// Runs a command three times, and returns the times of the run with the least wall time. The
// command prints its wall and CPU seconds.
WorkTime least_of_three_runs(const std::string& command) {
  WorkTime least{};
  for (int k = 0; k < 3; ++k) {
    const std::unique_ptr<FILE, int (*)(FILE*)> output(popen(command.c_str(), "r"), pclose);
    WorkTime time{};
    if (!output || std::fscanf(output.get(), "%lf %lf", &time.wall, &time.cpu) != 2) {
      throw std::runtime_error("this command has printed no times: " + command);
    }
    if (k == 0 || time.wall < least.wall) least = time;
  }
  return least;
}

}  // namespace

WorkTime solve_often(int solves) {
  const double cpu = cpu_seconds();
  const double wall = seconds_of([&] { solve_taylor_green(solves); });
  return {wall, cpu_seconds() - cpu};
}

Table time_waiting(const std::string& program) {
  const std::string work = "'" + program + "' --solves 50";
  Table table{"Waiting threads, Taylor-Green start solved 50 times with two threads",
              {"busy processes beside", "own choice s", "own choice CPU s", "spinning s",
               "spinning CPU s", "own/spinning"},
              {},
              "  own choice: waiting threads sleep; spinning: OMP_WAIT_POLICY=active"};
  for (const int beside : {0, 2}) {
    const BusyProcesses busy(beside);
    const std::string environment =
        "env -u OMP_WAIT_POLICY -u GOMP_SPINCOUNT -u KMP_BLOCKTIME OMP_NUM_THREADS=2 ";
    const WorkTime own = least_of_three_runs(environment + work);
    const WorkTime spinning = least_of_three_runs(environment + "OMP_WAIT_POLICY=active " + work);
    table.rows.push_back({static_cast<double>(beside), own.wall, own.cpu, spinning.wall,
                          spinning.cpu, own.wall / spinning.wall});
  }
  return table;
}

}  // namespace stokesbook
