#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/nip/internal/solved_line_loads.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {
namespace {

using data::BadInput;

std::vector<Interval> sizes_of(const std::vector<Interval>& loads) {
  std::vector<Interval> sizes;
  for (const Interval& load : loads) sizes.push_back(abs(load));
  return sizes;
}

/// The largest load, in a symmetric nip of the leading side, and the hull of the centres of elements that may have it.
struct Peak {
  Interval load, place;
};

Peak peak_of(const SolvedLineLoads& nip, const std::vector<Interval>& loads) {
  const auto count = static_cast<std::size_t>(nip.is_symmetric ? nip.leading_elements : nip.elements());
  Interval largest = loads.front();
  for (std::size_t j = 1; j < count; ++j) largest = larger_of(largest, loads[j]);
  std::optional<Interval> place;
  for (std::size_t j = 0; j < count; ++j) {
    if (mpfr_less_p(loads[j].upper(), largest.lower()) != 0) continue;
    const Interval here = nip.length(nip.half_elements_to(j));
    place = place ? hull(*place, here) : here;
  }
  return {largest, *place};
}

/// The load of the element around y over its width; nothing outside the contact.
std::optional<Interval> density_at(const SolvedLineLoads& nip, const std::vector<Interval>& loads, double y) {
  if (!std::isfinite(y)) throw BadInput("y", y, "must be finite");
  if (loads.empty()) return std::nullopt;
  if (nip.is_symmetric) y = -std::fabs(y);
  const double length = middle_of(nip.contact_length).convert_to<double>();
  const double width = length / nip.elements(), leading = width * nip.leading_elements;
  const double ahead = leading - y, border = 0x1p-50 * leading;
  if (ahead < -border || ahead > length + border) return std::nullopt;
  const auto element = static_cast<std::size_t>(std::max(0.0, ahead + border) / width);
  return loads[std::min(element, loads.size() - 1)] / nip.length(2);
}

LineLoadPlace place_beside_loads(const SolvedLineLoads& nip, double y) {
  if (!std::isfinite(y)) throw BadInput("y", y, "must be finite");
  LineLoadPlace place{mpq_class(y), 0};
  for (std::size_t j = 0; j < nip.normal.size(); ++j) {
    if (mpfi_has_zero(nip.distance(j, place).get()) != 0)
      throw BadInput("y", y, "must not be the place of a line load");
  }
  return place;
}

}  // namespace

LineLoadNip::LineLoadNip(SolvedLineLoads solved, int digits, int working_digits)
    : solved_(std::make_shared<const SolvedLineLoads>(std::move(solved))),
      digits_(digits),
      working_digits_(working_digits) {}

Enclosure LineLoadNip::enclosed(const auto& function) const {
  const WorkingDigits scope(working_digits_);
  return enclosure_of(std::invoke(function, *solved_), digits_);
}

Enclosure LineLoadNip::contact_length() const { return enclosed(&SolvedLineLoads::contact_length); }
Enclosure LineLoadNip::leading_length() const { return enclosed(&SolvedLineLoads::leading_length); }
Enclosure LineLoadNip::trailing_length() const { return enclosed(&SolvedLineLoads::trailing_length); }
Enclosure LineLoadNip::indentation() const { return enclosed(&SolvedLineLoads::indentation); }
Enclosure LineLoadNip::leading_displacement() const {
  return enclosed([](const SolvedLineLoads& of) { return of.on_roller(of.leading_length()); });
}
Enclosure LineLoadNip::trailing_displacement() const {
  return enclosed([](const SolvedLineLoads& of) { return of.on_roller(of.trailing_length()); });
}
Enclosure LineLoadNip::load() const { return enclosed(&SolvedLineLoads::load); }

Enclosure LineLoadNip::peak_pressure() const {
  return enclosed([&](const SolvedLineLoads& of) { return peak_of(of, of.normal).load / of.length(2); });
}
Enclosure LineLoadNip::peak_pressure_position() const {
  return enclosed([&](const SolvedLineLoads& of) { return peak_of(of, of.normal).place; });
}
Enclosure LineLoadNip::peak_shear() const {
  if (solved_->shear.empty()) return exact_zero(digits_);
  return enclosed(
      [&](const SolvedLineLoads& of) { return peak_of(of, sizes_of(of.shear)).load / of.length(2); });
}
Enclosure LineLoadNip::peak_shear_position() const {
  return enclosed([&](const SolvedLineLoads& of) { return peak_of(of, sizes_of(of.shear)).place; });
}

