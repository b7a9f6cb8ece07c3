#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/nip/internal/domain.hpp>

namespace nipref::fast {
namespace {

using data::BadInput;

constexpr double shortest = 1e-8, longest = 1e4;  // L/B

std::string allowed_length(const NipShape& shape) {
  return fmt::format(
      "must be from {:g} to {:g}: 1e-8 to 1e4 sheet thicknesses and at most the roller's radius, beyond "
      "which a parabola no longer stands for the roller",
      shortest * shape.sheet_thickness, std::min(longest * shape.sheet_thickness, shape.roller_radius));
}

bool length_is_allowed(const NipShape& shape, double contact_length) {
  return contact_length >= shortest * shape.sheet_thickness &&
         contact_length <= longest * shape.sheet_thickness && contact_length <= shape.roller_radius;
}

}  // namespace

ContactUnits::ContactUnits(const NipShape& shape, double compliance)
    : length(shape.sheet_thickness / 2),
      displacement(length / (2 * shape.roller_radius) * length),
      pressure(length / (2 * shape.roller_radius) / compliance),
      load(pressure * length),
      creep(length / (2 * shape.roller_radius)) {}

Estimate times(double unit, const Estimate& estimate) {
  return {unit * estimate.value + 0.0, std::fabs(unit) * estimate.error};
}

void check_contact_accuracy(double accuracy) {
  if (!(accuracy >= 1e-13 && accuracy <= 0.1))
    throw BadInput("accuracy", accuracy, "must be from 1e-13 to 0.1");
}

void check_contact_length(const NipShape& shape, double contact_length) {
  if (!length_is_allowed(shape, contact_length))
    throw BadInput("contact_length", contact_length, allowed_length(shape));
}

void check_length_of_load(const NipShape& shape, double load, double contact_length) {
  if (!length_is_allowed(shape, contact_length)) {
    throw BadInput("load", load,
                   fmt::format("must give an allowed contact length, not {:g}; {}", contact_length,
                               allowed_length(shape)));
  }
}

}  // namespace nipref::fast
