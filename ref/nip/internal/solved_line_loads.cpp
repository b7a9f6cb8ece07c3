#include <algorithm>

#include <nipref/ref/nip/internal/solved_line_loads.hpp>

namespace nipref::ref {

Interval SolvedLineLoads::distance(std::size_t load, const LineLoadPlace& place) const {
  return Interval(place.distance, working_bits()) + length(place.half_elements - half_elements_to(load));
}

Interval SolvedLineLoads::on_roller(const Interval& y) const {
  return indentation - square(y) / (2 * Interval(roller_radius, working_bits()));
}

Interval SolvedLineLoads::moment(int side) const {
  Interval total(working_bits());
  for (std::size_t j = 0; j < normal.size(); ++j) {
    const long place = half_elements_to(j);
    if (side * place > 0) total = total + normal[j] * length(place);
  }
  return total;
}

Interval SolvedLineLoads::load() const {
  Interval sum(working_bits());
  for (const Interval& force : normal) sum = sum + force;
  return sum;
}

Interval SolvedLineLoads::displacement(const LineLoadPlace& place, bool is_normal) const {
  Interval sum(working_bits());
  for (std::size_t load = 0; load < normal.size(); ++load) sum = sum + under(*this, load, place, is_normal);
  return sum;
}

std::optional<bool> SolvedLineLoads::presses_everywhere() const {
  if (std::ranges::any_of(normal, [](const Interval& load) { return sign_of(load) < 0; })) return false;
  if (std::ranges::all_of(normal, [](const Interval& load) { return mpfr_sgn(load.lower()) >= 0; }))
    return true;
  return std::nullopt;
}

std::optional<LineLoadNip> solved_until(
    int digits, const ExtraDigits& extra,
    const std::function<std::optional<SolvedLineLoads>(int influence_digits)>& contact_at,
    const std::function<bool(const SolvedLineLoads&)>& enough) {
  for (int more = extra.first; more <= extra.most; more += more) {
    const int working_digits = digits + more + rounding_digits_of_loads;
    const WorkingDigits scope(working_digits);
    auto contact = contact_at(digits + more);
    if (contact && enough(*contact)) return LineLoadNip(*std::move(contact), digits, working_digits);
  }
  return std::nullopt;
}

std::optional<LineLoadNip> solved_to(
    int digits, const ExtraDigits& extra,
    const std::function<std::optional<SolvedLineLoads>(int influence_digits)>& contact_at) {
  return solved_until(digits, extra, contact_at, [&](const SolvedLineLoads& contact) {
    return contact.error <= pow(Float(10), -(digits + spare_digits_of_loads));
  });
}

}  // namespace nipref::ref
