// Defines the test module of the library near_singular.
#define BOOST_TEST_MODULE near_singular
#include <boost/test/unit_test.hpp>
