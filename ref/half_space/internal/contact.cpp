#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/internal/contact.hpp>
#include <nipref/ref/number/internal/chebyshev_sum.hpp>

namespace nipref::ref {
namespace {

/// The complete elliptic integral K(k) for the complementary modulus k'.
Float quarter_period(const Float& complement) {
  Float mean;
  mpfr_agm(raw(mean), raw(Float(1)), raw(complement), MPFR_RNDN);
  return pi() / (2 * mean);
}

/// k', kept below 1, because K(k') is infinite for k' = 1.
Float apart(const Float& complement) { return std::min(complement, Float(0.75)); }

double reciprocal(const SurfaceAnswer& surface, double degrees) {
  const LineAnswer line = surface(Exact(degrees), 16);
  return 1 / mpfr_get_d(raw(line.compliance), MPFR_RNDN);
}

}  // namespace

CrowdedDirections::CrowdedDirections(const Exact& centre, const Float& smallest, const Float& largest)
    : centre_(centre),
      smallest_(smallest),
      complement_(apart(smallest / largest)),
      quarter_(quarter_period(complement_)),
      conjugate_(quarter_period(sqrt((1 - complement_) * (1 + complement_)))) {}

// The Fourier series of sn on the imaginary axis. All its terms are positive.
Float CrowdedDirections::sc(const Float& u) const {
  const Float nome = exp(-pi() * quarter_ / conjugate_), growth = exp(pi() * u / (2 * conjugate_));
  const Float square = growth * growth;
  Float sum = 0, up = growth, down = 1 / growth, power = sqrt(nome);  // exponents 2n + 1, -2n - 1, n + 1/2
  for (;;) {
    const Float term = power / (1 - power * power) * (up - down) / 2;
    sum += term;
    if (!(term > std::numeric_limits<Float>::epsilon() * sum)) break;
    up *= square;
    down /= square;
    power *= nome;
  }
  return 2 * pi() / (complement_ * conjugate_) * sum;
}

CrowdedDirections::Direction CrowdedDirections::at(long i, long count) const {
  const Float share = Float(2 * i) / count - 1;  // u/K
  const Float magnitude = abs(share), near = std::min(magnitude, Float(1 - magnitude));
  // sc(u) is sn/cn, from sc(u) near the centre, otherwise from 1/sc(u) = k' sc(K - u); only the ratio counts.
  const bool is_near_centre = magnitude <= Float(0.5);
  const Float sc_near = sc(near * quarter_);
  const Float sn = is_near_centre ? sc_near : Float(1);
  const Float cn = is_near_centre ? Float(1) : Float(complement_ * sc_near);
  const Float sn2 = sn * sn, cn2 = cn * cn, k2 = complement_ * complement_, s2 = smallest_ * smallest_;
  const Float slope = sqrt((cn2 + sn2) * (cn2 + k2 * sn2)) / (cn2 + s2 * sn2);  // dpsi/du over smallest_
  const Float tangent = is_near_centre ? Float(smallest_ * sn) : Float(cn / smallest_);
  const Float from_end = atan(tangent) * 180 / pi();  // degrees from the centre, or from the line across it
  Exact from_centre = is_near_centre ? to_exact(from_end) : Exact(mpq_class(90 - to_exact(from_end).value()));
  if (share < 0) from_centre = Exact(mpq_class(-from_centre.value()));
  const Exact degrees(mpq_class(centre_.value() + from_centre.value()));
  const Float angle = to_float(degrees) * pi() / 180;
  const Float across = to_float(mpq_class(90 - degrees.value())) * pi() / 180;
  return {degrees, sin(across), sin(angle), smallest_ * slope * 2 * quarter_};
}

PeakOfCompliance peak_of_compliance(const SurfaceAnswer& surface) {
  constexpr int scan = 5;
  double best = 0, least = reciprocal(surface, best), width = 1;
  for (int degrees = scan - 90; degrees <= 90; degrees += scan) {
    const double value = reciprocal(surface, degrees);
    if (value < least) {
      best = degrees;
      least = value;
    }
  }
  for (double step = scan; step > 1e-3; step /= 8) {
    const double left = reciprocal(surface, best - step), right = reciprocal(surface, best + step);
    const double curvature = left - 2 * least + right;
    if (!(curvature > 0)) break;
    const double move = step * std::clamp((left - right) / (2 * curvature), -1., 1.);
    const double value = move == 0 ? least : reciprocal(surface, best + move);
    if (value < least) {
      best += move;
      least = value;
    }
    const double half = step * std::sqrt(2 * least / curvature) * std::numbers::pi / 180;
    width = std::min(1., half);
  }
  return {best, width};
}

namespace {

constexpr int most_digits = 100;
/// Half of them is the share of rounding in an error, 10^6 units of the surface's digits: the 4096 terms of an integral
/// over lines are positive, so that their errors are 1 unit and those of their sum 4096 units, and what is computed
/// from the integral may enlarge these by a factor of 200.
constexpr int guard_digits = 12;
constexpr long most_directions = 4096;

[[noreturn]] void refuse_digits(int digits) {
  throw data::BadInput("digits", std::to_string(digits),
                       "must be fewer, the speed farther below the critical one or the body rounder: " +
                           std::to_string(most_directions) + " lines do not give them here");
}

Float number(const Float& real) {
  if (mpfr_number_p(raw(real)) == 0)
    throw data::BadInput("surface", mpfr_nan_p(raw(real)) != 0 ? "nan" : "infinite",
                         "must answer with finite numbers");
  return at_working_precision(real);
}

}  // namespace

std::vector<UnitPoint> unit_nodes(int digits) {
  const Float step = Float(1) / (digits + 20) * 2;
  // An integrand analytic up to the height 3/4 has an aliasing error of e^(-2 pi 3/4/step), below 10^-(digits + 20).
  // Beyond the last node, weights are below 10^-digits even when multiplied by an algebraic singularity at the end.
  const int last =
      static_cast<int>((std::asinh(2.3026 * (digits + 10) / 3.14159) + 0.5) / static_cast<double>(step));
  std::vector<UnitPoint> nodes;
  for (int i = -last; i <= last; ++i) {
    nodes.emplace_back(i * step);
    nodes.back().slope *= step;
  }
  return nodes;
}

LineAnswer WorkingSurface::at(const Exact& degrees) const {
  LineAnswer line = answer_(degrees, digits_);
  for (Float* real : {&line.compliance, &line.coupling, &line.coupling_across, &line.in_line,
                      &line.shear_compliance, &line.shear_compliance_across})
    *real = number(*real);
  return line;
}

Float tolerance(int digits) { return pow(Float(10), -digits); }

int working_digits(int digits, int cancelled) {
  if (digits < 16 || digits > most_digits)
    throw data::BadInput("digits", std::to_string(digits),
                         "must be from 16 to " + std::to_string(most_digits));
  return digits + guard_digits + cancelled;
}

Estimate estimated(const Float& value, const Float& error, int digits) {
  // Two results may agree to the last bit. The error is then that of rounding and of the surface's digits.
  const Float sum = error + tolerance(digits + guard_digits / 2) * abs(value);
  if (!(sum <= tolerance(digits) * abs(value))) refuse_digits(digits);
  return {value, sum, digits};
}

Estimate of_levels(const Float& fine, const Float& coarse, int digits) {
  const Float rounding = tolerance(digits + guard_digits / 2) * abs(fine);
  return {fine, abs(fine - coarse) + rounding, digits};
}

Estimate with_shifted_ends(int digits, const std::function<Estimate(const Float& change)>& at) {
  const Float off = tolerance(digits + guard_digits / 2);
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
    : surface(std::move(of_surface)), load(given), digits(asked), working(working_digits(asked, cancelled)) {}

const Levels& ScaledContact::factor() const {
  if (!factor_) factor_ = integrated();
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
    // Once the sums converge, each doubling doubles their digits. The loop ends early if the digits cannot suffice.
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
