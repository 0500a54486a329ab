#define BOOST_TEST_MODULE null_space
#include <boost/test/unit_test.hpp>
