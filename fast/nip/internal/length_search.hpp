#pragma once
#include <limits>

namespace nipref::fast {

/// About the half-length, in half-thicknesses, of a frictionless elastic contact of this dimensionless load
/// (nip_equations.hpp), between that of a half-space and that of independent springs.
double half_length_guess(double load);
/// About the load of such a contact of this half-length.
double load_guess(double half_length);

/// d ln load/d ln length of that contact.
double load_exponent(double half_length);

/// The longest half-length that is tried, in half-thicknesses; check_length_of_load refuses longer ones.
inline constexpr double longest_sought = 2e4;

/// Where a LengthSearch ends and how it steps.
struct LengthSearchRule {
  double tolerance;                                          ///< of the load, relative
  double longest = std::numeric_limits<double>::infinity();  ///< the longest length that is tried
  /// Whether the search keeps its first exponent; otherwise the last two loads found determine it.
  bool fixed_exponent = false;
};

/// The search for the contact length, in any unit, that carries a load. ln(load) is nearly a linear function of
/// ln(length), so each step goes to where a straight line meets the load: the first by (thesis 2.13), the others by
/// secants. A step that leaves the bracket of lengths known to be too short and too long is replaced by bisection.
class LengthSearch {
 public:
  /// The exponent of the load's growth with the length is 2 for a half-space, 3 for springs and 5 for an
  /// incompressible film without slip.
  static constexpr double usual_exponent = 3;

  /// `near`, > 0: the first length tried. `exponent`: a guess of the load's exponent.
  LengthSearch(double load, double near, const LengthSearchRule& rule, double exponent = usual_exponent);

  /// The length to be tried next.
  [[nodiscard]] double length() const;
  /// Takes the load found at length(): true if the search ends there, otherwise length() has moved. A load that is not
  /// positive (0, tension, nan) counts as that of a contact that is too long.
  bool settled(double found);

  /// At the last length: the load is found within the tolerance, or as well as rounding allows.
  [[nodiscard]] bool met() const { return met_; }
  /// |load found/load - 1| at the last length; infinite where none was found.
  [[nodiscard]] double residual() const { return residual_; }
  /// The exponent that the last steps showed.
  [[nodiscard]] double exponent() const { return exponent_; }

 private:
  [[nodiscard]] bool at_rounding(double excess) const;
  void step(double excess);
  void move_to(double log_length);

  double load_;
  LengthSearchRule rule_;
  double log_length_;
  double exponent_;
  bool by_secant_ = false;  ///< the last step's exponent was that of the secant
  /// The bracket: the last length that carried too little, and the last that carried too much or nothing.
  double log_too_short_ = -std::numeric_limits<double>::infinity();
  double log_too_long_ = std::numeric_limits<double>::infinity();
  double last_log_length_ = 0;
  double last_excess_ = 0;  ///< of ln(load found) over ln(load); 0 before the second step
  double residual_ = std::numeric_limits<double>::infinity();
  int tried_ = 0;
  bool met_ = false;
};

/// The solution at the length where `search` ends; solve(length) returns a solution with a load.
template <class Solve>
auto solution_at_end(LengthSearch& search, const Solve& solve) {
  while (true) {
    auto solution = solve(search.length());
    if (search.settled(solution.load())) return solution;
  }
}

}  // namespace nipref::fast
