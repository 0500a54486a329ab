// Defines the main function of the tests of the statistics library, which Boost.Test supplies.
#define BOOST_TEST_MODULE statistics
#include <boost/test/unit_test.hpp>
