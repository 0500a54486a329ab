// Checks that an application allocates no memory, unless it is the first with its workspace.
#include <atomic>
#include <cstdlib>
#include <new>

#include <boost/test/unit_test.hpp>

#include "fmm/fmm.hpp"
#include "support/point_sets.hpp"

// operator new calls the libraries' malloc, but GCC cannot see this call.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"

namespace {

std::atomic<long> allocation_count{0};

}  // namespace

// The linker redirects the libraries' calls to these functions (see CMakeLists.txt).
extern "C" {
void* __real_malloc(std::size_t size);
void* __real_calloc(std::size_t count, std::size_t size);
void* __real_realloc(void* memory, std::size_t size);

void* __wrap_malloc(std::size_t size) {
  ++allocation_count;
  return __real_malloc(size);
}

void* __wrap_calloc(std::size_t count, std::size_t size) {
  ++allocation_count;
  return __real_calloc(count, size);
}

void* __wrap_realloc(void* memory, std::size_t size) {
  ++allocation_count;
  return __real_realloc(memory, size);
}
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocation_count;
  return __real_malloc(size > 0 ? size : 1);
}

void* operator new(std::size_t size) {
  if (void* memory = operator new(size, std::nothrow)) return memory;
  throw std::bad_alloc();
}

void operator delete(void* memory) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

using namespace stokesbook;
using test::random_vector;

namespace {

template <class Work>
long allocations(const Work& work) {
  const long before = allocation_count;
  work();
  return allocation_count - before;
}

}  // namespace

BOOST_AUTO_TEST_CASE(allocations_are_counted) {
  BOOST_TEST(allocations([] { std::vector<int> numbers(100); }) == 1);
  BOOST_TEST(allocations([] { Eigen::VectorXd numbers(100); }) == 1);
  BOOST_TEST(allocations([] { delete new (std::nothrow) int(1); }) == 1);
}

BOOST_AUTO_TEST_CASE(applications_do_not_allocate) {
  const Fmm fmm(test::ellipses(6, 64), random_vector(300, 1), {20, 30});
  for (const Eigen::Index fields : {1, 3}) {
    const Eigen::MatrixXcd density = Eigen::MatrixXcd::Random(36 * 64, fields),
                           force = Eigen::MatrixXcd::Random(300, fields);
    const Eigen::MatrixXd torque = Eigen::MatrixXd::Random(300, fields);
    FmmWorkspace work = fmm.workspace(fields);
    const FmmStrengths nodes(density), all(density, force, torque);
    fmm.velocity(nodes, work);
    fmm.derivatives(nodes, work);
    BOOST_TEST(allocations([&] { fmm.velocity(nodes, work); }) == 0);
    BOOST_TEST(allocations([&] { fmm.velocity(all, work); }) == 0);
    BOOST_TEST(allocations([&] { fmm.derivatives(all, work); }) == 0);
  }
  // Images require no memory during an application.
  const Fmm with_images(test::ellipses(6, 64), {}, {20, 30}, [](double, int) {
    return FmmImages{{{10.0, 0.0}}, [](auto multipole, auto local) { local += multipole; }};
  });
  const Eigen::MatrixXcd two_fields = Eigen::MatrixXcd::Random(36 * 64, 2);
  FmmWorkspace two = with_images.workspace(2);
  const FmmStrengths strengths(two_fields);
  BOOST_TEST(allocations([&] { with_images.velocity(strengths, two); }) == 0);
  // Views of vectors require no memory either.
  const ComplexVector density = random_vector(36 * 64, 2);
  FmmWorkspace work = fmm.workspace();
  BOOST_TEST(allocations([&] { fmm.velocity(density, work); }) == 0);
}
