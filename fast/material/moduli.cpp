#include <cmath>
#include <complex>
#include <string>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/magnitude.hpp>
#include <nipref/fast/material/moduli.hpp>

namespace nipref::fast {
namespace {

using data::SpringModel;

void check_nonnegative(const char* name, double value) {
  if (!(std::isfinite(value) && value >= 0)) throw data::BadInput(name, value, "must be finite and >= 0");
}

/// amplitude e^(-rate t)
Fading faded(double amplitude, double rate, double t) {
  // By halves: the exponential may be smaller than any double where the product is not.
  const double age = rate * t, half = std::exp(-age / 2), value = amplitude * half * half;
  // What has faded to nothing is not made infinite again.
  return {value, value == 0 ? 0 : value * (1 + age)};
}

Fading operator+(const Fading& a, const Fading& b) { return {a.value + b.value, a.size + b.size}; }

/// (1 - e^(-rate t))/rate, of rate 0 too
double gone(double rate, double t) { return rate * t == 0 ? t : -std::expm1(-rate * t) / rate; }

double second_spring(const Modulus& m) {
  return m.model == SpringModel::standard_linear ? m.second_spring : 0;
}

/// The stress of the dashpot over that of the springs beside it.
double dashpot_ratio(const Modulus& m, double omega) {
  return omega * (m.viscosity / (m.spring + second_spring(m)));
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
  check_nonnegative("t", t);
  if (m.model == SpringModel::elastic || m.model == SpringModel::kelvin_voigt) return {m.spring, m.spring};
  const double second = second_spring(m), both = m.spring + second, part = m.spring / both;
  return Fading{part * second, part * second} + faded(m.spring * part, both / m.viscosity, t);
}

double creep(const Modulus& m, double t) {
  check_nonnegative("t", t);
  switch (m.model) {
    case SpringModel::elastic:
      return 1 / m.spring;
    case SpringModel::kelvin_voigt:
      return gone(m.spring / m.viscosity, t) / m.viscosity;
    default:
      return 1 / m.spring + gone(second_spring(m) / m.viscosity, t) / m.viscosity;
  }
}

double storage(const Modulus& m, double omega) {
  check_nonnegative("omega", omega);
  if (m.model == SpringModel::elastic || m.model == SpringModel::kelvin_voigt) return m.spring;
  const double second = second_spring(m), part = m.spring / (m.spring + second);
  return part * (second + m.spring * followed(dashpot_ratio(m, omega)));
}

double loss(const Modulus& m, double omega) {
  check_nonnegative("omega", omega);
  if (m.model == SpringModel::elastic) return 0;
  if (m.model == SpringModel::kelvin_voigt) return m.viscosity * omega;
  const double part = m.spring / (m.spring + second_spring(m));
  return part * m.spring * lagged(dashpot_ratio(m, omega));
}

std::complex<double> modulus_at(const Modulus& m, double p, double omega) {
  check_nonnegative("p", p);
  check_nonnegative("omega", omega);
  if (m.model == SpringModel::elastic) return m.spring;
  const std::complex<double> z(p, omega);
  if (m.model == SpringModel::kelvin_voigt) return m.spring + m.viscosity * z;
  // In units of 2^-53: share is good to 2, ratio to 4, less to 10, the sums to 14 and 11, a quotient to 6 more.
  const double both = m.spring + second_spring(m), share = second_spring(m) / both;
  const std::complex<double> ratio = m.viscosity / both * z;
  if (std::abs(ratio) < 1) return m.spring * ((share + ratio) / (1.0 + ratio));
  const std::complex<double> less = 1.0 / ratio;
  return m.spring * ((1.0 + share * less) / (1.0 + less));
}

Fading theta1(const Modulus& shear, double t) {
  check_nonnegative("t", t);
  switch (shear.model) {
    case SpringModel::elastic:
      return {0, 0};
    case SpringModel::kelvin_voigt:
      return faded(1 / (2 * shear.viscosity), shear.spring / shear.viscosity, t);
    default:
      return faded(1 / (2 * shear.viscosity), second_spring(shear) / shear.viscosity, t);
  }
}

// 6K + 2G = c - sum k_i/(p + s_i), so that 3/(6K + 2G) = (3/c) [1 + v . (p + M)^-1 v] with v_i^2 = k_i/c and
// M = diag(s) - v v, symmetric: a term for each of its principal directions, positive all.
Fading theta2(const Modulus& shear, const Modulus& bulk, double t) {
  check_nonnegative("t", t);
  if (shear.model == SpringModel::elastic) return {0, 0};
  if (shear.model == SpringModel::kelvin_voigt) {
    const double viscosity = 6 * bulk.viscosity + 2 * shear.viscosity;
    return faded(3 / viscosity, (6 * bulk.spring + 2 * shear.spring) / viscosity, t);
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
  // The determinant, without the terms that cancel.
  const double slow_rate =
      (second_bulk / bulk.viscosity * (m_shear / fast_rate)) +
      bulk.spring * share_shear / bulk.viscosity * (second_shear / shear.viscosity / fast_rate);
  // The fast direction is (cosine, -sine), the slow one (sine, cosine), from the smaller of the two.
  const double smaller = coupling / (std::fabs(half_apart) + radius), larger = 1 / std::hypot(1, smaller);
  const double sine = half_apart < 0 ? larger : larger * smaller,
               cosine = half_apart < 0 ? larger * smaller : larger;
  const double slow_weight = v_bulk * sine + v_shear * cosine;
  const double fast_weight = v_bulk * cosine - v_shear * sine;
  return faded(3 / at_once * slow_weight * slow_weight, slow_rate, t) +
         faded(3 / at_once * fast_weight * fast_weight, fast_rate, t);
}

}  // namespace nipref::fast
