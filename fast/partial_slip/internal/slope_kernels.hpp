#pragma once
#include <Eigen/Core>
#include <vector>

#include <nipref/fast/number/internal/linear_system.hpp>

namespace nipref::fast {

/// The slopes of the sheet's displacements over N under line loads, U = (I1/pi)', V = (I3/pi)' and S = (I6(alpha, 0)/pi)', are
/// -1/(pi alpha) in U and S and rests that are analytic for |Im alpha| < 2. These are the rests between points of a contact,
/// each interpolated at Chebyshev points of the contact in both variables, to rounding: U = A K B^T for points e = a of
/// targets and e = b of sources, alpha = a - b.
class SlopeKernels {
 public:
  SlopeKernels(double length, const Eigen::ArrayXd& targets, const Eigen::ArrayXd& sources);

  /// u' and v' at the targets, rows, under pressures and shears at the sources, with a column for each case.
  struct Rows {
    Eigen::MatrixXd normal, along;
  };
  [[nodiscard]] Rows values(const auto& pressures, const auto& shears) const {
    return at_targets(at_points(pressures, shears));
  }
  /// Their derivatives by the target's place.
  [[nodiscard]] Rows slopes(const auto& pressures, const auto& shears) const {
    return at_targets(under(slopes_, pressures, shears));
  }
  /// The values at the Chebyshev points, and the matrix that interpolates them at some of the targets.
  [[nodiscard]] Rows at_points(const auto& pressures, const auto& shears) const {
    return under(values_, pressures, shears);
  }
  [[nodiscard]] Eigen::MatrixXd to_targets(const std::vector<Eigen::Index>& targets) const {
    return at_targets_(targets, Eigen::all);
  }

 private:
  [[nodiscard]] Rows at_targets(const Rows& at_points) const {
    return {at_targets_ * at_points.normal, at_targets_ * at_points.along};
  }
  [[nodiscard]] Rows under(const Eigen::MatrixXd& kernels, const auto& pressures, const auto& shears) const {
    const Eigen::Index points = at_sources_.rows();
    Eigen::MatrixXd both(2 * points, pressures.cols());
    both.topRows(points) = product(at_sources_, pressures);
    both.bottomRows(points) = product(at_sources_, shears);
    const Eigen::MatrixXd sums = product(kernels, both);
    return {sums.topRows(points), sums.bottomRows(points)};
  }

  Eigen::MatrixXd at_targets_, at_sources_;  ///< Lagrange's polynomials, in columns and in rows
  Eigen::MatrixXd values_, slopes_;          ///< U and -V over V and S
};

}  // namespace nipref::fast
