#pragma once
#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/number/estimate.hpp>
#include <nipref/ref/number/float.hpp>
#include <nipref/ref/number/internal/chebyshev_sum.hpp>

namespace nipref::ref {

/// Directions over half a turn for the trapezoidal rule, in a variable u for integrands that are functions of T =
/// tan(psi - centre) with singularities at T = i y, smallest <= |y| <= largest: T = smallest sc(u, k), k' =
/// smallest/largest. All these singularities have |Im u| = K(k') >= pi/2. The period 2 K(k) grows only with the
/// logarithm of k', so that the number of directions does, too, near critical lines and for slender ellipses.
class CrowdedDirections {
 public:
  /// 0 < smallest <= 1 <= largest; the centre in degrees.
  CrowdedDirections(const Exact& centre, const Float& smallest, const Float& largest);

  struct Direction {
    Exact degrees;
    Float cosine, sine;
    Float weight;  ///< dpsi/du times the period: its mean over the directions is int dpsi
  };
  /// The i-th of `count` directions; it is the 2 i-th of 2 count directions.
  [[nodiscard]] Direction at(long i, long count) const;

 private:
  [[nodiscard]] Float sc(const Float& u) const;  ///< 0 <= u <= K/2, to rounding

  Exact centre_;
  Float smallest_, complement_;  ///< k'
  Float quarter_, conjugate_;    ///< K(k), K(k')
};

/// The direction, in degrees, in which the compliance is largest, and the half width of this peak at half its height,
/// in radians and at most 1, which is about the distance of the nearest singularity. By parabolas from a scan of 1/K, which
/// is smooth even close to the critical speed.
struct PeakOfCompliance {
  double degrees, width;
};
PeakOfCompliance peak_of_compliance(const SurfaceAnswer& surface);

// The common part of the contacts of smooth rigid bodies with half-spaces. Integrals over a line use a
// double-exponential rule, those over the directions the trapezoidal rule, with twice as many points until two
// results agree. The error is the difference of these results; it is estimated, not proven.

/// The surface at working digits.
class WorkingSurface {
 public:
  WorkingSurface(const SurfaceAnswer& answer, int digits) : answer_(answer), digits_(digits) {}

  /// BadInput "surface" where its response is not finite.
  [[nodiscard]] LineAnswer at(const Exact& degrees) const;

 private:
  const SurfaceAnswer& answer_;
  int digits_;
};

/// 10^-digits.
Float tolerance(int digits);

/// The working digits for a result that has `digits` correct digits, if `cancelled` digits are lost by cancellation. The guard
/// digits are for the roundings of thousands of terms and for small factors of results that are computed from the integrals.
/// BadInput unless 16 <= digits <= 100.
int working_digits(int digits, int cancelled = 0);

/// The value with its error, to which the errors by rounding and by the surface's digits are added; BadInput "digits"
/// where the sum exceeds 10^-digits min(1, |value|).
Estimate estimated(const Float& value, const Float& error, int digits);

/// The finer of two levels of a quadrature. The error is their difference, plus the errors by rounding and by the
/// surface's digits; it may be of any size.
Estimate of_levels(const Float& fine, const Float& coarse, int digits);

/// A number of the lines that takes no quadrature, of(surface at working digits): the error is that of rounding and of the
/// surface's digits.
template <class Of>
Estimate of_lines(const SurfaceAnswer& surface, int digits, const Of& of, int cancelled = 0) {
  const int working = working_digits(digits, cancelled);
  const WorkingDigits scope(working);
  return estimated(of(WorkingSurface(surface, working)), 0, digits);
}

/// A traction on a line, whose error includes that of the line's ends, which dominates close to them. at(change of both ends
/// over the line's span) goes up or down with it.
Estimate with_shifted_ends(int digits, const std::function<Estimate(const Float& change)>& at);

/// The contact's span along the motion under a load, where force = factor span^3.
Float span_along_of(const HalfSpaceLoad& load, const Float& factor);

/// The force of the contact; a given force is returned exactly.
Float force_of(const HalfSpaceLoad& load, const Float& factor);

/// A value at one direction of the surface.
struct DirectionValue {
  CrowdedDirections::Direction at;
  Float value;
};

/// An integral over the lines of half a turn, by the last two levels. Each level has twice as many directions, until
/// two levels agree to 10^-digits; BadInput as for double_directions().
struct Levels {
  Float fine, coarse;
};
Levels half_turn_integral(int digits, const CrowdedDirections& directions,
                          const std::function<Float(const Exact& degrees)>& value);

/// A contact by the papers' rule, whose spans and force follow from an integral over the lines: force = factor span^3.
class ScaledContact {
 public:
  ScaledContact(SurfaceAnswer surface, const HalfSpaceLoad& load, int digits, int cancelled);
  virtual ~ScaledContact() = default;

  const SurfaceAnswer surface;
  const HalfSpaceLoad load;
  const int digits, working;

  [[nodiscard]] WorkingSurface lines() const { return {surface, working}; }
  /// L(psi)/L(0) at the working precision.
  [[nodiscard]] virtual Float ratio(const Exact& degrees) const = 0;
  /// The factor, when it is first asked for.
  [[nodiscard]] const Levels& factor() const;

  using Function = std::function<Float(const Float&)>;
  /// Estimates of a function of the factor, and of the span along the motion.
  [[nodiscard]] Estimate function_of_factor(const Function& function) const;
  [[nodiscard]] Estimate function_of_span(const Function& function) const;
  [[nodiscard]] Estimate span_ratio(const Exact& degrees) const;
  [[nodiscard]] Estimate span(const Exact& degrees) const;
  [[nodiscard]] Estimate force() const;

 protected:
  [[nodiscard]] virtual Levels integrated() const = 0;  ///< the factor

 private:
  mutable std::optional<Levels> factor_;
};

/// The nodes of the double exponential rule on (0, 1) for integrands with algebraic singularities at the ends. Slopes are
/// times the step: weights.
std::vector<UnitPoint> unit_nodes(int digits);

/// Evaluates at 8, 16, 32 ... directions until `settled` returns true; BadInput "digits" where 4096 are not enough.
void double_directions(int digits, const CrowdedDirections& directions,
                       const std::function<Float(const Exact& degrees)>& value,
                       const std::function<bool(const std::vector<DirectionValue>& values)>& settled);

}  // namespace nipref::ref
