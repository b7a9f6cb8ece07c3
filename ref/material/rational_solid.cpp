#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/material/internal/polynomial.hpp>
#include <nipref/ref/material/rational_solid.hpp>

namespace nipref::ref {
namespace {

void check_not_below_0(const std::string& name, const Exact& value) {
  if (value.sign() < 0) throw data::BadInput(name, value.text(), "must be >= 0");
}

void check_above_0(const std::string& name, const Exact& value) {
  if (value.sign() <= 0) throw data::BadInput(name, value.text(), "must be > 0");
}

ExactRatio ratio_of(const ExactSeries& series, const std::string& name) {
  check_not_below_0(name + "_instantaneous", series.instantaneous);
  ExactRatio sum{{series.instantaneous.value()}, {1}};
  for (std::size_t i = 0; i < series.rates.size(); ++i) {
    check_not_below_0(name + "_rate" + (i == 0 ? "" : "_" + std::to_string(i + 1)), series.rates[i]);
    const Polynomial factor{series.rates[i].value(), 1};
    sum.numerator = sum.numerator * factor + series.amplitudes[i].value() * sum.denominator;
    sum.denominator *= factor;
  }
  if (sum.numerator.is_zero())
    throw data::BadInput(name, "0 at all times", "must have a constant that is not 0");
  return sum;
}

ExactRatio operators_of(const std::vector<Exact>& p, const std::vector<Exact>& q, const std::string& suffix) {
  const auto polynomial = [&](const std::vector<Exact>& coefficients, const std::string& name) {
    std::vector<mpq_class> values;
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
      check_not_below_0(name + suffix + "_" + std::to_string(k), coefficients[k]);
      values.push_back(coefficients[k].value());
    }
    Polynomial result(std::move(values));
    if (result.is_zero()) throw data::BadInput(name + suffix, "0", "must have a coefficient that is not 0");
    return result;
  };
  const Polynomial above = polynomial(q, "Q"), below = polynomial(p, "P");
  if (above.size() < below.size() || above.size() > below.size() + 1) {
    throw data::BadInput("Q" + suffix, "of degree " + std::to_string(above.size() - 1),
                         "must be of the degree of P" + suffix + ", " + std::to_string(below.size() - 1) +
                             ", or of one more: what gives way without bound at once is no solid");
  }
  return {above, below};
}

/// G = 1/(2 theta1), 6K = 3/theta2 - 1/theta1.
ExactRationalSolid of_compliances(const ExactRatio& one, const ExactRatio& two) {
  return {{one.denominator, 2 * one.numerator},
          {3 * two.denominator * one.numerator - one.denominator * two.numerator,
           6 * one.numerator * two.numerator},
          one,
          two};
}

Enclosure in_time(Polynomial numerator, Polynomial denominator, const Exact& t, int digits) {
  check_not_below_0("t", t);
  cancel(numerator, denominator);
  numerator %= denominator;  // without impulses
  if (numerator.is_zero()) return exact_zero(digits);
  if (t.sign() == 0) {
    const bool starts_at_0 = numerator.size() + 1 < denominator.size();
    return starts_at_0 ? exact_zero(digits)
                       : exactly(mpq_class(last_of(numerator) / last_of(denominator)), digits);
  }
  constexpr double longest = 7e8, most_growth = 2300;
  const double rate = slowest_rate(denominator);
  if (rate * t.approximate() > longest)
    throw data::BadInput("t", t.text(),
                         "must be at most 7e8 relaxation times, beyond which there is no such number");
  if (-rate * t.approximate() > most_growth)
    throw data::BadInput(
        "t", t.text(),
        fmt::format("must be at most {:.3g}: the material is unstable, what it answers grows "
                    "e-fold in {:.3g} and then has over 1000 digits before the point",
                    -most_growth / rate, -1 / rate));
  return enclose(digits, 0, [&](double nats) {
    return inverse_transform(numerator, denominator, t.value(),
                             static_cast<mpfr_prec_t>(128 + nats / std::numbers::ln2));
  });
}

using ExactComplex = Complex<mpq_class>;

ExactComplex value_at(const Polynomial& polynomial, const ExactComplex& p) {
  ExactComplex sum;
  for (auto c = polynomial.data().rbegin(); c != polynomial.data().rend(); ++c)
    sum = sum * p + ExactComplex(*c);
  return sum;
}

}  // namespace

