// Defines the main function of the tests of the record library, which Boost.Test supplies.
#define BOOST_TEST_MODULE record
#include <boost/test/unit_test.hpp>
