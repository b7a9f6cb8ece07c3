#pragma once
#include <nipref/fast/half_space/internal/direction_words.hpp>

namespace nipref::fast::internal {

/// The critical speeds of the lines of a half-space.
class LineLimits {
 public:
  /// The critical speed along the line psi, times the length of psi, rounded down to a double; or in two words.
  [[nodiscard]] virtual double limit(Direction psi) const = 0;
  [[nodiscard]] virtual Two limit_in_two_words(Direction psi) const = 0;

 protected:
  LineLimits() = default;
  LineLimits(const LineLimits&) = default;
  LineLimits& operator=(const LineLimits&) = default;
  ~LineLimits() = default;
};

/// The velocity of a load.
struct Motion {
  Motion(Direction along, Two speed)
      : direction(along), squared_ratio(square(speed) / squared_length(along)) {}

  Direction direction;
  Two squared_ratio;  ///< (speed/length of the direction)^2
};

/// density c_X^2 of the speed c_X along the line psi, times the square of the length of psi.
inline Two stress_density(double density, Direction psi, const Motion& motion) {
  return density * (motion.squared_ratio * square(cosine_between(psi, motion.direction)));
}

}  // namespace nipref::fast::internal
