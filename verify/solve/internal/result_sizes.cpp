#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/verify/solve/internal/result_sizes.hpp>

namespace nipref::verify {

using data::ResultId;

namespace {

/// Of a traction over its size in the middle: |sqrt(x + accuracy) - sqrt(x)|, as part of the accuracy, at the
/// distance x from the end, in half contacts; sqrt(2 x) is the traction.
double size_next_to_end(double y, const NipSize& nip, double half) {
  const double x = std::min(std::fabs(y - nip.first), std::fabs(y - nip.last)) / half;
  return std::max(1.0, std::numbers::sqrt2 / (std::sqrt(x + nip.accuracy) + std::sqrt(x)));
}

}  // namespace

std::optional<double> inside_result_size(ResultId id, double y, const NipSize& nip,
                                         const std::function<double()>& pressure_in_the_middle) {
  const double half = (nip.last - nip.first) / 2;
  if (data::scene_result(id).shape == data::Shape::field)
    return pressure_in_the_middle() * size_next_to_end(y, nip, half);
  const double place = (1e-6 + 10 * std::sqrt(nip.accuracy)) / nip.accuracy;
  if (id == ResultId::greatest_shear_position) return half * place;
  if (id == ResultId::greatest_shear_depth) return place;
  return {};
}

double nip_result_size(ResultId id, double y, const NipSize& nip,
                       const std::function<double()>& pressure_in_the_middle) {
  const double half = (nip.last - nip.first) / 2, slope = half / nip.roller_radius;
  if (id == ResultId::edge_displacement || id == ResultId::trailing_displacement ||
      id == ResultId::normal_displacement)
    return half * slope / 2;
  if (id == ResultId::creep_ratio) return slope / 2;
  if (id == ResultId::surface_strain || id == ResultId::slip)
    return slope / 2 * size_next_to_end(y, nip, half);
  if (id == ResultId::tangential_displacement) return slope / 2 * std::min(std::fabs(y), half);
  if (id == ResultId::leading_length || id == ResultId::trailing_length) return half;
  if (id == ResultId::pressure) return pressure_in_the_middle() * size_next_to_end(y, nip, half);
  if (id == ResultId::shear) return 0.1 * pressure_in_the_middle() * size_next_to_end(y, nip, half);
  if (id == ResultId::peak_shear) return 0.1 * pressure_in_the_middle();
  if (const auto inside = inside_result_size(id, y, nip, pressure_in_the_middle)) return *inside;
  // A traction's slope is known less well than itself, and what moves its zero by more than its own part of a length.
  if (id == ResultId::peak_pressure_position || id == ResultId::peak_shear_position ||
      id == ResultId::shear_zeros)
    return 100 * half;
  if (id == ResultId::rolling_resistance) return slope * std::min(1.0, 1e-14 / nip.accuracy);
  return 0;
}

double traction_size(double x, double first, double last, double accuracy) {
  return size_next_to_end(x, {0, first, last, accuracy}, (last - first) / 2);
}

double half_space_result_size(ResultId id, const std::function<double()>& compliance) {
  if (id == ResultId::orientation) return 180 / std::numbers::pi;
  if (id == ResultId::coupling) return compliance();
  return 0;
}

}  // namespace nipref::verify
