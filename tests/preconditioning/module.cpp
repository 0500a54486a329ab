// Defines the test module of the library preconditioning.
#define BOOST_TEST_MODULE preconditioning
#include <boost/test/unit_test.hpp>
