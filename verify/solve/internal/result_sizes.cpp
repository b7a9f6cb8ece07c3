#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/verify/solve/internal/result_sizes.hpp>

namespace nipref::verify {
namespace {

/// Of a traction over its size in the middle: |sqrt(x + accuracy) - sqrt(x)|, as part of the accuracy, at the
/// distance x from the end, in half contacts; sqrt(2 x) is the traction.
double size_next_to_end(double y, const NipSize& nip, double half) {
  const double x = std::min(std::fabs(y - nip.first), std::fabs(y - nip.last)) / half;
  return std::max(1.0, std::numbers::sqrt2 / (std::sqrt(x + nip.accuracy) + std::sqrt(x)));
}

}  // namespace

std::optional<double> inside_result_size(std::string_view name, double y, const NipSize& nip,
                                         const std::function<double()>& pressure_in_the_middle) {
  const double half = (nip.last - nip.first) / 2;
  if (name.starts_with("stress_") || name == "highest_stress" || name == "lowest_stress" ||
      name == "maximum_shear")
    return pressure_in_the_middle() * size_next_to_end(y, nip, half);
  const double place = (1e-6 + 10 * std::sqrt(nip.accuracy)) / nip.accuracy;
  if (name == "greatest_shear_position") return half * place;
  if (name == "greatest_shear_depth") return place;
  return {};
}

double nip_result_size(std::string_view name, double y, const NipSize& nip,
                       const std::function<double()>& pressure_in_the_middle) {
  const double half = (nip.last - nip.first) / 2, slope = half / nip.roller_radius;
  if (name == "edge_displacement" || name == "trailing_displacement" || name == "normal_displacement")
    return half * slope / 2;
  if (name == "creep_ratio") return slope / 2;
  if (name == "surface_strain" || name == "slip") return slope / 2 * size_next_to_end(y, nip, half);
  if (name == "tangential_displacement") return slope / 2 * std::min(std::fabs(y), half);
  if (name == "leading_length" || name == "trailing_length") return half;
  if (name == "pressure") return pressure_in_the_middle() * size_next_to_end(y, nip, half);
  if (name == "shear") return 0.1 * pressure_in_the_middle() * size_next_to_end(y, nip, half);
  if (name == "peak_shear") return 0.1 * pressure_in_the_middle();
  if (const auto inside = inside_result_size(name, y, nip, pressure_in_the_middle)) return *inside;
  // A traction's slope is known less well than itself, and what moves its zero by more than its own part of a length.
  if (name == "peak_pressure_position" || name == "peak_shear_position" || name == "shear_zeros")
    return 100 * half;
  if (name == "rolling_resistance") return slope * std::min(1.0, 1e-14 / nip.accuracy);
  return 0;
}

double traction_size(double x, double first, double last, double accuracy) {
  return size_next_to_end(x, {0, first, last, accuracy}, (last - first) / 2);
}

double half_space_result_size(std::string_view name, const std::function<double()>& compliance) {
  if (name == "orientation") return 180 / std::numbers::pi;
  if (name == "coupling") return compliance();
  return 0;
}

}  // namespace nipref::verify
