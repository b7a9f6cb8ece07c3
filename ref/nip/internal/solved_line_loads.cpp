#include <algorithm>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/nip/internal/solved_line_loads.hpp>
#include <nipref/ref/number/internal/float_interval.hpp>

namespace nipref::ref {

Interval SolvedLineLoads::distance(std::size_t load, const LineLoadPlace& place) const {
  return Interval(place.distance, working_bits()) + length(place.half_elements - half_elements_to(load));
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

bool LengthSearch::seek(int digits, const ContactOf& contact_of) {
  constexpr int most_steps = 60;
  constexpr double least_exponent = 1, longest_step = 2;
  const Float tolerance = pow(Float(10), -digits);
  std::optional<std::pair<Float, Float>> last;  // ln L and ln W - ln load
  for (int step = 0; step < most_steps; ++step) {
    ++systems;
    const auto tried = contact_of({length});
    if (!tried) return false;
    const Float found = middle_of(tried->load());
    if (!(found > Float(0))) {
      length = length / 3;
      continue;
    }
    const Float excess = log(found / Float(load)), log_length = log(length);
    if (abs(excess) <= tolerance) return true;
    if (last && log_length != last->first)
      exponent = std::max<Float>((excess - last->second) / (log_length - last->first), least_exponent);
    last = {log_length, excess};
    const Float change = std::clamp<Float>(-excess / exponent, -longest_step, longest_step);
    length = std::min<Float>(exp(log_length + change), longest);
  }
  throw data::BadInput("load", load, "no contact length was found that carries it");
}

std::optional<SolvedLineLoads> LengthSearch::contact_carrying(int digits, const ContactOf& contact_of) {
  constexpr int beyond = 3;
  if (!seek(digits + beyond, contact_of)) return std::nullopt;
  const Interval wanted(load, working_bits());
  // The sign of W - load, 0 where the bounds do not tell.
  const auto sign_at = [&](const Float& at) {
    ++systems;
    const auto contact = contact_of({at});
    if (!contact) return 0;
    return sign_of(contact->load() - wanted);
  };
  const Lengths lengths{length, pow(Float(10), -digits)};
  // A thousandth within the lengths, so that rounding puts neither outside; the load still changes far more than its error.
  const Float change = length * lengths.spread * (1 - Float(1e-3));
  if (sign_at(length - change) * sign_at(length + change) >= 0) return std::nullopt;
  ++systems;
  auto contact = contact_of(lengths);
  if (contact) contact->systems = systems;
  return contact;
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
