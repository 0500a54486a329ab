// Lets the waiting threads of a program sleep instead of spin: sets OpenMP's environment variables
// and starts the program again, before main() begins.
#include <array>
#include <cstdlib>

#include <limits.h>
#include <unistd.h>

namespace stokesbook {

namespace {

bool has_user_chosen() {
  // These variables belong to OpenMP itself, to GCC's library and to Clang's library.
  for (const char* name : {"OMP_WAIT_POLICY", "GOMP_SPINCOUNT", "KMP_BLOCKTIME"}) {
    if (std::getenv(name) != nullptr) return true;
  }
  return false;
}

// OpenMP's threads wait for each other at the end of every parallel loop. By default they wait in a
// loop that keeps their processors busy; if other processes need these processors as well, a run
// takes ten times as long. OpenMP reads the policy from the environment when a program is loaded,
// and has no function that changes the policy later: the program sets the variable and starts
// itself again, once. A policy that the user has set is left as it is. The benchmark measures the
// cost of this choice on a quiet machine and its gain on a busy one (page "Speed").
#ifdef __GLIBC__  // glibc passes the arguments of main() to constructors.
[[gnu::constructor]] void let_waiting_threads_sleep(int, char** arguments, char**) {
  std::array<char, PATH_MAX> program{};
  // If a call fails, the program continues, and its waiting threads spin. Threads of GCC's library
  // spin for some microseconds before they sleep, which suits quiet machines.
  if (has_user_chosen() || readlink("/proc/self/exe", program.data(), program.size() - 1) < 0 ||
      setenv("OMP_WAIT_POLICY", "passive", 1) != 0 || setenv("GOMP_SPINCOUNT", "10000", 1) != 0) {
    return;
  }
  execv(program.data(), arguments);
}
#endif

}  // namespace

}  // namespace stokesbook
