#define BOOST_TEST_MODULE suspension
#include <boost/test/unit_test.hpp>
