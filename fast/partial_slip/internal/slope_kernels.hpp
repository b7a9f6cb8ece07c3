#pragma once
#include <Eigen/Core>
#include <array>

namespace nipref::fast {

/// The slopes of the sheet's displacements over N under line loads, U = (I1/pi)', V = (I3/pi)' and S = (I6(alpha, 0)/pi)', are
/// -1/(pi alpha) in U and S and rests that are analytic for |Im alpha| < 2. These are the rests between points of a contact,
/// each interpolated at Chebyshev points of the contact in both variables, to rounding: U = A K B^T for points e = a of
/// targets and e = b of sources, alpha = a - b.
class SlopeKernels {
 public:
  SlopeKernels(double length, const Eigen::ArrayXd& targets, const Eigen::ArrayXd& sources);

  /// Loads at the sources, rows, gathered at the Chebyshev points.
  [[nodiscard]] Eigen::MatrixXd gathered(const auto& loads) const { return at_sources_.transpose() * loads; }
  /// u' and v' at the targets under gathered pressures and shears, and their derivatives by the target's place.
  [[nodiscard]] Eigen::MatrixXd normal(const Eigen::MatrixXd& p, const Eigen::MatrixXd& q) const {
    return at_targets_ * (values_[0] * p - values_[1] * q);
  }
  [[nodiscard]] Eigen::MatrixXd along(const Eigen::MatrixXd& p, const Eigen::MatrixXd& q) const {
    return at_targets_ * (values_[1] * p + values_[2] * q);
  }
  [[nodiscard]] Eigen::MatrixXd normal_slope(const Eigen::MatrixXd& p, const Eigen::MatrixXd& q) const {
    return at_targets_ * (slopes_[0] * p - slopes_[1] * q);
  }
  [[nodiscard]] Eigen::MatrixXd along_slope(const Eigen::MatrixXd& p, const Eigen::MatrixXd& q) const {
    return at_targets_ * (slopes_[1] * p + slopes_[2] * q);
  }

 private:
  Eigen::MatrixXd at_targets_, at_sources_;
  std::array<Eigen::MatrixXd, 3> values_, slopes_;  ///< of U, V, S
};

}  // namespace nipref::fast
