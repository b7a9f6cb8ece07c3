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

/// Directions over half a turn for the trapezoidal rule. The integrands are functions of T = tan(psi - centre) with
/// singularities at T = i y, smallest <= |y| <= largest. The rule is applied in the variable u, T = smallest sc(u, k),
/// with k' = smallest/largest. In u all these singularities have |Im u| = K(k') >= pi/2. The period 2 K(k), and with it
/// the number of directions near critical lines and for slender ellipses, grows only with the logarithm of k'.
class CrowdedDirections {
 public:
  /// 0 < smallest <= 1 <= largest; the centre in degrees.
  CrowdedDirections(const Exact& centre, const Float& smallest, const Float& largest);

  struct Direction {
    Exact degrees;
    Float cosine, sine;
    Float weight;  ///< dpsi/du times the period; its mean over the directions is int dpsi
  };
  /// Direction i of `count` directions, which is direction 2 i of 2 count directions.
  [[nodiscard]] Direction at(long i, long count) const;

 private:
  [[nodiscard]] Float sc(const Float& u) const;  ///< sc(u, k) to rounding, 0 <= u <= K(k)/2

  Exact centre_;
  Float smallest_, complement_;  ///< complement_ is k'
  Float quarter_, conjugate_;    ///< K(k), K(k')
};

/// The direction, in degrees, in which the compliance K is largest, and the half width of this peak at half its height,
/// in radians and at most 1. This width is about the distance to the nearest singularity. A scan of 1/K, which is
/// smooth even close to the critical speed, and then parabolas find the peak.
struct PeakOfCompliance {
  double degrees, width;
};
PeakOfCompliance peak_of_compliance(const SurfaceAnswer& surface);

// The common part of the contacts of smooth rigid bodies with half-spaces. Integrals over a line use the double
// exponential rule. Integrals over the directions use the trapezoidal rule; the number of points is doubled until two
// results agree. The difference of these results is the error estimate.

/// The response of the surface, to the working digits.
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

/// The working digits for a result with `digits` correct digits, if cancellation loses `cancelled` digits. They include
/// guard digits for the rounding errors of thousands of terms and for small factors of results that are computed from
/// the integrals. BadInput unless 16 <= digits <= 100.
int working_digits(int digits, int cancelled = 0);

/// The value with its error, to which the errors by rounding and by the surface's digits are added. BadInput "digits"
/// if the sum exceeds 10^-digits |value|.
Estimate estimated(const Float& value, const Float& error, int digits);

/// The finer of two levels of a quadrature. The error, of any size, is the difference of the levels, plus the errors by
/// rounding and by the surface's digits.
Estimate of_levels(const Float& fine, const Float& coarse, int digits);

/// of(surface at working digits), a function of the response that takes no quadrature. The error is that of rounding
/// and of the surface's digits.
template <class Of>
Estimate of_lines(const SurfaceAnswer& surface, int digits, const Of& of, int cancelled = 0) {
  const int working = working_digits(digits, cancelled);
  const WorkingDigits scope(working);
  return estimated(of(WorkingSurface(surface, working)), 0, digits);
}

/// A traction on a line. Its error includes the effect of errors of the contact's ends, which dominates near the ends.
/// at(change), monotonic in `change`, is the traction if both ends move outwards by about `change` times the span.
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

/// An integral over the lines of half a turn on the last two levels. Each level has twice as many directions as the one
/// before, until two levels agree to 10^-digits; BadInput as for double_directions().
struct Levels {
  Float fine, coarse;
};
Levels half_turn_integral(int digits, const CrowdedDirections& directions,
                          const std::function<Float(const Exact& degrees)>& value);

/// A contact by the rules of brock2012 and brock2013: force = factor span^3 with an integral over the lines as factor.
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
  /// The factor, computed at the first call.
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

/// The nodes of the double exponential rule on (0, 1) for integrands with algebraic singularities at the ends. The
/// slopes are multiplied by the step, and so are the weights of the rule.
std::vector<UnitPoint> unit_nodes(int digits);

/// Evaluates `value` in 8, 16, 32 ... directions until `settled` is true; BadInput "digits" if 4096 do not suffice.
void double_directions(int digits, const CrowdedDirections& directions,
                       const std::function<Float(const Exact& degrees)>& value,
                       const std::function<bool(const std::vector<DirectionValue>& values)>& settled);

}  // namespace nipref::ref
