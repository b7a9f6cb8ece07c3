#pragma once
#include <nipref/fast/half_space/direction.hpp>
#include <nipref/fast/nip/inner_stresses.hpp>
#include <nipref/ref/nip/inner_stresses.hpp>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>

namespace nipref::verify {

/// What differs between the paths for a template that serves both.
struct FastPath {
  static constexpr bool is_fast = true;
  using Accuracy = double;  ///< a scene's
  using Number = fast::Estimate;
  using Point = fast::InnerPoint;
  using Stresses = fast::InnerStresses;
  using Displacements = fast::InnerDisplacements;
  using Greatest = fast::GreatestShear;
  using Line = fast::Direction;  ///< of a half-space's surface, from the motion
  using Position = double;
  static Number exactly(double value, int) { return {value, 0}; }
  static Line line(double degrees) { return Line::of_degrees(degrees); }
  static Line reversed(const Line& psi) { return {-psi.cosine, -psi.sine, -psi.cosine_low, -psi.sine_low}; }
};
struct RefPath {
  static constexpr bool is_fast = false;
  using Accuracy = int;  ///< digits
  using Number = ref::Estimate;
  using Point = ref::InnerPoint;
  using Stresses = ref::InnerStresses;
  using Displacements = ref::InnerDisplacements;
  using Greatest = ref::GreatestShear;
  using Line = ref::Exact;  ///< degrees
  using Position = ref::Exact;
  static Number exactly(double value, int digits) { return ref::exactly(value, digits); }
  static Line line(double degrees) { return Line(degrees); }
  static Line reversed(const Line& psi) { return Line(mpq_class(psi.value() + 180)); }
};

}  // namespace nipref::verify
