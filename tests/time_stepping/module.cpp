// Defines the test module of the library time_stepping.
#define BOOST_TEST_MODULE time_stepping
#include <boost/test/unit_test.hpp>
