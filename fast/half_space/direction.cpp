#include <fmt/format.h>

#include <cmath>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/half_space/direction.hpp>
#include <nipref/fast/half_space/internal/direction_words.hpp>
#include <nipref/fast/number/internal/checks.hpp>

namespace nipref::fast {
namespace {

using internal::Two;

constexpr Two degree{0x1.1df46a2529d39p-6, 0x1.5c1d8becdd291p-62};

Direction of_words(Two cosine, Two sine) { return {cosine.high, sine.high, cosine.low, sine.low}; }

/// The direction by Taylor's series for |angle| <= pi/4, with a truncation error below 2^-117.
Direction of_small_angle(Two angle) {
  constexpr Two one{1};
  const Two squared = square(angle);
  Two cosine = one, sine = one;
  for (int k = 28; k > 0; k -= 2) {
    cosine = one - squared * cosine / (k * (k - 1.));
    sine = one - squared * sine / (k * (k + 1.));
  }
  return of_words(cosine, angle * sine);
}

}  // namespace

void internal::check_direction(const char* name, Direction direction) {
  const double squared_length = direction.cosine * direction.cosine + direction.sine * direction.sine;
  if (!(std::fabs(squared_length - 1) < 1e-12)) {
    throw data::BadInput(name, fmt::format("({}, {})", direction.cosine, direction.sine),
                         "must be a unit vector");
  }
}

Direction Direction::of_degrees(double degrees) {
  internal::check_finite("degrees", degrees);
  const double within_a_turn = std::fmod(degrees, 360), quarters = std::round(within_a_turn / 90);
  Direction result = of_small_angle((within_a_turn - 90 * quarters) * degree);
  for (int turns = static_cast<int>(quarters + 4) % 4; turns > 0; --turns)
    result = {-result.sine, result.cosine, -result.sine_low, result.cosine_low};
  return result;
}

Direction Direction::turned(Direction from) const {
  using internal::cosine_of, internal::sine_of;
  return of_words(cosine_of(*this) * cosine_of(from) - sine_of(*this) * sine_of(from),
                  sine_of(*this) * cosine_of(from) + cosine_of(*this) * sine_of(from));
}

}  // namespace nipref::fast
