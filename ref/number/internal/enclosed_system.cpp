#include <algorithm>

#include <nipref/ref/number/internal/enclosed_system.hpp>

namespace nipref::ref {
namespace {

/// The larger number, or NaN if one of them is NaN, so that NaN does not pass for a small error.
Float larger(const Float& a, const Float& b) { return a >= b || !(a == a) ? a : b; }

Float row_sum_norm(const Matrix& matrix) {
  Float largest = 0;
  for (Matrix::Index i = 0; i < matrix.rows(); ++i) {
    Float sum = 0;
    for (Matrix::Index j = 0; j < matrix.cols(); ++j) sum += abs(matrix(i, j));
    largest = larger(largest, sum);
  }
  return largest;
}

void keep(Float& entry, Float& error, const Interval& value) {
  entry = middle_of(value);
  error = larger(error, upper_end(distance_from(entry, value)));
}

}  // namespace

void NearlyKnownSystem::set(Matrix::Index row, Matrix::Index column, const Interval& value) {
  keep(matrix(row, column), error, value);
}
void NearlyKnownSystem::set_right(Matrix::Index row, Matrix::Index column, const Interval& value) {
  keep(right(row, column), right_error(column), value);
}

// A sum of n products has a rounding error of at most (n + 2) units of the sum of their magnitudes.
std::optional<EnclosedSolutions> enclosed_solutions(const NearlyKnownSystem& system) {
  const auto n = system.matrix.rows();
  const Matrix inverse = system.matrix.inverse();
  const Float unit = (n + 2) * std::numeric_limits<Float>::epsilon();
  const Float size = row_sum_norm(system.matrix) + n * system.error;
  const Float inverse_size = row_sum_norm(inverse);
  const Float defect = row_sum_norm(Matrix::Identity(n, n) - inverse * system.matrix) +
                       unit * inverse_size * size + inverse_size * n * system.error;
  if (!(defect < 0.5)) return std::nullopt;
  EnclosedSolutions result{{}, 0, 0, size * inverse_size};
  for (Matrix::Index column = 0; column < system.right.cols(); ++column) {
    const Vector right = system.right.col(column), unknowns = inverse * right;
    const Vector residual = right - system.matrix * unknowns;
    const Float of_residual = unit * (size * largest_entry(unknowns) + 4 * largest_entry(right)) +
                              n * system.error * largest_entry(unknowns) +
                              (system.right_error.size() > 0 ? system.right_error(column) : Float(0));
    const Float error =
        inverse_size * (largest_entry(residual) + of_residual) / (1 - defect) * (1 + Float(1e-3));
    std::vector<Interval> enclosed;
    for (Matrix::Index i = 0; i < n; ++i)
      enclosed.push_back(interval_of(unknowns(i)).widened(interval_of(error)));
    result.unknowns.push_back(std::move(enclosed));
    result.error = larger(result.error, error);
    result.largest = larger(result.largest, largest_entry(unknowns));
  }
  return result;
}

}  // namespace nipref::ref
