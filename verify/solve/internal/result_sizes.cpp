#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/verify/solve/internal/solved_contact.hpp>

namespace nipref::verify {
namespace {

/// The factor by which the size of a traction is larger next to an end of the contact, 1 elsewhere.
double growth_next_to_end(double y, const ContactEnds& ends, double accuracy) {
  const double half = (ends.last - ends.first) / 2;
  const double distance = std::min(std::fabs(y - ends.first), std::fabs(y - ends.last)) / half;
  return std::max(1.0, std::numbers::sqrt2 / (std::sqrt(distance + accuracy) + std::sqrt(distance)));
}

}  // namespace

template <class Number>
double result_size(const SolvedContact<Number>& contact, ResultId id, double y, double accuracy) {
  using data::Scale;
  const data::SceneResult& result = data::scene_result(id);
  if (contact.measure == Measure::itself && !result.is_inside()) return 0;
  const bool is_nip = contact.roller_radius > 0;
  const ContactEnds ends = contact.ends();
  const double half = (ends.last - ends.first) / 2, slope = half / contact.roller_radius;
  const double flat_maximum = (1e-6 + 10 * std::sqrt(accuracy)) / accuracy;
  const double rounding_of_slope = slope * std::min(1.0, 1e-14 / accuracy);
  const auto growth = [&] { return growth_next_to_end(y, ends, accuracy); };
  const auto pressure = [&] {
    return value_of(is_nip ? contact.at(ResultId::pressure, 0) : contact.number(ResultId::peak_pressure));
  };
  switch (result.scale) {
    case Scale::itself:
      return 0;
    case Scale::half_contact:
      return half;
    case Scale::half_contact_times_load:
      return half * value_of(contact.number(ResultId::load));
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
      return pressure() * growth();
    case Scale::shear:
      return (is_nip ? 0.1 : 1) * pressure() * growth();
    case Scale::tenth_of_pressure:
      return 0.1 * pressure();
    case Scale::flat_maximum_depth:
      return flat_maximum;
    case Scale::flat_maximum:
      return half * flat_maximum;
    case Scale::rounding_of_slope:
      return rounding_of_slope;
    case Scale::rolling_resistance:
      return rounding_of_slope * product_factor(contact, id);
    case Scale::radian:
      return 180 / std::numbers::pi;
    case Scale::span_along:
      return value_of(contact.number(ResultId::span_along));
    case Scale::compliance:
      return value_of(contact.at(ResultId::compliance, y));
  }
  return 0;
}

template double result_size(const SolvedContact<fast::Estimate>&, ResultId, double, double);
template double result_size(const SolvedContact<ref::Estimate>&, ResultId, double, double);

}  // namespace nipref::verify
