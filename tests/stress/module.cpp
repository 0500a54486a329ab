// Defines the test module of the library stress.
#define BOOST_TEST_MODULE stress
#include <boost/test/unit_test.hpp>
