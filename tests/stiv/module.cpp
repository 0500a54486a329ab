// Defines the test module of the library stiv.
#define BOOST_TEST_MODULE stiv
#include <boost/test/unit_test.hpp>
