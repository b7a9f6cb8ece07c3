#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/ref/elastic_nip/internal/nip_units.hpp>
#include <nipref/ref/elastic_nip/thin.hpp>
#include <nipref/ref/number/internal/cache.hpp>

namespace nipref::ref {
namespace {

using data::BadInput;

/// A contact's numbers as polynomials of l = L/B have them, without units.
struct ThinNumbers {
  Interval load;           ///< N R W/B^2, l^3/3 and less
  Interval indentation;    ///< R d0/B^2, l^2/8
  Interval stretch;        ///< (R/B) l creep_ratio of an incompressible sheet, l^3/6
  Interval peak_pressure;  ///< N R p/B, l^2/2
};

struct Sample {
  long length;  ///< l
  ThinNumbers numbers;
};
using Samples = std::array<Sample, 4>;

constexpr int spare_digits = 5;  // for extrapolation

/// R = 1024, B = 1, E = 1, incompressible: N = 3/2.
Sample sample_of(long length, int digits) {
  const auto contact =
      converged_for_length({1024, 1, {1, 0.5}}, static_cast<double>(length), digits + spare_digits);
  const auto times = [](const Enclosure& number, const mpq_class& factor) {
    const Interval known = interval_of(number);
    return known * Interval(Exact(factor), known.precision());
  };
  return {length,
          {times(contact.load(), 1536), times(contact.indentation(), 1024),
           times(contact.creep_ratio(), 1024 * length), times(contact.peak_pressure(), 1536)}};
}

/// So many that few are solved for.
int digits_of_samples(int digits) { return digits <= 21 ? 21 : digits <= 30 ? 30 : digits <= 50 ? 50 : 80; }

Samples samples_of(const int& digits) {
  const long first = std::lround(shortest_thin_nip(digits));
  return {sample_of(first, digits), sample_of(first + 2, digits), sample_of(first + 4, digits),
          sample_of(first + 6, digits)};
}

std::shared_ptr<const Samples> samples(int digits) {
  static Cache<int, Samples> memo(samples_of, [](const Samples&) { return sizeof(Samples) + 4096; });
  return memo.at(digits_of_samples(digits));
}

/// At `length` of the polynomial through the last of the samples, as many as `count`; `leading`: of the power `count`,
/// known.
Interval extrapolated(const Samples& known, Interval ThinNumbers::*number, const mpq_class& length,
                      std::size_t count, const mpq_class& leading) {
  const std::span<const Sample> used = std::span(known).last(count);
  const mpfr_prec_t precision = (used.front().numbers.*number).precision();
  const auto power = [&](const mpq_class& x) {
    mpq_class product = leading;
    for (std::size_t i = 0; i < count; ++i) product *= x;
    return Interval(Exact(product), precision);
  };
  Interval sum = power(length);
  for (const Sample& sample : used) {
    mpq_class weight = 1;
    for (const Sample& other : used) {
      if (other.length != sample.length)
        weight *= (length - other.length) / mpq_class(sample.length - other.length);
    }
    sum = sum + Interval(Exact(weight), precision) * (sample.numbers.*number - power(sample.length));
  }
  return sum;
}

/// Of a polynomial of that degree; its leading coefficient tells what is left out.
Interval judged(const Samples& known, Interval ThinNumbers::*number, const mpq_class& length,
                std::size_t degree, const mpq_class& leading) {
  const Interval value = extrapolated(known, number, length, degree, leading);
  const Interval difference = value - extrapolated(known, number, length, degree + 1, 0);
  return value.widened(difference).widened(-difference);  // of either sign
}

/// N R p/B in the middle, 4 R d0/B^2 as of springs: the sheet's symbol has no term in the square of the wave number, so
/// that a parabola is pressed into it as into springs. The waves of the ends, which go like l^2 e^(-pi l), are left
/// out. The first sample tells how large they are; the error is twice that, for lower powers of l.
Interval middle_pressure(const Samples& known, const Interval& indentation, const mpq_class& length) {
  const auto& [shorter, numbers] = known.front();
  const mpfr_prec_t precision = indentation.precision();
  const Interval further(Exact(length - shorter), precision), ratio(Exact(length / shorter), precision);
  const Interval waves = numbers.peak_pressure - 4 * numbers.indentation;
  const Interval left_out = 2 * square(ratio) * exp(-(Interval::pi(precision) * further)) * waves;
  return (4 * indentation).widened(left_out).widened(-left_out);  // of either sign
}

Estimate in_units(const Interval& number, const mpq_class& unit, int digits) {
  return enclosure_of(number * Interval(Exact(unit), number.precision()), digits);
}

}  // namespace

double shortest_thin_nip(int digits) { return std::ceil((digits_of_samples(digits) + 6) * 2.303 / 6.283); }

LongContactFit thin_nip_of_length(const data::ElasticNip& nip, double contact_length, int digits) {
  nip.check();
  if (digits < 16 || digits > 80)
    throw BadInput("digits", std::to_string(digits), "must be from 16 to 80 for a thin sheet");
  const double ratio = contact_length / nip.sheet_thickness;
  if (!(ratio >= shortest_thin_nip(digits) && ratio <= 1e4 && contact_length <= nip.roller_radius)) {
    throw BadInput("contact_length", contact_length,
                   fmt::format("must be at most the roller's radius and from {} to 1e4 sheet thicknesses",
                               shortest_thin_nip(digits)));
  }
  const NipUnits units(nip);
  const mpq_class thickness = 2 * units.length, length = exactly(contact_length) / thickness;
  // B/(N R), of stress
  const mpq_class stress = 4 * units.pressure, over_radius = 4 * units.slope;
  const std::shared_ptr<const Samples> kept = samples(digits);
  const Samples& known = *kept;
  const Interval load = judged(known, &ThinNumbers::load, length, 3, mpq_class(1, 3));
  const Interval stretch = judged(known, &ThinNumbers::stretch, length, 3, mpq_class(1, 6)) -
                           Interval(Exact(units.beta), load.precision()) * load;
  const Interval indentation = judged(known, &ThinNumbers::indentation, length, 2, mpq_class(1, 8));
  return {in_units(load, stress * thickness, digits), in_units(indentation, over_radius * thickness, digits),
          in_units(stretch, over_radius / length, digits),
          in_units(middle_pressure(known, indentation, length), stress, digits)};
}

}  // namespace nipref::ref
