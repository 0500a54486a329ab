// Defines the test module of the library periodic.
#define BOOST_TEST_MODULE periodic
#include <boost/test/unit_test.hpp>
