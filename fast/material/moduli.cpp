#include <cmath>
#include <complex>
#include <string>

#include <nipref/data/magnitude.hpp>
#include <nipref/fast/material/moduli.hpp>
#include <nipref/fast/number/internal/checks.hpp>

namespace nipref::fast {
namespace {

using data::SpringModel;
using internal::check_not_negative;

/// amplitude e^-age
Fading faded(double amplitude, double age) {
  // The factor is applied in two halves, as e^-age may underflow where the product does not.
  const double half = std::exp(-age / 2), value = amplitude * half * half;
  // A value of 0 has size 0, even if `age` is infinite.
  return {value, value == 0 ? 0 : value * (1 + age)};
}

Fading operator+(const Fading& a, const Fading& b) { return {a.value + b.value, a.size + b.size}; }

/// (1 - e^(-rate t))/rate, or its limit t for rate 0
double gone(double rate, double t) { return rate * t == 0 ? t : -std::expm1(-rate * t) / rate; }

double second_spring(const Modulus& m) {
  return m.model == SpringModel::standard_linear ? m.second_spring : 0;
}

/// The modulus at_rest + jump time z/(1 + time z) + dashpot z, where z is the variable of the Laplace transform.
struct Stiff {
  double at_rest, jump, time, dashpot;
};
Stiff stiffness_of(const Modulus& m) {
  if (m.model == SpringModel::elastic) return {m.spring, 0, 1, 0};
  if (m.model == SpringModel::kelvin_voigt) return {m.spring, 0, 1, m.viscosity};
  const double second = second_spring(m), both = m.spring + second, part = m.spring / both;
  return {part * second, m.spring * part, m.viscosity / both, 0};
}

/// The reciprocal of a modulus, at_once + 1/(viscosity (rate + z)).
struct Compliant {
  double at_once, viscosity, rate;
};
Compliant compliance_of(const Modulus& m) {
  if (m.model == SpringModel::elastic) return {1 / m.spring, HUGE_VAL, 0};
  if (m.model == SpringModel::kelvin_voigt) return {0, m.viscosity, m.spring / m.viscosity};
  return {1 / m.spring, m.viscosity, second_spring(m) / m.viscosity};
}

/// x^2/(1 + x^2) and x/(1 + x^2)
double followed(double x) { return x < 1 ? x * x / (1 + x * x) : 1 / (1 + 1 / x / x); }
double lagged(double x) { return x < 1 ? x / (1 + x * x) : 1 / x / (1 + 1 / x / x); }

}  // namespace

void Modulus::check(const char* prefix) const {
  const std::string name = prefix;
  data::check_magnitude(name, spring);
  if (model == SpringModel::standard_linear) data::check_magnitude(name + "_2", second_spring);
  if (model != SpringModel::elastic) data::check_magnitude(name + "_viscosity", viscosity);
}

Fading relaxation(const Modulus& m, double t) {
  check_not_negative("t", t);
  const auto [at_rest, jump, time, dashpot] = stiffness_of(m);
  return Fading{at_rest, at_rest} + faded(jump, t / time);
}

double creep(const Modulus& m, double t) {
  check_not_negative("t", t);
  const auto [at_once, viscosity, rate] = compliance_of(m);
  return at_once + gone(rate, t) / viscosity;
}

double storage(const Modulus& m, double omega) {
  check_not_negative("omega", omega);
  const auto [at_rest, jump, time, dashpot] = stiffness_of(m);
  return at_rest + jump * followed(time * omega);
}

double loss(const Modulus& m, double omega) {
  check_not_negative("omega", omega);
  const auto [at_rest, jump, time, dashpot] = stiffness_of(m);
  return jump * lagged(time * omega) + dashpot * omega;
}

std::complex<double> modulus_at(const Modulus& m, double p, double omega) {
  check_not_negative("p", p);
  check_not_negative("omega", omega);
  const auto [at_rest, jump, time, dashpot] = stiffness_of(m);
  // Errors in units of 2^-53: 3 in at_rest, in jump and in `ratio`, 9 in its reciprocal, 4 and 10 in their sums with 1,
  // 6 more in a quotient. Real parts are >= 0, so that no term exceeds the sum.
  const std::complex<double> z(p, omega), ratio = time * z;
  const std::complex<double> followed =
      std::abs(ratio) < 1 ? ratio / (1.0 + ratio) : 1.0 / (1.0 + 1.0 / ratio);
  return at_rest + jump * followed + dashpot * z;
}

Fading theta1(const Modulus& shear, double t) {
  check_not_negative("t", t);
  const auto [at_once, viscosity, rate] = compliance_of(shear);
  return faded(1 / (2 * viscosity), rate * t);
}

// 6K + 2G = c - sum k_i/(p + s_i), so that 3/(6K + 2G) = (3/c) [1 + v . (p + M)^-1 v] with v_i^2 = k_i/c and
// M = diag(s) - v v. M is symmetric, and each of its principal directions contributes one term, which is positive.
Fading theta2(const Modulus& shear, const Modulus& bulk, double t) {
  check_not_negative("t", t);
  if (shear.model == SpringModel::elastic) return {0, 0};
  if (shear.model == SpringModel::kelvin_voigt) {
    const double viscosity = 6 * bulk.viscosity + 2 * shear.viscosity;
    return faded(3 / viscosity, (6 * bulk.spring + 2 * shear.spring) / viscosity * t);
  }
  const double of_bulk = 6 * bulk.spring, of_shear = 2 * shear.spring, at_once = of_bulk + of_shear;
  const double share_bulk = of_bulk / at_once, share_shear = of_shear / at_once;
  const double second_bulk = second_spring(bulk), second_shear = second_spring(shear);
  const double m_bulk = (second_bulk + bulk.spring * share_shear) / bulk.viscosity;
  const double m_shear = (second_shear + shear.spring * share_bulk) / shear.viscosity;
  const double v_bulk = std::sqrt(share_bulk * (bulk.spring / bulk.viscosity));
  const double v_shear = std::sqrt(share_shear * (shear.spring / shear.viscosity));
  const double half_apart = (m_bulk - m_shear) / 2, coupling = v_bulk * v_shear;
  const double radius = std::hypot(half_apart, coupling);
  const double fast_rate = (m_bulk + m_shear) / 2 + radius;
  // The determinant of M without the terms that cancel, divided by fast_rate.
  const double slow_rate =
      (second_bulk / bulk.viscosity * (m_shear / fast_rate)) +
      bulk.spring * share_shear / bulk.viscosity * (second_shear / shear.viscosity / fast_rate);
  // The principal directions are (cosine, -sine) for fast_rate and (sine, cosine) for slow_rate.
  const double smaller = coupling / (std::fabs(half_apart) + radius), larger = 1 / std::hypot(1, smaller);
  const double sine = half_apart < 0 ? larger : larger * smaller,
               cosine = half_apart < 0 ? larger * smaller : larger;
  const double slow_weight = v_bulk * sine + v_shear * cosine;
  const double fast_weight = v_bulk * cosine - v_shear * sine;
  return faded(3 / at_once * slow_weight * slow_weight, slow_rate * t) +
         faded(3 / at_once * fast_weight * fast_weight, fast_rate * t);
}

}  // namespace nipref::fast
