#include <cmath>
#include <numbers>

#include <nipref/fast/number/internal/chebyshev.hpp>
#include <nipref/fast/number/internal/interpolation.hpp>

namespace nipref::fast::internal {

using Eigen::ArrayXd, Eigen::Index, Eigen::MatrixXd;

ArrayXd chebyshev_points(double length, Index count) {
  return ArrayXd::NullaryExpr(count, [&](Index number) {
    return length * shifted_chebyshev_zero(static_cast<int>(number), static_cast<int>(count));
  });
}

/// Uses the barycentric formula, whose rounding error does not grow with the number of points (Higham 2004). If a place
/// is a point, the distance `tiny` makes the weight of this point exceed all others.
MatrixXd interpolation(const ArrayXd& places, double length, Index count) {
  constexpr double tiny = 1e-200;
  const ArrayXd points = chebyshev_points(length, count);
  MatrixXd matrix(places.size(), count);
  ArrayXd sums = ArrayXd::Zero(places.size());
  for (Index i = 0; i < count; ++i) {
    const double angle = static_cast<double>(2 * i + 1) * std::numbers::pi / static_cast<double>(2 * count);
    matrix.col(i).array() = (i % 2 == 0 ? 1 : -1) * std::sin(angle) / ((places - points(i)) + tiny);
    sums += matrix.col(i).array();
  }
  matrix.array().colwise() *= 1 / sums;
  return matrix;
}

}  // namespace nipref::fast::internal
