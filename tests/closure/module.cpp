// Defines the test module of the library closure.
#define BOOST_TEST_MODULE closure
#include <boost/test/unit_test.hpp>
