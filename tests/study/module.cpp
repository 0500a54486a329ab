// Defines the test module of the study harness.
#define BOOST_TEST_MODULE study
#include <boost/test/unit_test.hpp>
