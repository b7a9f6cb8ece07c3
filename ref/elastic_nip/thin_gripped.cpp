#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/elastic_nip/internal/end_shear.hpp>
#include <nipref/ref/elastic_nip/internal/grip_precision.hpp>
#include <nipref/ref/elastic_nip/internal/nip_units.hpp>
#include <nipref/ref/elastic_nip/thin_gripped.hpp>
#include <nipref/ref/number/internal/cache.hpp>
#include <nipref/ref/number/internal/golden_section.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>

namespace nipref::ref {
namespace {

using data::BadInput;

constexpr int samples_of_a_fit = 5;

/// The working digits for results of this many digits.
int digits_of_fits(int digits) { return digits + 30; }

struct ContactNumbers {
  Float load, indentation, creep, middle_pressure;
};
struct SolvedLength {
  Float half_length;
  ContactNumbers numbers;
  EndShear shear;
};

/// A strip whose faces are pressed by d0 - y^2 and stretched: a polynomial.
struct Strip {
  Float stiffness, against_curvature, by_stretch;

  explicit Strip(const Float& poisson)
      : stiffness(2 * (1 - poisson) * (1 - poisson) / (1 - 2 * poisson)),
        against_curvature(4 * poisson / (3 * (1 - 2 * poisson))),
        by_stretch(-2 * poisson * (1 - poisson) / (1 - 2 * poisson)) {}

  [[nodiscard]] Float middle_pressure(const ContactNumbers& of) const {
    return stiffness * (of.indentation - against_curvature) + by_stretch * of.creep;
  }
  [[nodiscard]] Float load(const Float& half_length, const ContactNumbers& of) const {
    return 2 * half_length * (middle_pressure(of) - stiffness * half_length * half_length / 3);
  }
};

/// What five contacts tell of longer ones.
class LongContacts {
 public:
  LongContacts(const Float& poisson, const GripWaves& waves, std::span<const SolvedLength> known)
      : zeta_(waves.slowest), strip_(poisson), known_(known) {
    // (1 - r z) creep = ..., linear in what is sought.
    Matrix matrix(samples_of_a_fit, samples_of_a_fit);
    Vector right(samples_of_a_fit);
    for (long i = 0; i < samples_of_a_fit; ++i) {
      const auto& [length, numbers, shear] = known_[static_cast<std::size_t>(i)];
      const Float z = both_ways(length);
      const Float row[] = {1, length, z, z * length, z * numbers.creep};
      for (long k = 0; k < samples_of_a_fit; ++k) matrix(i, k) = row[k];
      right(i) = numbers.creep;
    }
    const Vector x = solve(matrix, right);
    a0_ = x(0), a1_ = x(1), r_ = x(4);
    q0_ = x(2) + r_ * a0_, q1_ = x(3) + r_ * a1_;
  }

  [[nodiscard]] ContactNumbers at(const Float& length) const {
    ContactNumbers result;
    result.creep = a0_ + a1_ * length + wave(length);
    result.indentation = length * length + of_ends(length, [](const SolvedLength& known) -> Float {
                           return known.numbers.indentation - known.half_length * known.half_length;
                         });
    result.load = strip_.load(length, result) + of_ends(length, [&](const SolvedLength& known) -> Float {
                    return known.numbers.load - strip_.load(known.half_length, known.numbers);
                  });
    const auto& [longest, of_longest, shear] = known_.back();
    const Float share =
        (of_longest.middle_pressure - strip_.middle_pressure(of_longest)) / wave_in_middle(longest);
    result.middle_pressure = strip_.middle_pressure(result) + share * wave_in_middle(length);
    return result;
  }
  /// |q| at about the distance s from the end.
  [[nodiscard]] Float shear_at(const Float& length, double about) const {
    const double s = std::ldexp(std::round(std::ldexp(about, 40)), -40);
    const Float from_other = 2 * length - s;
    return abs(
        of_ends(length, [&](const SolvedLength& known) { return known.shear.at(s); }) -
        of_ends(length, [&](const SolvedLength& known) { return known.shear.slow_wave_at(from_other); }));
  }

 private:
  [[nodiscard]] Float both_ways(const Float& length) const { return exp(-2 * zeta_ * length); }
  [[nodiscard]] Float wave(const Float& length) const {
    const Float z = both_ways(length);
    return (q0_ + q1_ * length) * z / (1 - r_ * z);
  }
  [[nodiscard]] Float wave_in_middle(const Float& length) const { return wave(length) * exp(zeta_ * length); }

  /// What is linear in 1, A and the wave, by the last three contacts.
  template <class Number>
  [[nodiscard]] Float of_ends(const Float& length, const Number& number) const {
    Matrix matrix(3, 3);
    Vector right(3);
    for (long i = 0; i < 3; ++i) {
      const SolvedLength& known = known_[known_.size() - 3 + static_cast<std::size_t>(i)];
      matrix(i, 0) = 1;
      matrix(i, 1) = known.half_length;
      matrix(i, 2) = wave(known.half_length);
      right(i) = number(known);
    }
    const Vector x = solve(matrix, right);
    return x(0) + x(1) * length + x(2) * wave(length);
  }

