// Defines the main function of the tests of the scene library, which Boost.Test supplies.
#define BOOST_TEST_MODULE scene
#include <boost/test/unit_test.hpp>
