// Compiled once for each instruction set, whose name is NIPREF_ISA. CMakeLists.txt renames the namespace Eigen after it.

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

}  // namespace

const DenseCode dense_code = {factor, add_product};

}  // namespace nipref::fast::internal::NIPREF_ISA
