#pragma once

namespace nipref::fast {

/// Half length, in half-thicknesses, of a frictionless elastic contact of about this dimensionless load
/// (HalfContact): between half-space and independent springs.
double half_length_guess(double load);

/// Longer contacts are not sought: nobody asks for them, see contact_converged.hpp.
inline constexpr double longest_sought = 2e4;

/// Search for the contact length that carries a load: secant iteration on ln(load) as a function of
/// ln(length), which is nearly straight.
class LengthSearch {
 public:
  /// The exponent of the load's growth with the length is 2 for a half-space, 3 for springs and 5 for an
  /// incompressible film without slip.
  static constexpr double usual_slope = 3;

  /// From half length `near` on, until ln(load found/load) is at most `enough` or rounding allows no less.
  /// `slope` is what is known of the exponent.
  LengthSearch(double load, double near, double enough, double slope = usual_slope);

  [[nodiscard]] double half_length() const;
  /// The exponent as the last steps showed it.
  [[nodiscard]] double slope() const { return slope_; }
  /// |ln(load found/load)| at the last half length.
  [[nodiscard]] double residual() const { return residual_; }
  /// Takes the load found at half_length(): true if the search ends there, otherwise half_length() has moved.
  bool settled(double found);

 private:
  double load_;
  double enough_;
  double log_length_;
  double slope_;
  double last_log_length_ = 0;
  double last_excess_ = 0;
  double residual_ = 0;
  int iteration_ = 0;
};

}  // namespace nipref::fast
