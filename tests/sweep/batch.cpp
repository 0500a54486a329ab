// Tests the commands for Slurm and GNU parallel, and the run by the latter: shells must take all
// words unchanged, and only a task that was killed is tried again.

#include "sweep/batch.hpp"

#include <array>
#include <csignal>
#include <cstdio>
#include <map>
#include <memory>
#include <numeric>
#include <vector>

#include "record/atomic_file.hpp"
#include "sweep/sweep_folder.hpp"
#include "sweep_files.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
  std::string text;
  for (int letter = 0; (letter = std::fgetc(pipe.get())) != EOF;) text += static_cast<char>(letter);
  return text;
}

/// Returns a batch whose program is a shell script; $task is the number of its task. Its paths have
/// all characters that a shell or an engine could replace.
Batch batch_of(const Folder& folder, std::size_t tasks, const std::string& script) {
  const std::string name = "it's {} {#} {= 1 =} 5%a $HOME `date` \\ \"x\"";
  const auto program =
      folder.write(name + "/program", "#!/bin/sh\nfor task; do :; done\n" + script + "\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  for (std::size_t k = 0; k < tasks; ++k) {
    make_folder(TaskFolder(folder.path() / name / "out", k).path());
  }
  return {program, program.parent_path() / "sweep.toml", program.parent_path() / "out", tasks, 3};
}

/// Runs all tasks, two at a time; returns the signals that killed the last try of each.
std::map<std::size_t, int> signals_of(const Batch& batch) {
  std::vector<std::size_t> tasks(batch.tasks);
  std::iota(tasks.begin(), tasks.end(), 0U);
  std::map<std::size_t, int> signals;
  run_in_parallel(batch, tasks, 2, [&](std::size_t task, int signal) {
    BOOST_TEST(signals.emplace(task, signal).second);
  });
  return signals;
}

std::string log_of(const Folder& folder, const Batch& batch, std::size_t task) {
  return folder.text_of(TaskFolder(batch.out, task).log());
}

}  // namespace

BOOST_AUTO_TEST_SUITE(batch)

BOOST_AUTO_TEST_CASE(quoted_words_pass_a_shell) {
  for (const std::string word :
       {"plain/path-1.toml", "", "two words", "it's", "$HOME `date` \\ \"x\"", "*", "a;b&c|d>e",
        "#", "~", "new\nline"}) {
    BOOST_TEST(output_of("printf %s " + shell_quoted(word)) == word);
    // The word is quoted twice, as in the text of a job.
    BOOST_TEST(output_of("sh -c " + shell_quoted("printf %s " + shell_quoted(word))) == word);
  }
  BOOST_TEST(shell_quoted("plain/path-1.toml") == "plain/path-1.toml");
}

BOOST_AUTO_TEST_CASE(commands_number_the_tasks_from_zero) {
  const std::string text = batch_commands({"/run it", "/a.toml", "/at_5%a%%", 20, 3});
  BOOST_TEST(text.find("sbatch --array=0-19 --cpus-per-task=3 --requeue ") != std::string::npos);
  BOOST_TEST(text.find(" --output=/at_5%%a%%%%/runs/slurm-%a.txt ") != std::string::npos);
  BOOST_TEST(text.find("\nseq 0 19 | env PARALLEL_SHELL=/bin/sh parallel ") != std::string::npos);
  BOOST_TEST(text.ends_with("\n'/run it' sweep /a.toml --out /at_5%a%% --collect\n"));
}

BOOST_AUTO_TEST_CASE(jobs_have_their_words_and_logs) {
  const Folder folder;
  const Batch batch = batch_of(folder, 12, "printf '<%s>' \"$@\"; echo wrong >&2");
  const auto check = [&](const std::string& before) {
    for (const std::size_t task : {0U, 9U, 11U}) {
      BOOST_TEST(log_of(folder, batch, task) ==
                 before + "<sweep><" + batch.sweep.string() + "><--out><" + batch.out.string() +
                     "><--threads><3><--quiet><--task><" + std::to_string(task) + ">wrong\n");
    }
  };
  BOOST_TEST(signals_of(batch).size() == 12U);
  check("");
  // The command of the plan is the same.
  const std::string first = log_of(folder, batch, 0);
  std::string text = batch_commands(batch);
  text = text.substr(text.find("\nseq "));
  BOOST_TEST(output_of(text.substr(0, text.find("\n#"))) == "");
  BOOST_TEST(log_of(folder, batch, 0) == first + first);
}

BOOST_AUTO_TEST_CASE(only_what_was_killed_is_tried_again) {
  const Folder folder;
  const Batch batch =
      batch_of(folder, 4,
               "echo try; case $task in 1) exit 3;; 2) kill -9 $$;;\n"
               "3) mkdir \"$(dirname \"$0\")/killed\" 2>/dev/null && kill -11 $$;; esac");
  BOOST_CHECK(
      (signals_of(batch) == std::map<std::size_t, int>{{0, 0}, {1, 0}, {2, SIGKILL}, {3, 0}}));
  const auto tries = [&](std::size_t task) {
    const std::string log = log_of(folder, batch, task);
    int count = 0;
    for (std::size_t at = 0; (at = log.find("try\n", at)) != std::string::npos; ++at) ++count;
    return count;
  };
  BOOST_TEST(tries(0) == 1);
  BOOST_TEST(tries(1) == 1);
  BOOST_TEST(tries(2) == most_tries);
  BOOST_TEST(tries(3) == 2);
}

BOOST_AUTO_TEST_CASE(tasks_run_side_by_side) {
  const Folder folder;
  // Each of the first two tasks waits for the other one.
  const Batch batch = batch_of(
      folder, 2,
      "cd \"$(dirname \"$0\")\"; touch $task; while ! test -e $((1 - task)); do sleep 0.01; done");
  BOOST_TEST(signals_of(batch).size() == 2U);
}

BOOST_AUTO_TEST_CASE(nothing_to_do_starts_nothing) {
  const Folder folder;
  const Batch batch = batch_of(folder, 1, "");
  run_in_parallel(batch, {}, 1, [](std::size_t, int) { BOOST_ERROR("no task has ended"); });
  BOOST_TEST(!std::filesystem::exists(TaskFolder(batch.out, 0).log()));
}

BOOST_AUTO_TEST_SUITE_END()
