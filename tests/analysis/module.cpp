// Defines the main function of the tests of the analysis library, which Boost.Test supplies.
#define BOOST_TEST_MODULE analysis
#include <boost/test/unit_test.hpp>
