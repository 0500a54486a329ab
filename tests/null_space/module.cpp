// Defines the test module of the library null_space.
#define BOOST_TEST_MODULE null_space
#include <boost/test/unit_test.hpp>
