#pragma once

namespace nipref::fast {

/// The error that a caller accepts: a relative tolerance, by which the library chooses its work.
///
/// `Accuracy(rtol)` promises |error| <= rtol * scale, where scale = max(|value|, envelope). The envelope is the size
/// of the value away from its zeros: its leading residue without the cosine. For the odd kernels the scale is |value|
/// as the argument goes to 0. The default promises 2 units in the last place of the scale.
class Accuracy {
 public:
  /// The smallest tolerance that is allowed: 2 units in the last place, 2^-51.
  static constexpr double best_rtol = 0x1p-51;

  /// Full double accuracy.
  constexpr Accuracy() = default;

  /// rtol: dimensionless, 2^-51 <= rtol < 1. Anything else: BadInput that names rtol and the best reachable value.
  explicit Accuracy(double rtol);

  /// The requested tolerance.
  [[nodiscard]] constexpr double rtol() const { return rtol_; }

  /// Index of the work for this tolerance in internal::tier_works (tiers.hpp); 0 is the cheapest.
  [[nodiscard]] constexpr int tier() const { return tier_; }

 private:
  double rtol_ = best_rtol;
  int tier_ = 4;
};

}  // namespace nipref::fast
