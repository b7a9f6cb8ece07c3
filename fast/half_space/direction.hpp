#pragma once
#include <cmath>

namespace nipref::fast {

/// A direction in the surface of a half-space: that of the vector (cosine, sine), of unit length to rounding.
/// Near 90 degrees its cosine keeps all its digits, which no angle in double does: that is where the cross
/// direction of a sliding contact lives. Each may have a second word, to be added to it: near a critical line
/// that is oblique to the motion, compliances magnify the rounding of a direction without bound.
struct Direction {
  double cosine, sine;
  double cosine_low = 0, sine_low = 0;

  static Direction of_angle(double psi) { return {std::cos(psi), std::sin(psi)}; }
  /// In two words; exact at multiples of 90. BadInput unless finite.
  static Direction of_degrees(double degrees);

  /// This direction, its angle counted from the direction `from`, in two words.
  [[nodiscard]] Direction turned(Direction from) const;
};

}  // namespace nipref::fast
