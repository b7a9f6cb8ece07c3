#pragma once
#include <cstddef>
#include <utility>
#include <vector>

namespace nipref::verify::confirm {

/// A square linear system, at first zero, which is solved by Gaussian elimination with partial pivoting.
template <class Float>
class LinearSystem {
 public:
  explicit LinearSystem(std::size_t size) : rows_(size, std::vector<Float>(size + 1, Float(0))) {}

  Float& operator()(std::size_t row, std::size_t column) { return rows_[row][column]; }
  Float& right(std::size_t row) { return rows_[row].back(); }

  /// Overwrites the system.
  std::vector<Float> solution() {
    const std::size_t size = rows_.size();
    for (std::size_t pivot = 0; pivot < size; ++pivot) {
      std::size_t largest = pivot;
      for (std::size_t i = pivot + 1; i < size; ++i) {
        if (abs(rows_[i][pivot]) > abs(rows_[largest][pivot])) largest = i;
      }
      std::swap(rows_[pivot], rows_[largest]);
      const Float inverse = 1 / rows_[pivot][pivot];
      for (std::size_t i = pivot + 1; i < size; ++i) {
        const Float factor = rows_[i][pivot] * inverse;
        for (std::size_t j = pivot + 1; j <= size; ++j) rows_[i][j] -= factor * rows_[pivot][j];
      }
    }
    std::vector<Float> result(size);
    for (std::size_t i = size; i-- > 0;) {
      Float sum = rows_[i][size];
      for (std::size_t j = i + 1; j < size; ++j) sum -= rows_[i][j] * result[j];
      result[i] = sum / rows_[i][i];
    }
    return result;
  }

 private:
  std::vector<std::vector<Float>> rows_;
};

}  // namespace nipref::verify::confirm
