#include <nipref/data/internal/common.hpp>
#include <nipref/data/magnitude.hpp>

namespace nipref::data {

bool is_magnitude(double value) { return value >= least_magnitude && value <= greatest_magnitude; }

std::string_view allowed_magnitude(double value) {
  if (!(std::isfinite(value) && value > 0)) return "must be finite and > 0";
  return "must be from 1e-60 to 1e60: beyond, products of such numbers leave the range of doubles";
}

void check_magnitude(std::string_view argument, double value) {
  if (!is_magnitude(value)) throw BadInput(argument, value, allowed_magnitude(value));
}

}  // namespace nipref::data
