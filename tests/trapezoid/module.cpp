// Defines the test module of the library trapezoid.
#define BOOST_TEST_MODULE trapezoid
#include <boost/test/unit_test.hpp>
