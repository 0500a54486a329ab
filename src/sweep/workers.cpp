// Starts processes with fork() and exec(), and waits for them.
#include "sweep/workers.hpp"

#include <cerrno>
#include <csignal>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include "record/record_error.hpp"

namespace stokesbook {

namespace {

std::error_code last_error() {
  return {errno, std::generic_category()};
}

/// Replaces this process by another program. All calls are allowed between fork() and exec().
[[noreturn]] void become(char* const* arguments, int log, [[maybe_unused]] pid_t parent) {
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);  // the parent ended before prctl()
#endif
  ::dup2(log, STDOUT_FILENO);
  ::dup2(log, STDERR_FILENO);
  ::execv(arguments[0], arguments);
  ::_exit(127);
}

}  // namespace

void Workers::start(std::size_t task, const std::vector<std::string>& command,
                    const std::filesystem::path& log) {
  std::vector<std::string> words = command;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const int descriptor = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor < 0) throw RecordError(log, "opening", last_error());
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child == 0) become(arguments.data(), descriptor, parent);
  const std::error_code error = last_error();
  ::close(descriptor);
  if (child < 0) throw RecordError(command.front(), "starting", error);
  tasks_[child] = task;
}

WorkerEnd Workers::wait() {
  while (true) {
    int status = 0;
    const pid_t child = ::wait(&status);
    if (child < 0 && errno != EINTR) throw std::logic_error("no process is running");
    const auto found = tasks_.find(child);
    if (found == tasks_.end()) continue;
    const std::size_t task = found->second;
    tasks_.erase(found);
    if (WIFSIGNALED(status)) return {task, 0, WTERMSIG(status)};
    return {task, WEXITSTATUS(status), 0};
  }
}

}  // namespace stokesbook
