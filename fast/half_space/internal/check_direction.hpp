#pragma once
#include <fmt/format.h>

#include <cmath>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/half_space/direction.hpp>

namespace nipref::fast::internal {

/// Throws BadInput unless the direction has unit length to rounding.
inline void check_direction(const char* name, Direction direction) {
  const double squared_length = direction.cosine * direction.cosine + direction.sine * direction.sine;
  if (!(std::fabs(squared_length - 1) < 1e-12)) {
    throw data::BadInput(name, fmt::format("({}, {})", direction.cosine, direction.sine),
                         "must be a unit vector");
  }
}

}  // namespace nipref::fast::internal
