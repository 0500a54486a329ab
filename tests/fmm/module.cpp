// Defines the test module of the library fmm.
#define BOOST_TEST_MODULE fmm
#include <boost/test/unit_test.hpp>
