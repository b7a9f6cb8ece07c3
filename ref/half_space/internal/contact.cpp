#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/internal/contact.hpp>
#include <nipref/ref/number/internal/cache.hpp>
#include <nipref/ref/number/internal/unit_rule.hpp>

namespace nipref::ref {
namespace {

constexpr int most_digits = 100;
constexpr int guard_digits = 12;
constexpr long most_directions = 4096;

[[noreturn]] void refuse_digits(int digits) {
  throw data::BadInput("digits", std::to_string(digits),
                       "must be fewer, the speed farther below the critical one or the body rounder: " +
                           std::to_string(most_directions) + " lines do not give them here");
}

Float at_most_1(const Float& value) { return std::min(Float(1), Float(abs(value))); }

Float number(const Float& real) {
  if (mpfr_number_p(raw(real)) == 0)
    throw data::BadInput("surface", mpfr_nan_p(raw(real)) != 0 ? "nan" : "infinite",
                         "must answer with finite numbers");
  return at_working_precision(real);
}

/// Digits and the working precision, to which the nodes are made.
using UnitKey = std::pair<int, mpfr_prec_t>;
using UnitNodes = std::vector<UnitNode>;

UnitNodes made_nodes(const UnitKey& key) {
  const int digits = key.first;
  const Float step = Float(1) / (digits + 20) * 2;
  // The last node: from here on the weights are below 10^-digits even times an algebraic singularity at the end.
  const int last =
      static_cast<int>((std::asinh(2.3026 * (digits + 10) / 3.14159) + 0.5) / static_cast<double>(step));
  UnitNodes nodes;
  for (int i = -last; i <= last; ++i) {
    const UnitPoint at(i * step);
    nodes.push_back({at.from_left, at.from_right, log(at.from_right), step * at.slope});
  }
  return nodes;
}

std::size_t size_of_nodes(const UnitNodes& nodes) {
  const std::size_t bits = nodes.empty() ? 0 : static_cast<std::size_t>(bits_of(nodes[0].left));
  return nodes.size() * (sizeof(UnitNode) + 4 * (bits / 8 + 16));
}

}  // namespace

LineAnswer WorkingSurface::at(const Exact& degrees) const {
  LineAnswer line = answer_(degrees, digits_);
  for (Float* real : {&line.compliance, &line.coupling, &line.coupling_across, &line.in_line,
                      &line.shear_compliance, &line.shear_compliance_across})
    *real = ldexp(number(*real), exponent_);
  return line;
}

long stress_exponent(const SurfaceAnswer& surface) {
  constexpr int enough = 16;
  const Float compliance = surface(Exact(0.0), enough).compliance;
  return mpfr_regular_p(raw(compliance)) != 0 ? -mpfr_get_exp(raw(compliance)) : 0;
}

Float tolerance(int digits) { return pow(Float(10), -digits); }

int working_digits(int digits, int cancelled) {
  if (digits < 16 || digits > most_digits)
    throw data::BadInput("digits", std::to_string(digits),
                         "must be from 16 to " + std::to_string(most_digits));
  return digits + guard_digits + cancelled;
}

Estimate estimated(const Float& value, const Float& error, int digits) {
  // Two results may agree to the last bit; then the error is that of rounding and of the surface's digits.
  const Float sum = error + tolerance(digits + guard_digits / 2) * at_most_1(value);
  if (!(sum <= tolerance(digits) * at_most_1(value))) refuse_digits(digits);
  return {value, sum, digits};
}

Estimate of_levels(const Float& fine, const Float& coarse, int digits) {
  const Float rounding = tolerance(digits + guard_digits / 2) * abs(fine);
  return {fine, abs(fine - coarse) + rounding, digits};
}

Estimate with_shifted_ends(int digits, const std::function<Estimate(const Float& change)>& at) {
  const Float off = tolerance(digits + 6);
  const Estimate result = at(0);
  const Float value = at_working_precision(result.value);
  const auto moved = [&](const Float& change) -> Float {
    return abs(at_working_precision(at(change).value) - value);
  };
  return {result.value, at_working_precision(result.error) + std::max(moved(off), moved(-off)), digits};
}

Float span_along_of(const HalfSpaceLoad& load, const Float& factor) {
  if (const auto* span = std::get_if<data::GivenSpan>(&load)) return span->along;
  return pow(std::get<data::GivenNormalForce>(load).force / factor, Float(1) / 3);
}

Float force_of(const HalfSpaceLoad& load, const Float& factor) {
  if (const auto* force = std::get_if<data::GivenNormalForce>(&load)) return force->force;
  const Float span = span_along_of(load, factor);
  return factor * span * span * span;
}

ScaledContact::ScaledContact(SurfaceAnswer of_surface, const HalfSpaceLoad& given, int asked, int cancelled)
    : surface(std::move(of_surface)),
      load(given),
      digits(asked),
      working(working_digits(asked, cancelled)),
      exponent(stress_exponent(surface)) {}

const Levels& ScaledContact::factor() const {
  if (!factor_) {
    const auto [fine, coarse] = integrated();
    factor_ = {ldexp(fine, exponent), ldexp(coarse, exponent)};
  }
  return *factor_;
}

Estimate ScaledContact::function_of_factor(const Function& function) const {
  const WorkingDigits scope(working);
  return of_levels(function(factor().fine), function(factor().coarse), digits);
}

Estimate ScaledContact::function_of_span(const Function& function) const {
  if (const auto* given = std::get_if<data::GivenSpan>(&load)) {
    const WorkingDigits scope(working);
    const Float value = function(Float(given->along));
    return of_levels(value, value, digits);
  }
  return function_of_factor([&](const Float& found) { return function(span_along_of(load, found)); });
}

Estimate ScaledContact::span_ratio(const Exact& degrees) const {
  const WorkingDigits scope(working);
  const Float found = ratio(degrees);
  return of_levels(found, found, digits);
}

Estimate ScaledContact::span(const Exact& degrees) const {
  const WorkingDigits scope(working);
  const Float found = ratio(degrees);
  return function_of_span([&](const Float& along) -> Float { return found * along; });
}

Estimate ScaledContact::force() const {
  return function_of_factor([&](const Float& found) { return force_of(load, found); });
}

std::shared_ptr<const UnitNodes> unit_nodes(int digits) {
  static Cache<UnitKey, UnitNodes> kept(made_nodes, size_of_nodes, std::size_t{1} << 26);
  return kept.at({digits, working_bits()});
}

Float unit_integral(int digits, const std::function<Float(const UnitNode& node)>& f) {
  Float sum = 0;
  const auto nodes = unit_nodes(digits);
  for (const UnitNode& node : *nodes) sum += f(node) * node.weight;
  return sum;
}

Levels half_turn_integral(int digits, const CrowdedDirections& directions,
                          const std::function<Float(const Exact& degrees)>& value) {
  Levels levels;
  double_directions(digits, directions, value, [&](const std::vector<DirectionValue>& values) {
    Float total = 0;
    for (const auto& [at, term] : values) total += at.weight * term;
    levels.coarse = levels.fine;
    const auto count = static_cast<long>(values.size());
    levels.fine = total / count;
    const Float change = abs(levels.fine - levels.coarse);
    // Once the sums converge, each doubling doubles their digits. If the digits will not suffice, no more are computed.
    const double known = -std::log10(std::max(static_cast<double>(change / levels.fine), 1e-300));
    if (count >= 256 && 1.25 * known * static_cast<double>(most_directions / count) < digits)
      refuse_digits(digits);
    return change <= tolerance(digits) * abs(levels.fine) / 10;
  });
  return levels;
}

void double_directions(int digits, const CrowdedDirections& directions,
                       const std::function<Float(const Exact& degrees)>& value,
                       const std::function<bool(const std::vector<DirectionValue>& values)>& settled) {
  std::vector<DirectionValue> values;
  for (long count = 8; count <= most_directions; count *= 2) {
    std::vector<DirectionValue> finer;
    for (long i = 0; i < count; ++i) {
      if (!values.empty() && i % 2 == 0) {
        finer.push_back(std::move(values[static_cast<std::size_t>(i / 2)]));
      } else {
        auto at = directions.at(i, count);
        Float found = value(at.degrees);
        finer.push_back({std::move(at), std::move(found)});
      }
    }
    values = std::move(finer);
    if (settled(values)) return;
  }
  refuse_digits(digits);
}

}  // namespace nipref::ref
