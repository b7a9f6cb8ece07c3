#pragma once
#include <cmath>

namespace nipref::fast {

/// A direction in the surface of a half-space, that of the vector (cosine, sine), whose length is 1 to rounding. Unlike
/// an angle, it keeps all digits of the cosine near 90 degrees, the direction across a sliding contact. Cosine and sine
/// may each have a second word, which is added, because near a critical line that is oblique to the motion compliances
/// magnify the rounding error of a direction without bound.
struct Direction {
  double cosine, sine;
  double cosine_low = 0, sine_low = 0;

  static Direction of_angle(double psi) { return {std::cos(psi), std::sin(psi)}; }
  /// The direction at this angle, with both words; exact at multiples of 90 degrees. BadInput unless finite.
  static Direction of_degrees(double degrees);

  /// The direction whose angle is the sum of the angles of both directions, with both words.
  [[nodiscard]] Direction turned(Direction from) const;
};

}  // namespace nipref::fast
