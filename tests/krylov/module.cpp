// Defines the test module of the library krylov.
#define BOOST_TEST_MODULE krylov
#include <boost/test/unit_test.hpp>
