// Defines the main function of all test programs. Boost.Test would define it in a source that sets
// BOOST_TEST_MODULE first, which a source with a precompiled header cannot do.
#include <boost/test/unit_test.hpp>

namespace {

bool name_tests() {
  boost::unit_test::framework::master_test_suite().p_name.value = "stokesbook";
  return true;
}

}  // namespace

int main(int argc, char* argv[]) {
  return boost::unit_test::unit_test_main(&name_tests, argc, argv);
}
