// Compiled once for each instruction set; NIPREF_ISA is its name. The namespace Eigen is named after it (CMakeLists.txt).

#include <Eigen/Householder>
#include <Eigen/LU>

#include <nipref/fast/number/internal/dense.hpp>

namespace nipref::fast::internal::NIPREF_ISA {
namespace {

using Eigen::MatrixXd;
using Factor = Eigen::Map<const MatrixXd>;

void factor(double* matrix, int* order, std::ptrdiff_t size) {
  Eigen::Map<MatrixXd> in_place(matrix, size, size);
  const Eigen::PartialPivLU<Eigen::Ref<MatrixXd>> factors(in_place);
  Eigen::Map<Eigen::VectorXi>(order, size) = factors.permutationP().indices();
}

void add_product(const double* left, const double* right, double* sum, std::ptrdiff_t rows,
                 std::ptrdiff_t inner, std::ptrdiff_t columns, std::ptrdiff_t stride) {
  Eigen::Map<MatrixXd, 0, Eigen::OuterStride<>>(sum, rows, columns, Eigen::OuterStride<>(stride)).noalias() +=
      Factor(left, rows, inner) * Factor(right, inner, columns);
}

/// By reflections of one column after the other: Eigen's, of several at once, takes twice as long to compile as all else here.
void least_squares(double* matrix, double* right, std::ptrdiff_t rows, std::ptrdiff_t columns) {
  Eigen::Map<MatrixXd> in_place(matrix, rows, columns);
  Eigen::Map<Eigen::VectorXd> solution(right, rows);
  Eigen::VectorXd workspace(columns);
  for (Eigen::Index k = 0; k < columns; ++k) {
    double factor, size;
    in_place.col(k).tail(rows - k).makeHouseholderInPlace(factor, size);
    in_place(k, k) = size;
    const auto direction = in_place.col(k).tail(rows - k - 1);
    in_place.bottomRightCorner(rows - k, columns - k - 1)
        .applyHouseholderOnTheLeft(direction, factor, workspace.data());
    solution.tail(rows - k).applyHouseholderOnTheLeft(direction, factor, workspace.data());
  }
  in_place.topRows(columns).triangularView<Eigen::Upper>().solveInPlace(solution.head(columns));
}

}  // namespace

const DenseCode dense_code = {factor, add_product, least_squares};

}  // namespace nipref::fast::internal::NIPREF_ISA
