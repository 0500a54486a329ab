// Tests folders of sweeps and tasks, and their locks.

#include "record/atomic_file.hpp"
#include "record/file_lock.hpp"
#include "sweep_files.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

BOOST_AUTO_TEST_SUITE(folders)

BOOST_AUTO_TEST_CASE(names_sort_as_numbers) {
  BOOST_TEST(TaskFolder::name(7) == "runs/0007");
  BOOST_TEST(TaskFolder::name(9999) == "runs/9999");
  BOOST_TEST(TaskFolder::name(12345) == "runs/12345");
}

BOOST_AUTO_TEST_CASE(states) {
  const Folder folder;
  const TaskFolder task(folder.path(), 3);
  BOOST_CHECK(task.state() == TaskState::unfinished);
  BOOST_TEST(task.log() == folder.path() / "runs/0003/log.txt");
  make_folder(task.path());
  folder.write("runs/0003/failure.txt", "no convergence");
  BOOST_CHECK(task.state() == TaskState::failed);
  std::filesystem::remove(task.failure());
  BOOST_CHECK(task.state() == TaskState::unfinished);
  folder.write("runs/0003/run.json", "{\"exit_status\": null}");
  BOOST_CHECK(task.state() == TaskState::unfinished);
  folder.write("runs/0003/run.json", "{\"exit_status\": 2}");
  BOOST_CHECK(task.state() == TaskState::unfinished);
  folder.write("runs/0003/run.json", "{\"exit_status\": 0}");
  BOOST_CHECK(task.state() == TaskState::done);
  folder.write("runs/0003/run.json", "{\"exit_sta");
  BOOST_TEST(message_of<RecordError>(folder, [&] {
               task.state();
             }).starts_with("runs/0003/run.json: is damaged"));
}

BOOST_AUTO_TEST_CASE(one_holds_a_lock_at_a_time) {
  const Folder folder;
  const std::filesystem::path path = folder.path() / "lock";
  BOOST_TEST(!FileLock::is_taken(path));
  {
    const FileLock lock = FileLock::wait_for(path);
    BOOST_TEST(FileLock::is_taken(path));
    BOOST_TEST(!FileLock::is_taken(folder.path() / "other"));
  }
  BOOST_TEST(!FileLock::is_taken(path));
  const std::string message = message_of<RecordError>(
      folder, [&] { const FileLock lock = FileLock::wait_for(folder.path() / "no/lock"); });
  BOOST_TEST(message == "no/lock: opening failed: No such file or directory");
}

BOOST_AUTO_TEST_CASE(a_sweep_owns_its_folder) {
  const Folder folder;
  const std::string axis = "[[axes]]\nkey = 'time.dt'\nvalues = ";
  const Sweep sweep = folder.sweep(axis + "[0.5, 0.25]\n");
  const std::filesystem::path out = folder.path() / "out";
  const auto require = [&](const Sweep& asked, std::size_t task) {
    return message_of<RecordError>(folder, [&] { require_task(out, asked, task); });
  };
  const auto require_all = [&](const Sweep& asked) {
    return message_of<RecordError>(folder, [&] { require_sweep(out, asked); });
  };
  const std::string none = "out/tasks.csv: does not exist; run stokes sweep --plan first";
  BOOST_TEST(require(sweep, 0) == none);
  BOOST_TEST(require_all(sweep) == none);
  open_sweep(out, sweep);
  BOOST_TEST(folder.text_of("out/tasks.csv") == manifest(sweep));
  BOOST_TEST(std::filesystem::is_directory(out / "runs/0001"));
  open_sweep(out, sweep);
  BOOST_TEST(require(sweep, 0) == "no error");
  BOOST_TEST(require(sweep, 1) == "no error");
  BOOST_TEST(require_all(sweep) == "no error");

  const std::string other =
      "out/tasks.csv: belongs to another sweep, or the scene has changed: the sweep lacks task 1; "
      "choose another --out";
  const Sweep changed = folder.sweep(axis + "[0.5, 0.125]\n");
  BOOST_TEST(require(changed, 0) == "no error");  // the same task of another sweep is accepted
  BOOST_TEST(require(changed, 1) == other);
  BOOST_TEST(require_all(changed) == other);
  BOOST_TEST(require_all(folder.sweep(axis + "[0.5]\n")) == other);
  const auto open = [&] { open_sweep(out, changed); };
  BOOST_TEST(message_of<RecordError>(folder, open) == other);
  BOOST_TEST(folder.text_of("out/tasks.csv") == manifest(sweep));
}

BOOST_AUTO_TEST_CASE(a_sweep_takes_further_values_and_seeds) {
  const Folder folder;
  folder.add_fill();
  const auto sweep_of = [&](const std::string& seeds, const std::string& values) {
    return folder.sweep("seeds = " + seeds + "\n[[axes]]\nkey = 'time.dt'\nvalues = " + values +
                        "\n");
  };
  const std::filesystem::path out = folder.path() / "out";
  const auto numbers_of = [](const std::vector<Task>& tasks) {
    std::vector<std::size_t> numbers;
    for (const Task& task : tasks) numbers.push_back(task.number);
    return numbers;
  };
  open_sweep(out, sweep_of("[3, 4]", "[0.5, 0.25]"));
  const std::string before = folder.text_of("out/tasks.csv");
  const Sweep grown = sweep_of("[2, 3, 4]", "[1.0, 0.25, 0.5]");
  const std::string lacking =
      "out/tasks.csv: lacks tasks of the sweep; run stokes sweep --plan first";
  BOOST_TEST(message_of<RecordError>(folder, [&] { require_sweep(out, grown); }) == lacking);
  BOOST_TEST(message_of<RecordError>(folder, [&] { require_task(out, grown, 4); }) == lacking);
  const std::vector<std::size_t> expected{4, 5, 6, 7, 2, 3, 8, 0, 1};
  BOOST_TEST(numbers_of(open_sweep(out, grown)) == expected, boost::test_tools::per_element());
  BOOST_TEST(numbers_of(require_sweep(out, grown)) == expected, boost::test_tools::per_element());
  BOOST_TEST(folder.text_of("out/tasks.csv").starts_with(before));
  BOOST_TEST(std::filesystem::is_directory(out / "runs/0008"));
  const std::vector<std::string> last{"time.dt=0.5", "seed=2"};
  BOOST_TEST(require_task(out, grown, 8).overrides() == last, boost::test_tools::per_element());
  BOOST_TEST(message_of<RecordError>(folder, [&] {
               open_sweep(out, sweep_of("[2, 3]", "[1.0, 0.25, 0.5]"));
             }).find("the sweep lacks task ") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
