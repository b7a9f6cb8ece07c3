#pragma once
#include <Eigen/Core>
#include <memory>
#include <vector>

#include <nipref/fast/number/internal/linear_system.hpp>

namespace nipref::fast {

/// The slopes of the sheet's displacements over N under line loads: U = (I1/pi)', V = (I3/pi)', S = (I6(alpha, 0)/pi)'.
/// U and S are -1/(pi alpha) plus a rest, V is a rest; the rests are analytic for |Im alpha| < 2. This class evaluates
/// the rests at alpha = a - b between targets e = a and sources e = b of a contact, interpolated to rounding between
/// Chebyshev points: U = A K B^T, K the rests between these.
class SlopeKernels {
 public:
  SlopeKernels() = default;
  /// All points are between 0 and `length`.
  SlopeKernels(double length, const Eigen::ArrayXd& targets, const Eigen::ArrayXd& sources);

  /// u' and v' at the targets, rows, under pressures and shears at the sources, with a column for each case.
  struct Rows {
    Eigen::MatrixXd normal, along;
  };
  [[nodiscard]] Rows values(const auto& pressures, const auto& shears) const {
    return at_targets(at_points(pressures, shears));
  }
  /// The derivatives of u' and v' with respect to the target's place.
  [[nodiscard]] Rows slopes(const auto& pressures, const auto& shears) const {
    return at_targets(under(points_->slopes, pressures, shears));
  }
  /// The values at the Chebyshev points, and the matrix that maps these to the values at some of the targets.
  [[nodiscard]] Rows at_points(const auto& pressures, const auto& shears) const {
    return under(points_->values, pressures, shears);
  }
  [[nodiscard]] Eigen::MatrixXd to_targets(const std::vector<Eigen::Index>& targets) const {
    return at_targets_(targets, Eigen::all);
  }

 private:
  [[nodiscard]] Rows at_targets(const Rows& at_points) const {
    return {at_targets_ * at_points.normal, at_targets_ * at_points.along};
  }
  [[nodiscard]] Rows under(const Eigen::MatrixXd& kernels, const auto& pressures, const auto& shears) const {
    const Eigen::Index count = from_sources_.rows();
    Eigen::MatrixXd both(2 * count, pressures.cols());
    both.topRows(count) = product(from_sources_, pressures);
    both.bottomRows(count) = product(from_sources_, shears);
    const Eigen::MatrixXd sums = product(kernels, both);
    return {sums.topRows(count), sums.bottomRows(count)};
  }

  /// The rests [U, -V; V, S] between the Chebyshev points of a slightly longer contact, and their derivatives.
  struct Points {
    explicit Points(int eighths);  ///< the length is 2^(eighths/8)
    double length;
    Eigen::MatrixXd values, slopes;
  };
  std::shared_ptr<const Points> points_;
  Eigen::MatrixXd at_targets_, from_sources_;  ///< A and the transposed B
};

}  // namespace nipref::fast
