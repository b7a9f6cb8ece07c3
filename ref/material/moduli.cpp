#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/material/internal/known_number.hpp>
#include <nipref/ref/material/moduli.hpp>

namespace nipref::ref {
namespace {

using data::SpringModel;

void check_positive(const std::string& name, const Exact& value) {
  if (value.sign() <= 0) throw data::BadInput(name, value.text(), "must be > 0");
}

void check_nonnegative(const char* name, const Exact& value) {
  if (value.sign() < 0) throw data::BadInput(name, value.text(), "must be >= 0");
}

/// N(p)/D(p) of the modulus: coefficients of p^0 and p^1.
struct RationalModulus {
  mpq_class n0, n1, d0, d1;
};

RationalModulus rational(const ExactModulus& m) {
  const mpq_class& first = m.spring.value();
  const mpq_class& viscosity = m.viscosity.value();
  const mpq_class second = m.model == SpringModel::standard_linear ? m.second_spring.value() : mpq_class(0);
  switch (m.model) {
    case SpringModel::elastic:
      return {first, 0, 1, 0};
    case SpringModel::kelvin_voigt:
      return {first, viscosity, 1, 0};
    default:
      return {first * second, first * viscosity, first + second, viscosity};
  }
}

/// Evaluates with more and more bits until the digits are met; times and rates of very different sizes need more.
Enclosure evaluated(int digits, const std::function<Interval(mpfr_prec_t bits)>& at) {
  return enclose(digits, 0, [&](double nats) {
    return at(static_cast<mpfr_prec_t>(128 + 2 * nats / std::numbers::ln2));
  });
}

/// e^(-rate t)
Interval fading(const mpq_class& rate, const Exact& t, mpfr_prec_t bits) {
  return exp(Interval(Exact(-rate * t.value()), bits));
}

/// BadInput where the value is e^(-rate t) alone and below MPFR's range.
void check_remembered(const mpq_class& rate, const Exact& t) {
  constexpr int longest = 700'000'000;
  if (rate * t.value() > longest)
    throw data::BadInput("t", t.text(),
                         "must be at most 7e8 relaxation times, beyond which there is no such number");
}

}  // namespace

void ExactModulus::check(const char* prefix) const {
  const std::string name = prefix;
  check_positive(name, spring);
  if (model == SpringModel::standard_linear) check_positive(name + "_2", second_spring);
  if (model != SpringModel::elastic) check_positive(name + "_viscosity", viscosity);
}

Enclosure relaxation(const ExactModulus& modulus, const Exact& t, int digits) {
  check_nonnegative("t", t);
  const auto [n0, n1, d0, d1] = rational(modulus);
  // N/(p D) = n0/(d0 p) + the term of the root of D
  if (d1 == 0) return known_number(n0 / d0, digits);
  const mpq_class relaxed = n0 / d0, decaying = n1 / d1 - n0 / d0, rate = d0 / d1;
  if (relaxed == 0) check_remembered(rate, t);
  return evaluated(digits, [&](mpfr_prec_t bits) {
    return Interval(Exact(relaxed), bits) + Interval(Exact(decaying), bits) * fading(rate, t, bits);
  });
}

Enclosure creep(const ExactModulus& modulus, const Exact& t, int digits) {
  check_nonnegative("t", t);
  const auto [n0, n1, d0, d1] = rational(modulus);
  // D/(p N)
  if (n1 == 0) return known_number(d0 / n0, digits);
  if (n0 == 0) return known_number(d1 / n1 + d0 / n1 * t.value(), digits);
  if (t.sign() == 0) return known_number(d1 / n1, digits);
  const mpq_class relaxed = d0 / n0, decaying = d1 / n1 - d0 / n0, rate = n0 / n1;
  return evaluated(digits, [&](mpfr_prec_t bits) {
    return Interval(Exact(relaxed), bits) + Interval(Exact(decaying), bits) * fading(rate, t, bits);
  });
}

Enclosure storage(const ExactModulus& modulus, const Exact& omega, int digits) {
  check_nonnegative("omega", omega);
  const auto [n0, n1, d0, d1] = rational(modulus);
  const mpq_class square = omega.value() * omega.value();
  return known_number((n0 * d0 + n1 * d1 * square) / (d0 * d0 + d1 * d1 * square), digits);
}

Enclosure loss(const ExactModulus& modulus, const Exact& omega, int digits) {
  check_nonnegative("omega", omega);
  const auto [n0, n1, d0, d1] = rational(modulus);
  const mpq_class square = omega.value() * omega.value();
  return known_number(omega.value() * (n1 * d0 - n0 * d1) / (d0 * d0 + d1 * d1 * square), digits);
}

Enclosure theta1(const ExactModulus& shear, const Exact& t, int digits) {
  check_nonnegative("t", t);
  const auto [n0, n1, d0, d1] = rational(shear);
  if (n1 == 0) return exact_zero(digits);
  // D/(2N) without its constant d1/(2 n1)
  const mpq_class amplitude = (d0 - n0 * d1 / n1) / (2 * n1), rate = n0 / n1;
  check_remembered(rate, t);
  return evaluated(
      digits, [&](mpfr_prec_t bits) { return Interval(Exact(amplitude), bits) * fading(rate, t, bits); });
}

Enclosure theta2(const ExactModulus& shear, const ExactModulus& bulk, const Exact& t, int digits) {
  check_nonnegative("t", t);
  const auto G = rational(shear), K = rational(bulk);
  if (G.n1 == 0) return exact_zero(digits);
  // 3 dG dK/(6 nK dG + 2 nG dK), coefficients of p^0 to p^2
  const mpq_class a0 = 3 * G.d0 * K.d0, a1 = 3 * (G.d0 * K.d1 + G.d1 * K.d0), a2 = 3 * G.d1 * K.d1;
  const mpq_class b0 = 6 * K.n0 * G.d0 + 2 * G.n0 * K.d0;
  const mpq_class b1 = 6 * (K.n0 * G.d1 + K.n1 * G.d0) + 2 * (G.n0 * K.d1 + G.n1 * K.d0);
  const mpq_class b2 = 6 * K.n1 * G.d1 + 2 * G.n1 * K.d1;
  if (b2 == 0) {
    const mpq_class amplitude = a0 / b1, rate = b0 / b1;
    check_remembered(rate, t);
    return evaluated(
        digits, [&](mpfr_prec_t bits) { return Interval(Exact(amplitude), bits) * fading(rate, t, bits); });
  }
  // Without the constant a2/b2: (c0 + c1 p)/(p^2 + 2 m p + d)
  const mpq_class c0 = (a0 - a2 * b0 / b2) / b2, c1 = (a1 - a2 * b1 / b2) / b2;
  const mpq_class middle = b1 / (2 * b2), product = b0 / b2, square = middle * middle - product;
  const mpq_class lever = c0 - c1 * middle;
  // The slow rate is between product/middle/2 and product/middle.
  check_remembered(product / middle / 2, t);
  return evaluated(digits, [&](mpfr_prec_t bits) {
    const Interval root = sqrt(Interval(Exact(square), bits)), time(t, bits);
    const Interval slow = Interval(Exact(product), bits) / (Interval(Exact(middle), bits) + root);
    const Interval fast = Interval(Exact(middle), bits) + root;
    const Interval apart = Interval(Exact(lever), bits) / root, mean(Exact(c1), bits);
    return ((mean + apart) * exp(-(slow * time)) + (mean - apart) * exp(-(fast * time))) / 2L;
  });
}

}  // namespace nipref::ref