ExactRationalSolid exact_prony(const ExactSeries& theta1, const ExactSeries& theta2) {
  return of_compliances(ratio_of(theta1, "theta1"), ratio_of(theta2, "theta2"));
}

ExactRationalSolid exact_operators(const std::vector<Exact>& p, const std::vector<Exact>& q,
                                   const std::vector<Exact>& p_dilatation,
                                   const std::vector<Exact>& q_dilatation) {
  return exact_moduli(operators_of(p, q, ""), operators_of(p_dilatation, q_dilatation, "_dilatation"));
}

// theta1 = 1/(2G), theta2 = 3/(6K + 2G)
ExactRationalSolid exact_moduli(const ExactRatio& G, const ExactRatio& K) {
  return {
      G,
      K,
      {G.denominator, 2 * G.numerator},
      {3 * G.denominator * K.denominator, 6 * K.numerator * G.denominator + 2 * G.numerator * K.denominator}};
}

ExactRatio exact_modulus(data::SpringModel model, const Exact& spring, const Exact& second_spring,
                         const Exact& viscosity, const std::string& name) {
  using data::SpringModel;
  check_above_0(name, spring);
  if (model == SpringModel::standard_linear) check_above_0(name + "_2", second_spring);
  if (model != SpringModel::elastic) check_above_0(name + "_viscosity", viscosity);
  const mpq_class &first = spring.value(), &dashpot = viscosity.value();
  if (model == SpringModel::elastic) return {{first}, {1}};
  if (model == SpringModel::kelvin_voigt) return {{first, dashpot}, {1}};
  const mpq_class second = model == SpringModel::maxwell ? mpq_class(0) : second_spring.value();
  return {{mpq_class(first * second), mpq_class(first * dashpot)}, {mpq_class(first + second), dashpot}};
}

ExactRationalSolid exact_single_time(const Exact& bulk, const Exact& shear, const Exact& tau,
                                     int theta2_rate_factor) {
  check_above_0("bulk", bulk);
  check_above_0("shear", shear);
  check_above_0("tau", tau);
  const auto relaxing = [&](const mpq_class& at_once, int factor) {
    return ratio_of(
        {Exact(at_once), {Exact(mpq_class(at_once / tau.value()))}, {Exact(mpq_class(factor / tau.value()))}},
        "theta");
  };
  const mpq_class both = 6 * bulk.value() + 2 * shear.value();
  return of_compliances(relaxing(1 / (2 * shear.value()), 1), relaxing(3 / both, theta2_rate_factor));
}

Enclosure relaxation(const ExactRatio& modulus, const Exact& t, int digits) {
  return in_time(modulus.numerator, Polynomial{0, 1} * modulus.denominator, t, digits);
}

Enclosure creep(const ExactRatio& modulus, const Exact& t, int digits) {
  if (modulus.numerator.is_zero())
    throw data::BadInput("theta2", "3 theta1 at all times", "must be less: nothing resists dilatation");
  return in_time(modulus.denominator, Polynomial{0, 1} * modulus.numerator, t, digits);
}

Enclosure storage(const ExactRatio& modulus, const Exact& omega, int digits) {
  return modulus_at(modulus, Exact(0.0), omega, ComplexPart::re, digits);
}

Enclosure loss(const ExactRatio& modulus, const Exact& omega, int digits) {
  return modulus_at(modulus, Exact(0.0), omega, ComplexPart::im, digits);
}

Enclosure modulus_at(const ExactRatio& modulus, const Exact& p, const Exact& omega, ComplexPart part,
                     int digits) {
  check_not_below_0("p", p);
  check_not_below_0("omega", omega);
  Polynomial above = modulus.numerator, below = modulus.denominator;
  cancel(above, below);
  const ExactComplex at(p.value(), omega.value()), divisor = value_at(below, at);
  if (divisor.re == 0 && divisor.im == 0) {
    const bool is_frequency = p.sign() == 0;
    throw data::BadInput(is_frequency ? "omega" : "p", (is_frequency ? omega : p).text(),
                         "must not be where the modulus is infinite");
  }
  const ExactComplex value = value_at(above, at) / divisor;
  return exactly(part == ComplexPart::im ? value.im : value.re, digits);
}

Enclosure fading_part(const ExactRatio& theta, const Exact& t, int digits) {
  return in_time(theta.numerator, theta.denominator, t, digits);
}

}  // namespace nipref::ref