Enclosure LineLoadNip::leading_moment() const {
  return enclosed([&](const SolvedLineLoads& of) { return of.moment(1); });
}
Enclosure LineLoadNip::trailing_moment() const {
  return enclosed([&](const SolvedLineLoads& of) { return of.moment(-1); });
}
Enclosure LineLoadNip::rolling_resistance() const {
  if (solved_->is_symmetric) return exact_zero(digits_);
  return enclosed([&](const SolvedLineLoads& of) {
    return (of.moment(1) + of.moment(-1)) / (of.load() * Interval(of.roller_radius, working_bits()));
  });
}

Enclosure LineLoadNip::creep_ratio() const {
  return enclosed([&](const SolvedLineLoads& of) {
    if (of.gripped_creep) return *of.gripped_creep;
    const long leading = 2L * of.leading_elements, all = 2L * of.elements();
    const auto at = [&](long half_elements) { return of.displacement({0, half_elements}, false); };
    if (of.is_symmetric) return at(leading) / of.length(leading);
    return (at(leading) - at(leading - all)) / of.contact_length;
  });
}

CreepRange LineLoadNip::creep_range() const {
  const WorkingDigits scope(working_digits_);
  const auto range = thesis_creep(solved_->at_zero, solved_->per_creep);
  if (!range || !range->lower || !range->upper)
    throw BadInput(
        "contact_length", contact_length().to_double(),
        "must be one for which some creep meets the thesis's conditions, and the bounds tell which");
  return {enclosure_of(*range->lower, digits_), enclosure_of(*range->upper, digits_),
          enclosure_of(range->chosen, digits_)};
}

std::vector<Enclosure> LineLoadNip::shear_zeros() const {
  std::vector<Enclosure> zeros;
  const auto& loads = solved_->shear;
  if (loads.empty()) return zeros;
  zeros.push_back(exact_zero(digits_));
  long last_border = 0;
  int last_sign = 0;
  for (auto load = static_cast<std::size_t>(solved_->leading_elements); load-- > 0;) {
    const int sign = sign_of(loads[load]);
    if (sign == 0) continue;
    const long inner = solved_->half_elements_to(load) - 1;
    if (last_sign != 0 && sign != last_sign)
      zeros.push_back(enclosed(
          [&](const SolvedLineLoads& of) { return hull(of.length(last_border), of.length(inner)); }));
    last_border = inner + 2;
    last_sign = sign;
  }
  return zeros;
}

Enclosure LineLoadNip::pressure(double y) const {
  const WorkingDigits scope(working_digits_);
  const auto density = density_at(*solved_, solved_->normal, y);
  return density ? enclosure_of(*density, digits_) : exact_zero(digits_);
}
Enclosure LineLoadNip::shear(double y) const {
  const WorkingDigits scope(working_digits_);
  const auto trailing = density_at(*solved_, solved_->shear, y);
  if (!trailing) return exact_zero(digits_);
  return enclosure_of(std::signbit(y) ? *trailing : -*trailing, digits_);
}

Enclosure LineLoadNip::normal_displacement(double y) const {
  return enclosed(
      [&](const SolvedLineLoads& of) { return of.displacement(place_beside_loads(of, y), true); });
}
Enclosure LineLoadNip::tangential_displacement(double y) const {
  if (y == 0) return exact_zero(digits_);
  return enclosed([&](const SolvedLineLoads& of) {
    const Interval to_point = of.displacement(place_beside_loads(of, y), false);
    return of.is_symmetric ? to_point : to_point - of.displacement({0, 0}, false);
  });
}

std::vector<FaceLoad> LineLoadNip::face_loads() const {
  std::vector<FaceLoad> loads;
  for (std::size_t j = 0; j < solved_->normal.size(); ++j) {
    const auto force = [&](const std::vector<Interval>& all) {
      return all.empty() ? exact_zero(digits_) : enclosed([&](const SolvedLineLoads&) { return all[j]; });
    };
    loads.push_back({enclosed([&](const SolvedLineLoads& of) { return of.length(of.half_elements_to(j)); }),
                     force(solved_->normal), force(solved_->shear)});
  }
  return loads;
}

int LineLoadNip::systems() const { return solved_->systems; }
int LineLoadNip::unknowns() const { return solved_->unknowns; }
double LineLoadNip::condition() const { return static_cast<double>(solved_->condition); }

}  // namespace nipref::ref
