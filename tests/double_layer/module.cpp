// Defines the test module of the library double_layer.
#define BOOST_TEST_MODULE double_layer
#include <boost/test/unit_test.hpp>
