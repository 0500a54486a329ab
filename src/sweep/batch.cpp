// Writes shell commands that run the tasks of a sweep with Slurm or GNU parallel.
#include "sweep/batch.hpp"

namespace stokesbook {

namespace {

std::string shell_command(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += ' ';
    text += shell_quoted(word);
  }
  return text;
}

}  // namespace

std::string shell_quoted(std::string_view word) {
  constexpr std::string_view harmless =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+./=:,@%";
  if (!word.empty() && word.find_first_not_of(harmless) == std::string_view::npos) {
    return std::string(word);
  }
  std::string quoted = "'";
  for (const char letter : word) quoted += letter == '\'' ? "'\\''" : std::string(1, letter);
  return quoted + "'";
}

std::string in_slurm(std::string_view path) {
  std::string text;
  for (const char letter : path) text += letter == '%' ? "%%" : std::string(1, letter);
  return text;
}

std::string batch_commands(const Batch& batch) {
  const std::string last = std::to_string(batch.tasks - 1);
  const std::string task = shell_command(batch.task);
  return "# Slurm: one job per task; submit again to run the tasks that are not done\n"
         "sbatch --array=0-" +
         last + " --cpus-per-task=" + std::to_string(batch.threads) +
         " --requeue --open-mode=append --output=" + shell_quoted(batch.output) +
         " --wrap=" + shell_quoted(task + " $SLURM_ARRAY_TASK_ID") +
         "\n"
         "# GNU parallel: one task per processor; --sshlogin adds machines with the same files\n"
         "seq 0 " +
         last + " | parallel --quote " + task +
         " {}\n"
         "# when all have ended: the table\n" +
         shell_command(batch.collect) + "\n";
}

}  // namespace stokesbook
