// Lets the waiting threads of a program sleep instead of spin, before main() begins.
//
// OpenMP's threads wait for each other at the end of every parallel loop. By default they wait in a
// loop that keeps their processors busy; where other processes need these processors as well, a run
// takes ten times as long. OpenMP reads the policy from the environment when a program is loaded,
// and has no function that changes the policy later: the program sets the variable and starts
// itself again, once. A policy that the user has set is left as it is. The benchmark measures what
// the choice costs on a quiet machine and what it saves on a busy one (page "Speed").
#include <array>
#include <cstdlib>

#include <limits.h>
#include <unistd.h>

namespace stokesbook {

namespace {

bool has_user_chosen() {
  // The variables of OpenMP itself, of GCC's library and of Clang's library.
  for (const char* name : {"OMP_WAIT_POLICY", "GOMP_SPINCOUNT", "KMP_BLOCKTIME"}) {
    if (std::getenv(name) != nullptr) return true;
  }
  return false;
}

#ifdef __GLIBC__  // It passes the arguments of main() to constructors.
[[gnu::constructor]] void let_waiting_threads_sleep(int, char** arguments, char**) {
  std::array<char, PATH_MAX> program{};
  // A call that fails leaves the program as it is: it works, and its threads spin.
  // The short spin of GCC's library before they sleep, some microseconds, serves quiet machines.
  if (has_user_chosen() || readlink("/proc/self/exe", program.data(), program.size() - 1) < 0 ||
      setenv("OMP_WAIT_POLICY", "passive", 1) != 0 || setenv("GOMP_SPINCOUNT", "10000", 1) != 0) {
    return;
  }
  execv(program.data(), arguments);
}
#endif

}  // namespace

}  // namespace stokesbook
