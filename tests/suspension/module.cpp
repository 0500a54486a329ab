// Defines the main function of the tests of the suspension library, which Boost.Test supplies.
#define BOOST_TEST_MODULE suspension
#include <boost/test/unit_test.hpp>
