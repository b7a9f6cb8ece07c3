#pragma once
#include <nipref/fast/half_space/direction.hpp>
#include <nipref/fast/number/internal/two_words_algebra.hpp>

namespace nipref::fast::internal {

inline Two cosine_of(Direction x) { return {x.cosine, x.cosine_low}; }
inline Two sine_of(Direction x) { return {x.sine, x.sine_low}; }

inline Two squared_length(Direction x) { return square(cosine_of(x)) + square(sine_of(x)); }

/// The scalar product of both vectors, the cosine of their angle times both lengths.
inline Two cosine_between(Direction x, Direction y) {
  return cosine_of(x) * cosine_of(y) + sine_of(x) * sine_of(y);
}

/// Throws BadInput unless the direction has unit length to rounding.
void check_direction(const char* name, Direction direction);

}  // namespace nipref::fast::internal
