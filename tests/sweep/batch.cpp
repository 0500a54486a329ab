// Tests the commands for other engines: a shell must take their words unchanged.

#include "sweep/batch.hpp"

#include <array>
#include <cstdio>
#include <memory>

#include <boost/test/unit_test.hpp>

using namespace stokesbook;

namespace {

std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
  std::string text;
  for (int letter = 0; (letter = std::fgetc(pipe.get())) != EOF;) text += static_cast<char>(letter);
  return text;
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

BOOST_AUTO_TEST_CASE(paths_hold_no_pattern_of_slurm) {
  BOOST_TEST(in_slurm("/out/at_5%a%%/runs") == "/out/at_5%%a%%%%/runs");
}

BOOST_AUTO_TEST_CASE(commands_number_the_tasks_from_zero) {
  const std::string text = batch_commands({{"run it", "--task"}, {"collect"}, "out/%a.txt", 20, 3});
  BOOST_TEST(text.find("sbatch --array=0-19 --cpus-per-task=3 --requeue ") != std::string::npos);
  BOOST_TEST(text.find("\nseq 0 19 | parallel --quote 'run it' --task {}\n") != std::string::npos);
  BOOST_TEST(text.ends_with("\ncollect\n"));
}

BOOST_AUTO_TEST_SUITE_END()
