// Tests that checkpoints are exact, and that incomplete or damaged ones are refused.

#include "record/checkpoint.hpp"

#include <bit>
#include <limits>

#include <boost/test/unit_test.hpp>

#include "folder.hpp"
#include "record/atomic_file.hpp"
#include "text/fingerprint.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

SavedRun sample() {
  using limits = std::numeric_limits<double>;
  Eigen::VectorXd state(8);
  state << 0.1, -1.0 / 3.0, limits::min(), limits::denorm_min(), limits::max(), -0.0,
      limits::infinity(), 1.0 + limits::epsilon();
  return {fingerprint("scene"),
          fingerprint("program"),
          {{"trajectory.csv", 123456789012}, {"steps.csv", 0}},
          {0.0, 0.1, 0.2},
          {0.3, 42, state, {{"previous_dt", Eigen::VectorXd::Constant(1, 0.1)}, {"empty", {}}}}};
}

bool same_bits(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return std::ranges::equal(a, b, {}, bits, bits);
}

/// Truncates a checkpoint after each stride of bytes, and damages the byte there.
void check_damage(std::size_t stride) {
  const Folder folder;
  const std::string whole = to_text(sample());
  for (std::size_t k = 0; k < whole.size(); k += stride) {
    write(folder.at("checkpoint"), whole.substr(0, k));
    BOOST_CHECK_THROW(read_saved_run(folder.at("checkpoint")), RecordError);
    std::string damaged = whole;
    damaged[k] = static_cast<char>(damaged[k] ^ 1);
    write(folder.at("checkpoint"), damaged);
    BOOST_CHECK_THROW(read_saved_run(folder.at("checkpoint")), RecordError);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(checkpoint)

BOOST_AUTO_TEST_CASE(exact_round_trip) {
  const Folder folder;
  const SavedRun written = sample();
  write(folder.at("checkpoint"), to_text(written));
  const SavedRun read = read_saved_run(folder.at("checkpoint"));
  BOOST_TEST(read.scene == written.scene);
  BOOST_TEST(read.program == written.program);
  BOOST_TEST((read.table_sizes == written.table_sizes));
  BOOST_TEST(read.frame_times == written.frame_times);
  BOOST_TEST(read.checkpoint.t == written.checkpoint.t);
  BOOST_TEST(read.checkpoint.step == written.checkpoint.step);
  BOOST_TEST(same_bits(read.checkpoint.state, written.checkpoint.state));
  BOOST_TEST(read.checkpoint.history.size() == 2u);
  BOOST_TEST(read.checkpoint.history.at("previous_dt")[0] == 0.1);
  BOOST_TEST(read.checkpoint.history.at("empty").size() == 0);
}

BOOST_AUTO_TEST_CASE(truncations_and_damaged_bytes_are_refused) {
  check_damage(7);
}

BOOST_AUTO_TEST_CASE(every_truncation_and_damaged_byte_is_refused,
                     *boost::unit_test::label("full")) {
  check_damage(1);
}

BOOST_AUTO_TEST_CASE(messages_name_file_and_reason) {
  const Folder folder;
  const std::filesystem::path path = folder.at("checkpoint");
  const auto says = [&](const std::string& reason) {
    return [=](const RecordError& error) { return error.what() == path.string() + ": " + reason; };
  };
  BOOST_CHECK_EXCEPTION(read_saved_run(path), RecordError,
                        says("reading failed: No such file or directory"));
  write(path, "t,body\n");
  BOOST_CHECK_EXCEPTION(read_saved_run(path), RecordError,
                        says("is not a checkpoint that this version can read"));
  const std::string whole = to_text(sample());
  write(path, whole.substr(0, whole.size() - 30));
  BOOST_CHECK_EXCEPTION(read_saved_run(path), RecordError,
                        says("is damaged or cut short (its checksum does not fit)"));
}

BOOST_AUTO_TEST_CASE(unknown_contents_are_refused) {
  const Folder folder;
  const std::string body =
      "stokesbook checkpoint 7\n{\"scene\":\"0\",\"program\":\"0\",\"t\":0.5,\"step\":-1}\n";
  write(folder.at("checkpoint"), body + "checksum " + fingerprint(body) + '\n');
  BOOST_CHECK_EXCEPTION(
      read_saved_run(folder.at("checkpoint")), RecordError, [](const RecordError& error) {
        return std::string(error.what()).ends_with("checkpoint: '-1' is not a count");
      });
}

// A checksum that fits its text does not prove that numbers fit their counts.
BOOST_AUTO_TEST_CASE(lost_numbers_and_vectors_are_refused) {
  const Folder folder;
  const auto check = [&](const std::string& lost, const std::string& reason) {
    const std::string whole = to_text(sample());
    std::string body = whole.substr(0, whole.rfind("checksum"));
    BOOST_TEST_REQUIRE(body.find(lost) != std::string::npos);
    body.erase(body.find(lost), lost.size());
    write(folder.at("checkpoint"), body + "checksum " + fingerprint(body) + '\n');
    BOOST_CHECK_EXCEPTION(read_saved_run(folder.at("checkpoint")), RecordError,
                          [&](const RecordError& error) {
                            return std::string(error.what()).ends_with("checkpoint: has " + reason);
                          });
  };
  check(",0.2", "2 numbers where it states 3");
  check("\"empty\":[0],", "1 vectors where it states 2");
}

BOOST_AUTO_TEST_SUITE_END()
