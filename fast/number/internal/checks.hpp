#pragma once
#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include <nipref/data/bad_input.hpp>

namespace nipref::fast::internal {

// Each function throws BadInput unless `value` is as the function's name says.

inline void check_finite(std::string_view name, double value) {
  if (!std::isfinite(value)) throw data::BadInput(name, value, "must be a finite number");
}

inline void check_not_negative(std::string_view name, double value) {
  if (!(std::isfinite(value) && value >= 0)) throw data::BadInput(name, value, "must be finite and >= 0");
}

inline void check_positive(std::string_view name, double value) {
  if (!(std::isfinite(value) && value > 0)) throw data::BadInput(name, value, "must be finite and > 0");
}

inline void check_range(std::string_view name, int value, int least, int most) {
  if (value < least || value > most)
    throw data::BadInput(name, value, fmt::format("must be from {} to {}", least, most));
}

}  // namespace nipref::fast::internal
