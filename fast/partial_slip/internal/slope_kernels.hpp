#pragma once
#include <Eigen/Core>
#include <memory>
#include <vector>

#include <nipref/fast/number/internal/linear_system.hpp>

namespace nipref::fast {

/// The slopes of the sheet's displacements over N under line loads, U = (I1/pi)', V = (I3/pi)' and S = (I6(alpha, 0)/pi)', are
/// -1/(pi alpha) in U and S and rests that are analytic for |Im alpha| < 2. These are the rests between points of a contact, as
/// Chebyshev series of both points, to rounding: U = A K B^T for points e = a of targets and e = b of sources, alpha = a - b.
class SlopeKernels {
 public:
  /// All points are between 0 and `length`.
  SlopeKernels(double length, const Eigen::ArrayXd& targets, const Eigen::ArrayXd& sources);

  /// u' and v' at the targets, rows, under pressures and shears at the sources, with a column for each case.
  struct Rows {
    Eigen::MatrixXd normal, along;
  };
  [[nodiscard]] Rows values(const auto& pressures, const auto& shears) const {
    return at_targets(as_series(pressures, shears));
  }
  /// Their derivatives by the target's place.
  [[nodiscard]] Rows slopes(const auto& pressures, const auto& shears) const {
    return at_targets(under(series_->slopes, pressures, shears));
  }
  /// The values as series of the target's place, and the matrix that sums these at some of the targets.
  [[nodiscard]] Rows as_series(const auto& pressures, const auto& shears) const {
    return under(series_->values, pressures, shears);
  }
  [[nodiscard]] Eigen::MatrixXd to_targets(const std::vector<Eigen::Index>& targets) const {
    return at_targets_(targets, Eigen::all);
  }

 private:
  [[nodiscard]] Rows at_targets(const Rows& series) const {
    return {at_targets_ * series.normal, at_targets_ * series.along};
  }
  [[nodiscard]] Rows under(const Eigen::MatrixXd& kernels, const auto& pressures, const auto& shears) const {
    const Eigen::Index terms = at_sources_.rows();
    Eigen::MatrixXd both(2 * terms, pressures.cols());
    both.topRows(terms) = product(at_sources_, pressures);
    both.bottomRows(terms) = product(at_sources_, shears);
    const Eigen::MatrixXd sums = product(kernels, both);
    return {sums.topRows(terms), sums.bottomRows(terms)};
  }

  /// Coefficients on a contact a little longer: K of U and -V over those of V and S.
  struct Series {
    explicit Series(int eighths);  ///< of an octave of lengths
    double length;
    Eigen::MatrixXd values, slopes;
  };
  std::shared_ptr<const Series> series_;
  Eigen::MatrixXd at_targets_, at_sources_;  ///< Chebyshev polynomials, in columns and in rows
};

}  // namespace nipref::fast
