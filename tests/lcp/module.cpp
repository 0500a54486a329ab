// Defines the test module of the library lcp.
#define BOOST_TEST_MODULE lcp
#include <boost/test/unit_test.hpp>
