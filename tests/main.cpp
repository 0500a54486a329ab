// Defines the main function of all test programs, which Boost.Test supplies.
#define BOOST_TEST_MODULE stokesbook
#include <boost/test/unit_test.hpp>
