#pragma once

// The dense algebra whose time grows with the cube of the size is compiled once for each instruction set
// (arithmetic/dense.cpp); this is the table of its entry points. Matrices are stored by columns.

#include <cstddef>

#include <nipref/fast/number/internal/instruction_level.hpp>

namespace nipref::fast::internal {

struct DenseCode {
  /// Makes a square matrix P A = L U in its place; row i of A is row order[i] of P A.
  void (*factor)(double* matrix, int* order, std::ptrdiff_t size);
  /// Adds to `sum`, of `rows` by `columns`, the product of `left` and `right`, which has `inner` rows; the columns of `sum`
  /// begin `stride` numbers apart.
  void (*add_product)(const double* left, const double* right, double* sum, std::ptrdiff_t rows,
                      std::ptrdiff_t inner, std::ptrdiff_t columns, std::ptrdiff_t stride);
};

namespace baseline {
extern const DenseCode dense_code;
}
namespace v3 {
extern const DenseCode dense_code;
}

const DenseCode& dense_code();

}  // namespace nipref::fast::internal
