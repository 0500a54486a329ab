// Tests files that grow by records, and files that are replaced as a whole.

#include <boost/test/unit_test.hpp>

#include "folder.hpp"
#include "record/atomic_file.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

BOOST_AUTO_TEST_SUITE(files)

BOOST_AUTO_TEST_CASE(records_follow_each_other) {
  const Folder folder;
  AppendFile file = AppendFile::create(folder.at("a"));
  file.append("one\n");
  file.append("");
  file.append("two\n");
  file.sync();
  BOOST_TEST(file.size() == 8u);
  BOOST_TEST(read(folder.at("a")) == "one\ntwo\n");
}

BOOST_AUTO_TEST_CASE(reopening_cuts_back) {
  const Folder folder;
  write(folder.at("a"), "one\ntwo\nthr");
  AppendFile file = AppendFile::reopen(folder.at("a"), 4);
  BOOST_TEST(read(folder.at("a")) == "one\n");
  file.append("2\n");
  file.flush();
  BOOST_TEST(read(folder.at("a")) == "one\n2\n");
}

BOOST_AUTO_TEST_CASE(a_file_too_short_is_not_reopened) {
  const Folder folder;
  write(folder.at("a"), "one");
  BOOST_CHECK_EXCEPTION(
      AppendFile::reopen(folder.at("a"), 4), RecordError, [&](const RecordError& error) {
        return error.what() == folder.at("a").string() + ": has 3 bytes, should have at least 4";
      });
}

BOOST_AUTO_TEST_CASE(an_existing_file_is_not_created) {
  const Folder folder;
  write(folder.at("a"), "mine");
  BOOST_CHECK_THROW(AppendFile::create(folder.at("a")), RecordError);
  BOOST_TEST(read(folder.at("a")) == "mine");
}

BOOST_AUTO_TEST_CASE(a_full_disk_is_an_error) {
  AppendFile file = AppendFile::reopen("/dev/full", 0);
  file.append("a row\n");
  BOOST_CHECK_EXCEPTION(file.flush(), RecordError, [](const RecordError& error) {
    return std::string(error.what()) == "/dev/full: writing failed: No space left on device";
  });
}

BOOST_AUTO_TEST_CASE(records_are_written_together) {
  const Folder folder;
  write(folder.at("a"), "head\nleft by a ki");
  {
    AppendFile file = AppendFile::reopen(folder.at("a"), 5);
    std::string whole = "head\n";
    BOOST_TEST(read(folder.at("a")) == whole);
    std::string many_pages(100'001, 'x');
    many_pages.back() = '\n';
    for (int k = 0; k < 5; ++k) {
      const std::string before = whole;
      for (const std::string& record : {std::to_string(k) + "\n", many_pages}) {
        file.append(record);
        whole += record;
      }
      BOOST_TEST((read(folder.at("a")) == before));
      BOOST_TEST(file.size() == whole.size());
      k % 2 == 0 ? file.flush() : file.sync();
      BOOST_TEST((read(folder.at("a")) == whole));
      BOOST_TEST(file.size() == whole.size());
    }
    file.append("last\n");
    AppendFile moved = std::move(file);
    moved.append("of all\n");
  }
  const std::string text = read(folder.at("a"));
  BOOST_TEST(text.size() == 5u + 5u * 100'003u + 12u);
  BOOST_TEST(text.ends_with("x\nlast\nof all\n"));
}

BOOST_AUTO_TEST_CASE(names_of_partial_files) {
  BOOST_TEST(without_partial("a.csv.partial") == "a.csv");
  BOOST_TEST(without_partial("a.partial.partial") == "a");
  BOOST_TEST(without_partial("a.partial.csv") == "a.partial.csv");
}

BOOST_AUTO_TEST_CASE(replacing_leaves_no_other_file) {
  const Folder folder;
  for (const SafeFrom danger : {SafeFrom::kill, SafeFrom::power_cut}) {
    write_atomically(folder.at("a"), "first", danger);
    write_atomically(folder.at("a"), "second", danger);
    BOOST_TEST((read_all(folder.path()) == std::map<std::string, std::string>{{"a", "second"}}));
  }
}

BOOST_AUTO_TEST_CASE(what_a_kill_left_is_replaced) {
  const Folder folder;
  write(folder.at("a.partial"), "half of a fil");
  write_atomically(folder.at("a"), "whole", SafeFrom::kill);
  BOOST_TEST((read_all(folder.path()) == std::map<std::string, std::string>{{"a", "whole"}}));
}

BOOST_AUTO_TEST_CASE(a_file_that_cannot_be_replaced_stays) {
  const Folder folder;
  write(folder.at("a"), "old");
  std::filesystem::create_directories(folder.at("a.partial") / "in the way");
  BOOST_CHECK_THROW(write_atomically(folder.at("a"), "new", SafeFrom::kill), RecordError);
  BOOST_TEST(read(folder.at("a")) == "old");
}

BOOST_AUTO_TEST_CASE(reading) {
  const Folder folder;
  write(folder.at("a"), std::string("a\0b\n", 4));
  BOOST_TEST(read_text(folder.at("a")) == std::string("a\0b\n", 4));
  BOOST_CHECK_THROW(read_text(folder.at("missing")), RecordError);
  BOOST_CHECK_THROW(read_text(folder.path()), RecordError);
}

BOOST_AUTO_TEST_SUITE_END()
