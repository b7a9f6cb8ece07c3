#pragma once
#include <algorithm>
#include <functional>
#include <vector>

#include <nipref/ref/half_space/indenter.hpp>
#include <nipref/ref/half_space/internal/crowded_directions.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/number/estimate.hpp>
#include <nipref/ref/number/internal/float.hpp>

namespace nipref::ref {

// What the contacts of smooth rigid bodies with half-spaces share. Integrals by quadrature: over a line by a
// double-exponential rule, over the directions by the trapezoidal rule, doubled until two results agree;
// errors are those differences, estimated and not proven.

/// LineAnswer at working digits.
struct WorkingAnswer {
  Float compliance, coupling, coupling_across, in_line, shear_compliance, shear_compliance_across;
};

/// The surface at working digits.
class WorkingSurface {
 public:
  /// Stresses count in units of 2^exponent.
  WorkingSurface(const SurfaceAnswer& answer, int digits, long exponent = 0)
      : answer_(answer), digits_(digits), exponent_(exponent) {}

  /// BadInput "surface" where it answers with what is not finite.
  [[nodiscard]] WorkingAnswer at(const Exact& degrees) const;

 private:
  const SurfaceAnswer& answer_;
  int digits_;
  long exponent_;
};

/// Of the unit of stress, a power of 2, in which the compliance along the motion is about 1.
long stress_exponent(const SurfaceAnswer& surface);

/// 10^-digits.
Float tolerance(int digits);

/// So many working digits that a result may be good to `digits`, `cancelled` more for what cancels before.
/// BadInput unless 16 <= digits <= 100.
int working_digits(int digits, int cancelled = 0);

/// `compute(working)` at so many working digits that the result may be good to `digits`: for the roundings of
/// thousands of terms, and the small factors of what is computed from the integrals; `cancelled` more for what
/// cancels before. BadInput unless 16 <= digits <= 100.
Estimate with_digits(int digits, const std::function<Estimate(int working)>& compute, int cancelled = 0);

/// The value with its error, rounding and the surface's own digits included; BadInput "digits" where that is
/// more than 10^-digits of the value (or of 1, if that is less).
Estimate estimated(const Float& value, const Float& error, int digits);

/// Without quadrature: what the surface's own digits and rounding leave.
Estimate closed(const Float& value, int digits);

/// Of two levels of a quadrature, without asking how far apart they are: the error is their difference, relative
/// rounding and the surface's own digits included.
Estimate of_levels(const Float& fine, const Float& coarse, int digits);

/// A traction near the ends of a line, where what rounding leaves of the ends shows: at(span along the motion, change of
/// both ends over the line's span) grows with both; Contact gives functions of that span by of_span, and `digits`.
template <class Contact, class At>
Estimate with_shifted_ends(const Contact& contact, const At& at) {
  const Float off = tolerance(contact.digits + 6);
  const Float none(0);
  Estimate result = contact.of_span([&](const Float& along) { return at(along, none); });
  const Estimate more = contact.of_span([&](const Float& along) { return at(along, off); });
  const Estimate less = contact.of_span([&](const Float& along) { return at(along, -off); });
  const Float value = to_float(result.value);
  const Float change =
      std::max(Float(abs(to_float(more.value) - value)), Float(abs(to_float(less.value) - value)));
  return {result.value, to_real(to_float(result.error) + change), contact.digits};
}

/// The span that a load makes along the motion, where force = factor span^3.
Float span_along_of(const HalfSpaceLoad& load, const Float& factor);

/// The force that goes with a span along the motion: the given one exactly.
Float force_of(const HalfSpaceLoad& load, const Float& factor);

/// Whether so large a change of a value of that size is good enough to end a quadrature.
bool is_settled(const Float& change, const Float& value, int digits);

/// A value of a surface at a direction.
struct DirectionValue {
  CrowdedDirections::Direction at;
  Float value;
};

/// An integral over the lines of half a turn: twice as many directions at each level until two agree to
/// 10^-digits of it; BadInput as below.
struct Levels {
  Float fine, coarse;
};
Levels half_turn_integral(int digits, const CrowdedDirections& directions,
                          const std::function<Float(const Exact& degrees)>& value);

/// Of the double exponential rule on 0 .. 1.
struct UnitNode {
  Float left, right;  ///< distances from the ends, each exact where nodes crowd there
  Float log_right;
  Float weight;
};

/// int_0^1 f dx for f with algebraic ends.
Float unit_integral(int digits, const std::function<Float(const UnitNode& node)>& f);

/// Values at 8, 16, 32 ... of the directions, until `settled` says of them that they are enough; BadInput
/// "digits" where 4096 are not.
void double_directions(int digits, const CrowdedDirections& directions,
                       const std::function<Float(const Exact& degrees)>& value,
                       const std::function<bool(const std::vector<DirectionValue>& values)>& settled);

}  // namespace nipref::ref
