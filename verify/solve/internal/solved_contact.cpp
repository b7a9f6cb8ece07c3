#include <boost/math/quadrature/gauss.hpp>

#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/estimate.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>

namespace nipref::verify {
namespace {

using fast::Estimate;

bool same(const ref::Estimate& a, const ref::Estimate& b) {
  return mpfr_equal_p(ref::raw(a.value), ref::raw(b.value)) != 0 &&
         mpfr_equal_p(ref::raw(a.error), ref::raw(b.error)) != 0;
}

/// int p Y dY from a to b. Next to an end of the contact, which a and b may be, p is like a square root, and the
/// substitution Y = end + reach t^2 makes the integrand smooth.
template <unsigned points>
Estimate moment_by_gauss(const SolvedContact<Estimate>& contact, double a, double b) {
  using Rule = boost::math::quadrature::gauss<double, points>;
  const double middle = a + (b - a) / 2;
  Estimate sum{0, 0};
  const auto add = [&](double end, double node, double weight) {
    const double t = (1 + node) / 2, reach = middle - end, y = end + reach * t * t;
    const double factor = weight * t * std::fabs(reach) * y;
    const Estimate pressure = contact.at(ResultId::pressure, y);
    sum.value += factor * pressure.value;
    sum.error += std::fabs(factor) * (pressure.error + 0x1p-51 * std::fabs(pressure.value));
  };
  for (const double end : {a, b}) {
    for (std::size_t k = 0; k < Rule::abscissa().size(); ++k) {
      const double node = Rule::abscissa()[k], weight = Rule::weights()[k];
      add(end, node, weight);
      if (node != 0) add(end, -node, weight);
    }
  }
  return sum;
}

/// int p Y dY on one side of the line through the rollers' centres (thesis 7.13), by Gauss's rule. The error is the
/// integral of the error of the pressure plus twice the difference from half as many nodes.
Estimate moment_of_pressure(const SolvedContact<Estimate>& contact, bool is_leading) {
  const Estimate leading = contact.number(ResultId::leading_length),
                 trailing = contact.number(ResultId::trailing_length);
  // The whole contact may be ahead of the line through the centres.
  const double a = is_leading ? std::max(0.0, -trailing.value) : -trailing.value;
  const double b = is_leading ? leading.value : 0;
  if (!(b > a)) return {0, 0};
  const Estimate fine = moment_by_gauss<60>(contact, a, b), coarse = moment_by_gauss<30>(contact, a, b);
  return {fine.value, fine.error + 2 * std::fabs(fine.value - coarse.value)};
}

/// The factor of the rolling resistance in `product`, without the load.
template <class Number>
double given_factor(const SolvedContact<Number>& contact, ResultId product) {
  if (product == ResultId::eccentricity) return contact.roller_radius;
  return product == ResultId::power_loss ? contact.speed : 1;
}

/// The rolling resistance in another unit; the error follows from those of the factors:
///   eccentricity = R mu_R, resistance_force = W mu_R, power_loss = speed W mu_R     (thesis 7.12, 7.14, 7.15)
template <class Number>
Number product_of(const SolvedContact<Number>& contact, ResultId id) {
  Number result = contact.number(ResultId::rolling_resistance);
  if (id != ResultId::eccentricity) result = result * contact.number(ResultId::load);
  return result * exactly(given_factor(contact, id), result);
}

/// The velocity of sliding over F_0, the strain of the surface less the creep ratio: by (2.5) the surface moves at
/// F_0 (1 + v') and the rollers at F_0 (1 + creep ratio). Without friction the creep ratio is the mean strain in the
/// contact, so that the mean slip is 0. Outside the contact it is the slip that there would be if the surfaces touched.
ref::Estimate slip_at(const SolvedContact<ref::Estimate>& contact, double y) {
  const ref::Estimate &strain = contact.at(ResultId::surface_strain, y),
                      &creep = contact.number(ResultId::creep_ratio);
  // Where the surface sticks, its strain is the creep ratio.
  if (!same(strain, creep)) return strain - creep;
  ref::Estimate none = exactly(0, strain);
  none.proven = strain.proven;
  return none;
}

/// The heat of a face's slip per area and distance rolled, |q (v' - creep ratio)|.
template <class Number>
Number heat_at(const SolvedContact<Number>& contact, double y) {
  const auto size = [&](ResultId id) {
    const Number& number = contact.at(id, y);
    return number * exactly(std::signbit(value_of(number)) ? -1 : 1, number);
  };
  return size(ResultId::shear) * size(ResultId::slip);
}

/// Answers with results that follow from other results of the contact.
template <class Number>
void answer_by_others(const SolvedContact<Number>& contact, Asked<Number>& asked) {
  if (is_product(asked.id)) asked.set(asked.id, [&] { return product_of(contact, asked.id); });
  asked.set(ResultId::heat, [&](double y) { return heat_at(contact, y); });
  if constexpr (std::is_same_v<Number, Estimate>) {
    asked.set(ResultId::leading_moment, [&] { return moment_of_pressure(contact, true); });
    asked.set(ResultId::trailing_moment, [&] { return moment_of_pressure(contact, false); });
  } else {
    asked.set(ResultId::slip, [&](double y) { return slip_at(contact, y); });
  }
}

/// What the sizes of a contact's results are made of, see data::Scale.
template <class Number>
struct Sizes {
  const SolvedContact<Number>& contact;
  double accuracy;
  bool is_nip = contact.roller_radius > 0;
  ContactEnds ends = contact.ends();
  /// L/2, the slope of a roller at an end, and L/(4R)
  double half = (ends.last - ends.first) / 2, slope = half / contact.roller_radius, creep = slope / 2;

