// Defines the main function of the tests of the text library, which Boost.Test supplies.
#define BOOST_TEST_MODULE text
#include <boost/test/unit_test.hpp>
