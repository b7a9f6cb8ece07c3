#pragma once
#include <cmath>

#include <nipref/data/bad_input.hpp>

namespace nipref::fast::internal {

inline void check_positive(const char* name, double value) {
  if (!(value > 0) || !std::isfinite(value)) throw data::BadInput(name, value, "must be positive and finite");
}

}  // namespace nipref::fast::internal