  [[nodiscard]] double number(ResultId id) const { return value_of(contact.number(id)); }
  /// The normal displacement of a half-space below the centre.
  [[nodiscard]] double depth() const { return value_of(contact.at(ResultId::normal_displacement, 0)); }
  [[nodiscard]] double pressure() const {
    return is_nip ? value_of(contact.at(ResultId::pressure, 0)) : number(ResultId::peak_pressure);
  }
  /// The factor by which the size of a traction is larger next to an end of the contact, 1 elsewhere.
  [[nodiscard]] double growth_next_to_end(double y) const {
    const double distance = std::min(std::fabs(y - ends.first), std::fabs(y - ends.last)) / half;
    return std::max(1.0, std::numbers::sqrt2 / (std::sqrt(distance + accuracy) + std::sqrt(distance)));
  }
  [[nodiscard]] double flat_maximum_depth() const { return (1e-6 + 10 * std::sqrt(accuracy)) / accuracy; }
  /// Where little or nothing slips, the resistance is small or 0; the error is measured against what friction could add.
  [[nodiscard]] double rolling_resistance() const {
    return slope * std::min(1.0, 1e-14 / accuracy) + 0.1 * std::min(contact.friction, 1.0) * creep;
  }
};

}  // namespace

bool is_moment(ResultId id) { return id == ResultId::leading_moment || id == ResultId::trailing_moment; }
bool is_product(ResultId id) {
  return id == ResultId::eccentricity || id == ResultId::resistance_force || id == ResultId::power_loss;
}

template <class Number>
const std::vector<Number>& SolvedContact<Number>::get(ResultId id, const Places& places) const {
  if (const auto known = cache_.find({id, places}); known != cache_.end()) return known->second;
  Asked<Number> asked{id, places};
  answer(asked);
  if (asked.answer.empty()) answer_by_others(*this, asked);
  for (auto& [one, numbers] : asked.answer) cache_.try_emplace({one, places}, std::move(numbers));
  if (asked.answer.empty())
    throw data::BadInput("result", data::scene_result(id).name, "must be one that this contact has");
  return cache_.at({id, places});
}

template <class Number>
ContactEnds SolvedContact<Number>::ends() const {
  return {-value_of(number(ResultId::trailing_length)), value_of(number(ResultId::leading_length))};
}

template class SolvedContact<Estimate>;
template class SolvedContact<ref::Estimate>;

template <class Number>
double result_size(const SolvedContact<Number>& contact, ResultId id, double y, double accuracy) {
  using data::Scale;
  const data::SceneResult& result = data::scene_result(id);
  if (contact.measure == Measure::itself && !result.is_inside() && id != ResultId::peak_pressure_position)
    return 0;
  const Sizes<Number> of{contact, accuracy};
  switch (result.scale) {
    case Scale::itself:
      return 0;
    case Scale::half_contact:
      return of.half;
    case Scale::load:
      return of.number(ResultId::load);
    case Scale::half_contact_times_load:
      return of.half * of.number(ResultId::load);
    case Scale::hundred_half_contacts:
      return 100 * of.half;
    case Scale::roller_rise:
      return of.is_nip ? of.half * of.creep : of.depth();
    case Scale::creep:
      return of.creep;
    case Scale::creep_next_to_end:
      return of.creep * of.growth_next_to_end(y);
    case Scale::distance_times_creep:
      return of.is_nip ? of.creep * std::min(std::fabs(y), of.half) : of.depth();
    case Scale::pressure:
      return of.pressure() * of.growth_next_to_end(y);
    case Scale::shear:
      return (of.is_nip ? 0.1 : 1) * of.pressure() * of.growth_next_to_end(y);
    case Scale::tenth_of_pressure:
      return 0.1 * of.pressure();
    case Scale::tenth_of_pressure_times_creep:
      return 0.1 * of.pressure() * of.creep;
    case Scale::flat_maximum_depth:
      return of.flat_maximum_depth();
    case Scale::flat_maximum:
      return of.half * of.flat_maximum_depth();
    case Scale::rolling_resistance:
      return of.rolling_resistance();
    case Scale::product_of_resistance:
      return of.rolling_resistance() * std::fabs(given_factor(contact, id)) *
             (id == ResultId::eccentricity ? 1 : of.number(ResultId::load));
    case Scale::radian:
      return 180 / std::numbers::pi;
    case Scale::span_along:
      return of.number(ResultId::span_along);
    case Scale::compliance:
      return value_of(contact.at(ResultId::compliance, y));
  }
  return 0;
}

template double result_size(const SolvedContact<fast::Estimate>&, ResultId, double, double);
template double result_size(const SolvedContact<ref::Estimate>&, ResultId, double, double);

}  // namespace nipref::verify
