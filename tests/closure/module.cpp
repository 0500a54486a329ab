#define BOOST_TEST_MODULE closure
#include <boost/test/unit_test.hpp>
