// Tests numbers as text, fingerprints by the published values of FNV-1a, and reading whole files.

#include <cstdlib>
#include <filesystem>
#include <limits>

#include <boost/test/unit_test.hpp>

#include "text/fingerprint.hpp"
#include "text/number_text.hpp"
#include "text/text_file.hpp"

using namespace stokesbook;

BOOST_AUTO_TEST_SUITE(text_suite)

BOOST_AUTO_TEST_CASE(written_numbers_are_restored_exactly) {
  using limits = std::numeric_limits<double>;
  for (const double x : {0.1, -1.0 / 3.0, limits::max(), limits::min(), 1.0 + limits::epsilon()}) {
    BOOST_TEST(std::strtod(exact_number(x).c_str(), nullptr) == x);
  }
}

BOOST_AUTO_TEST_CASE(short_numbers_are_rounded) {
  BOOST_TEST(short_number(0.012345) == "0.0123");
  BOOST_TEST(short_number(1.25e-10) == "1.25e-10");
  BOOST_TEST(short_number(2.0 / 3.0, 6) == "0.666667");
  BOOST_TEST(short_number(-0.0) == "0");
  BOOST_TEST(short_number(std::numeric_limits<double>::infinity()) == "inf");
}

BOOST_AUTO_TEST_CASE(numbers_fill_their_text) {
  BOOST_TEST((parse_number<double>("1.5e-3") == std::optional(1.5e-3)));
  BOOST_TEST((parse_number<int>("-12") == std::optional(-12)));
  for (const char* text : {"", " 1", "1 ", "1x", "x"}) {
    BOOST_TEST(!parse_number<double>(text).has_value(), text);
  }
  BOOST_TEST(padded_number(7, 4) == "0007");
  BOOST_TEST(padded_number(123456, 4) == "123456");
}

/// The expected values are the test vectors of the authors of FNV-1a.
BOOST_AUTO_TEST_CASE(fingerprints) {
  BOOST_TEST(fingerprint("") == "cbf29ce484222325");
  BOOST_TEST(fingerprint("a") == "af63dc4c8601ec8c");
  BOOST_TEST(fingerprint("foobar") == "85944171f73967e8");
}

BOOST_AUTO_TEST_CASE(a_file_that_cannot_be_read_has_no_text) {
  BOOST_TEST(!read_text_file(std::filesystem::temp_directory_path()).has_value());
  BOOST_TEST(!read_text_file("no such file").has_value());
}

BOOST_AUTO_TEST_SUITE_END()
