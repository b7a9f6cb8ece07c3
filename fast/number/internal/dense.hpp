#pragma once

// The dense algebra whose time grows with the cube of the matrix size is compiled once for each instruction set
// (arithmetic/dense.cpp). DenseCode is the table of its entry points. Matrices are stored by columns.

#include <cstddef>

#include <nipref/fast/number/internal/instruction_level.hpp>

namespace nipref::fast::internal {

struct DenseCode {
  /// Replaces a square matrix A by the factors of P A = L U; row i of A is row order[i] of P A.
  void (*factor)(double* matrix, int* order, std::ptrdiff_t size);
  /// Adds the product of `left` (rows x inner) and `right` (inner x columns) to `sum` (rows x columns), whose columns
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