  Float zeta_;
  Strip strip_;
  std::span<const SolvedLength> known_;
  Float a0_, a1_, q0_, q1_, r_;
};

/// The solved contacts from which all longer contacts of the same sheet are extrapolated.
struct ShorterContacts {
  Float poisson;
  GripWaves waves;
  std::vector<SolvedLength> lengths;
};
struct ShorterKey {
  double poisson;
  int digits;

  auto operator<=>(const ShorterKey&) const = default;
};

/// The lengths are a compromise: the longer the contacts, the smaller is the effect of the second wave; but where the
/// first wave decays slowly, more digits are needed to separate it.
ShorterContacts solve_shorter(const ShorterKey& key) {
  const WorkingDigits working(digits_of_fits(key.digits));
  const Float poisson(key.poisson);
  ShorterContacts solved{poisson, GripWaves(poisson), {}};
  const double first = std::max(5.0, 0.5 * std::round(0.62 * key.digits + 1)),
               last = first + 0.5 * samples_of_a_fit, zeta = static_cast<double>(solved.waves.slowest);
  const int enough = key.digits + 5 + static_cast<int>(std::ceil(5 * std::max(0.0, -std::log10(zeta))));
  const GripPrecision precision(last, enough, false);
  GripKernels kernels(precision.kernel);
  const Float beta = (1 - 2 * poisson) / (2 * (1 - poisson));
  for (double length = first; length <= last; length += 0.5) {
    const GripExpansion contact = [&]() -> GripExpansion {
      const WorkingDigits working_of_contact(precision.working);
      return {length, beta, fine_layout(length, precision.expansion), kernels};
    }();
    const ContactNumbers numbers{contact.load(), contact.indentation(), contact.creep(),
                                 contact.traction(1).pressure};
    solved.lengths.push_back({length, numbers, EndShear(contact, length, poisson, solved.waves)});
  }
  return solved;
}

std::shared_ptr<const ShorterContacts> shorter_contacts(double poisson, int digits) {
  static Cache<ShorterKey, ShorterContacts> memo(
      solve_shorter, [](const ShorterContacts&) { return sizeof(ShorterContacts) + (std::size_t{1} << 18); });
  return memo.at({poisson, digits});
}

/// Distance from the end of the largest shear; by samples as even in the logarithm.
double place_of_largest_shear(const LongContacts& contacts, const Float& length) {
  constexpr int samples = 200;
  constexpr double nearest = 1e-3, place_to = 1e-11;
  const double step = std::log(static_cast<double>(length) / nearest) / samples;
  const auto shear = [&](const Float& at) {
    return contacts.shear_at(length, nearest * std::exp(step * static_cast<double>(at)));
  };
  int best = 1;
  Float largest = 0;
  for (int i = 1; i < samples; ++i) {
    const Float here = shear(i);
    if (here > largest) largest = here, best = i;
  }
  return nearest *
         std::exp(step * static_cast<double>(place_of_largest(shear, best - 1, best + 1, place_to)));
}

}  // namespace

ThinGrippedNip thin_gripped_nip_of_length(const data::ElasticNip& nip, double contact_length, int digits) {
  nip.check();
  if (digits < 12 || digits > 21)
    throw BadInput("digits", std::to_string(digits),
                   "must be from 12 to 21 for a thin sheet with full friction");
  const double poisson = nip.material.poisson;
  if (poisson > largest_thin_gripped_poisson)
    throw BadInput("poisson", poisson, "must be at most 0.499999 for a thin sheet with full friction");
  const double ratio = contact_length / nip.sheet_thickness;
  if (!(ratio >= shortest_thin_gripped_nip && ratio <= 1e4 && contact_length <= nip.roller_radius)) {
    throw BadInput("contact_length", contact_length,
                   fmt::format("must be at most the roller's radius and from {} to 1e4 sheet thicknesses",
                               shortest_thin_gripped_nip));
  }
  const WorkingDigits working(digits_of_fits(digits));
  const auto known = shorter_contacts(poisson, digits);
  const Float half_length = to_float(Exact(exactly(contact_length) / exactly(nip.sheet_thickness)));
  const std::span all(known->lengths);
  const LongContacts rough(known->poisson, known->waves, all.first(samples_of_a_fit));
  const LongContacts fine(known->poisson, known->waves, all.last(samples_of_a_fit));
  const ContactNumbers rough_numbers = rough.at(half_length), numbers = fine.at(half_length);
  const double place = place_of_largest_shear(fine, half_length);
  const NipUnits units(nip);
  const auto estimated = [&](const mpq_class& unit, const Float& rough_value,
                             const Float& value) -> Estimate {
    const Float factor = to_float(Exact(unit));
    const Float error = 2 * abs(value - rough_value) + abs(value) * pow(Float(10), -digits - 1);
    return {factor * value, factor * error, digits};
  };
  const auto number = [&](const mpq_class& unit, Float ContactNumbers::*which) {
    return estimated(unit, rough_numbers.*which, numbers.*which);
  };
  return {number(units.pressure * units.length, &ContactNumbers::load),
          number(units.displacement, &ContactNumbers::indentation),
          number(units.slope, &ContactNumbers::creep),
          number(units.pressure, &ContactNumbers::middle_pressure),
          estimated(units.pressure, rough.shear_at(half_length, place), fine.shear_at(half_length, place))};
}

}  // namespace nipref::ref
