#include <nipref/fast/number/internal/instruction_level.hpp>
#include <nipref/fast/number/internal/linear_system.hpp>

#include "support/test.hpp"

namespace {

using Eigen::MatrixXd, Eigen::VectorXd;
namespace internal = nipref::fast::internal;

/// Runs the code for each instruction set of this processor in turn.
void with_each_instruction_set(const auto& check) {
  const int chosen = internal::chosen_instruction_set;
  for (int set = 0; set < internal::instruction_set_count; ++set) {
    if (!internal::has_instruction_set(set)) continue;
    CAPTURE(set);
    internal::chosen_instruction_set = set;
    check();
  }
  internal::chosen_instruction_set = chosen;
}

constexpr double unit_roundoff = 0x1p-53;

}  // namespace

TEST_CASE("elimination solves systems of any size with what it leaves as small as rounding") {
  with_each_instruction_set([] {
    for (const int size : {1, 2, 7, 40, 129, 300}) {
      const MatrixXd matrix = MatrixXd::Random(size, size);
      const VectorXd right = VectorXd::Random(size);
      const nipref::fast::Elimination elimination(matrix);
      const auto leaves = [&](const MatrixXd& of, const VectorXd& solution) {
        return (of * solution - right).cwiseAbs().maxCoeff() /
               (size * unit_roundoff * solution.cwiseAbs().sum());
      };
      CAPTURE(size);
      CHECK(elimination.size() == size);
      CHECK(leaves(matrix, elimination.solve(right)) < 10);
      CHECK(leaves(matrix.transpose(), elimination.solve_transposed(right)) < 10);
      const MatrixXd inverse = elimination.solve_columns(MatrixXd::Identity(size, size));
      CHECK((inverse * right - elimination.solve(right)).norm() <
            size * unit_roundoff * inverse.norm() * inverse.norm() * matrix.norm());
    }
  });
}

TEST_CASE("products are sums of products, and add to a part of a matrix alone") {
  with_each_instruction_set([] {
    const MatrixXd left = MatrixXd::Random(33, 21), right = MatrixXd::Random(21, 50);
    const MatrixXd expected = left.lazyProduct(right);
    CHECK((nipref::fast::product(left, right) - expected).cwiseAbs().maxCoeff() < 21 * unit_roundoff);
    const Eigen::SparseMatrix<double> sparse = right.sparseView();
    CHECK((nipref::fast::product(left, sparse) - expected).cwiseAbs().maxCoeff() < 21 * unit_roundoff);
    MatrixXd whole = MatrixXd::Ones(40, 60);
    nipref::fast::add_product(left, right, whole.block(3, 5, 33, 50));
    CHECK((whole.block(3, 5, 33, 50).array() - 1 - expected.array()).abs().maxCoeff() < 42 * unit_roundoff);
    whole.block(3, 5, 33, 50).setOnes();
    CHECK(whole == MatrixXd::Ones(40, 60));
  });
}

TEST_CASE("what a least-squares solution leaves is orthogonal to the columns") {
  with_each_instruction_set([] {
    for (const int columns : {1, 60}) {
      const MatrixXd matrix = MatrixXd::Random(75, columns);
      const VectorXd right = VectorXd::Random(75);
      const VectorXd solution = nipref::fast::least_squares(matrix, right);
      REQUIRE(solution.size() == columns);
      const VectorXd left = right - matrix * solution;
      CHECK(left.norm() > 0.1);
      CHECK((matrix.transpose() * left).cwiseAbs().maxCoeff() < 1e-13);
    }
  });
}
