#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/verify/solve/internal/result_sizes.hpp>

namespace nipref::verify {

using data::Scale;

double growth_next_to_end(double x, double first, double last, double accuracy) {
  const double distance = std::min(std::fabs(x - first), std::fabs(x - last)) / ((last - first) / 2);
  return std::max(1.0, std::numbers::sqrt2 / (std::sqrt(distance + accuracy) + std::sqrt(distance)));
}

double nip_result_size(data::ResultId id, double y, const NipSize& nip,
                       const std::function<double()>& pressure_in_the_middle) {
  const double half = (nip.last - nip.first) / 2, slope = half / nip.roller_radius;
  const auto growth = [&] { return growth_next_to_end(y, nip.first, nip.last, nip.accuracy); };
  const double flat_maximum = (1e-6 + 10 * std::sqrt(nip.accuracy)) / nip.accuracy;
  switch (data::scene_result(id).scale) {
    case Scale::half_contact:
      return half;
    case Scale::hundred_half_contacts:
      return 100 * half;
    case Scale::roller_rise:
      return half * slope / 2;
    case Scale::creep:
      return slope / 2;
    case Scale::creep_next_to_end:
      return slope / 2 * growth();
    case Scale::distance_times_creep:
      return slope / 2 * std::min(std::fabs(y), half);
    case Scale::pressure:
      return pressure_in_the_middle() * growth();
    case Scale::shear:
      return 0.1 * pressure_in_the_middle() * growth();
    case Scale::tenth_of_pressure:
      return 0.1 * pressure_in_the_middle();
    case Scale::flat_maximum_depth:
      return flat_maximum;
    case Scale::flat_maximum:
      return half * flat_maximum;
    case Scale::rounding_of_slope:
      return slope * std::min(1.0, 1e-14 / nip.accuracy);
    default:
      return 0;
  }
}

}  // namespace nipref::verify
