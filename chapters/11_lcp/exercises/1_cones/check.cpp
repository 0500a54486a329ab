// Check of exercise 11.1: problems solved by Lemke's method, and cones counted by hand.
#include "chapters/check.hpp"

#include "lcp/lemke.hpp"

using namespace stokesbook;
using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using exercise::expect;

int count_solutions(const Matrix2d& matrix, const Vector2d& offset);
bool proves_no_solution(const VectorXd& v, const MatrixXd& matrix, const VectorXd& offset);
VectorXd folds(int m, double s, double eps);

namespace {

Matrix2d matrix2(double a, double b, double c, double d) {
  return (Matrix2d() << a, b, c, d).finished();
}

// `blind`: the same without a look at w; `pushing`: without the empty set.
void expect_count(const Matrix2d& matrix, const Vector2d& q, int count, int blind) {
  const double pushing = count - (q.minCoeff() >= 0.0 ? 1 : 0);
  expect({.what = "M = (" + exercise::text(matrix(0, 0)) + " " + exercise::text(matrix(0, 1)) +
                  "; " + exercise::text(matrix(1, 0)) + " " + exercise::text(matrix(1, 1)) +
                  "), q = (" + exercise::text(q[0]) + ", " + exercise::text(q[1]) + ")",
          .got = static_cast<double>(count_solutions(matrix, q)),
          .expected = static_cast<double>(count),
          .tolerance = 0.0,
          .mistakes = {{static_cast<double>(blind),
                        "the gaps of the other contacts have to be open: w >= 0"},
                       {pushing, "the empty set is missing: nothing may push"}}});
}

void check_counts() {
  const Matrix2d apart = matrix2(2.0, 1.0, 1.0, 2.0);
  expect_count(apart, {1.0, 3.0}, 1, 1);
  expect_count(apart, {-2.0, -3.0}, 1, 3);
  expect_count(apart, {-1.0, -3.0}, 1, 2);
  expect_count(matrix2(1.0, -1.0, -1.0, 1.0), {-1.0, -2.0}, 0, 2);
  expect_count(matrix2(1.0, 2.0, 2.0, 1.0), {-1.0, -1.0}, 3, 3);
}

void check_proofs() {
  const MatrixXd skew = matrix2(0.0, 1.0, -1.0, 0.0);
  const auto expect_verdict = [](const VectorXd& v, const MatrixXd& matrix, const VectorXd& q,
                                 bool proof, const std::string& mistake) {
    expect({.what = "v = (" + exercise::text(v[0]) + ", " + exercise::text(v[1]) + ")",
            .got = proves_no_solution(v, matrix, q) ? 1.0 : 0.0,
            .expected = proof ? 1.0 : 0.0,
            .tolerance = 0.0,
            .mistakes = {{proof ? 0.0 : 1.0, mistake}}});
  };
  const std::string transpose = "it is the transpose of M that v meets";
  // 0 z_1 + z_2 - 1 >= 0 and -z_1 - 1 >= 0: the second row alone is impossible.
  const Vector2d q{-1.0, -1.0};
  const LcpResult ray = lemke({skew, q});
  if (ray.status == LcpStatus::ray) expect_verdict(ray.ray, skew, q, true, transpose);
  expect_verdict(Vector2d{0.0, 1.0}, skew, q, true, transpose);
  expect_verdict(Vector2d{1.0, 0.0}, skew, q, false, transpose);
  expect_verdict(Vector2d{1.0, -1.0}, matrix2(-1.0, 0.0, 0.0, 1.0), Vector2d{-1.0, 1.0}, false,
                 "v has to be >= 0");
  expect_verdict(Vector2d{0.0, 1.0}, skew, Vector2d{-1.0, 1.0}, false,
                 "q v < 0 is missing: where it is >= 0 there may be a solution");
}

// y_i = |y_(i-1)| - (eps^(i-1) - eps^i).
void check_folds(int m) {
  const double eps = 1.0 / 8.0;
  int crossings = 0;
  VectorXd before = VectorXd::Ones(m);
  const double step = std::pow(eps, static_cast<double>(m)) / 3.7;
  for (double s = 1.0; s > -1.0; s -= step) {
    VectorXd exact(m), last(m);
    exact[0] = last[0] = s + eps;
    for (Index i = 1; i < m; ++i) {
      const double power = std::pow(eps, static_cast<double>(i));
      exact[i] = std::abs(exact[i - 1]) - (power - eps * power);
      last[i] = s + eps * power + 2.0 * std::max(0.0, -last[i - 1]);
    }
    const VectorXd got = folds(m, s, eps);
    expect({.what = "m = " + std::to_string(m) + ", s = " + exercise::text(s),
            .got = got,
            .expected = exact,
            .tolerance = 1e-12,
            .mistakes = {{last, "all earlier forces count, not the last one alone"}}});
    crossings += static_cast<int>((got.array() * before.array() < 0.0).count());
    before = got;
  }
  expect({.what = "m = " + std::to_string(m) + ", cones on the line",
          .got = crossings + 1.0,
          .expected = std::exp2(m),
          .tolerance = 0.0});
}

}  // namespace

int main() {
  return exercise::run({{.title = "the solutions of two contacts",
                         .formula = "M_AA z_A = -q_A, z_A >= 0, w >= 0 elsewhere",
                         .hint = "there are four sets, one of them empty",
                         .check = check_counts},
                        {.title = "a proof that there is none",
                         .formula = "v >= 0, M^T v <= 0, q v < 0",
                         .hint = "multiply w = q + M z by v",
                         .check = check_proofs},
                        {.title = "the folds",
                         .formula = "y_i = x_i + 2 sum_(j<i) max(0, -y_j)",
                         .hint = "keep the sum of the forces",
                         .check = [] {
                           for (const int m : {1, 2, 4}) check_folds(m);
                         }}});
}
