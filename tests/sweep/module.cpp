// Defines the main function of the tests of the sweep library, which Boost.Test supplies.
#define BOOST_TEST_MODULE sweep
#include <boost/test/unit_test.hpp>
