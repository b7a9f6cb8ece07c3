#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <nipref/verify/catalogue/material/internal/rational_arguments.hpp>

namespace nipref::verify {
namespace {

constexpr std::size_t per_polynomial = 3;

/// Series is data::PronyList or ref::ExactSeries.
template <class Series, class Number>
Series series_of(const Named<const Number>& x, const std::string& function) {
  return {x[function + "_instantaneous"],
          {x[function + "_amplitude"], x[function + "_amplitude_2"]},
          {x[function + "_rate"], x[function + "_rate_2"]}};
}

std::string coefficient(const std::string& polynomial, std::size_t power) {
  return polynomial + "_" + std::to_string(power);
}

template <class Number>
std::vector<Number> coefficients(const Named<const Number>& x, const std::string& polynomial) {
  return {x[coefficient(polynomial, 0)], x[coefficient(polynomial, 1)], x[coefficient(polynomial, 2)]};
}

/// A second rate: the same, nearly the same, or any within four decades.
double other_rate(double rate, Random& random) {
  if (random.chance(0.2)) return rate;
  if (random.chance(0.3)) return rate * (1 + random.log_uniform(1e-16, 1e-2));
  return rate * random.log_uniform(1e-4, 1e4);
}

using Quadratic = std::array<double, per_polynomial>;

/// Draws p + a, or (p + a)(p + b) with real roots up to rounding, or a quadratic with complex roots.
Quadratic draw_p(double rate, Random& random) {
  if (random.chance(0.4)) return {rate, 1, 0};
  const double other = other_rate(rate, random), product = rate * other;
  const double turn = random.chance(0.3) ? random.log_uniform(1e-3, 1) : 1;
  return {product, turn < 1 ? 2 * std::sqrt(product) * turn : rate + other, 1};
}

/// Draws Q of a modulus Q/P that gains no energy: q1 p0 >= q0 p1, q2 p1 >= q1 p2. Some Q have a double root, or nearly
/// so.
Quadratic draw_q(const Quadratic& p, double size, Random& random) {
  const double q0_of_q1 = p[0] / p[1];
  if (p[2] == 0) {
    const double soft = random.chance(0.15) ? 0 : random.uniform(0.05, 0.9);  // 0: a Maxwell fluid
    // With a highest power in Q alone there is no instantaneous deformation.
    const double highest = random.chance(0.15) ? size * random.log_uniform(1e-3, 1) / p[0] : 0;
    return {size * q0_of_q1 * soft, size, highest};
  }
  const double share = random.uniform(0.05, 1), q1 = size * p[1] * share;
  const double one_root = share * p[1] * p[1] / (4 * p[0]);
  double soft = random.log_uniform(1e-3, 1);
  if (one_root < 0.99 && random.chance(0.4))
    soft = one_root * (1 + (random.chance(0.3) ? 0 : random.log_uniform(1e-16, 1e-2)));
  return {q1 * q0_of_q1 * soft, q1, size};
}

}  // namespace

void default_unread(const NamedNumbers& x) {
  const auto& models = x.arguments()[argument_number(x.arguments(), "material")].models;
  const MaterialModel& chosen = models[static_cast<std::size_t>(x["material"])];
  for (const Argument& argument : x.arguments()) {
    const auto has_it = [&](const MaterialModel& model) { return model.holds(argument.name); };
    if (std::ranges::any_of(models, has_it) && !has_it(chosen)) x[argument.name] = default_number(argument);
  }
}

data::PronySeries prony_of(const NamedPoint& x) {
  return {series_of<data::PronyList>(x, "theta1"), series_of<data::PronyList>(x, "theta2")};
}

data::DifferentialOperators operators_of(const NamedPoint& x) {
  return {coefficients(x, "P"), coefficients(x, "Q"), coefficients(x, "P_dilatation"),
          coefficients(x, "Q_dilatation")};
}

ref::ExactSeries exact_series_of(const NamedExact& x, const std::string& function) {
  return series_of<ref::ExactSeries>(x, function);
}

ref::ExactRationalSolid exact_prony_of(const NamedExact& x) {
  return ref::exact_prony(exact_series_of(x, "theta1"), exact_series_of(x, "theta2"));
}

ref::ExactRationalSolid exact_operators_of(const NamedExact& x) {
  return ref::exact_operators(coefficients(x, "P"), coefficients(x, "Q"), coefficients(x, "P_dilatation"),
                              coefficients(x, "Q_dilatation"));
}

void draw_prony(const NamedNumbers& x, double soft, double time, Random& random) {
  const bool at_once = !random.chance(0.1), two = random.chance(0.7);
  const double rate = random.chance(0.1) ? 0 : random.log_uniform(1e-3, 1e3) / time;
  const double rate_2 = rate == 0 ? 1 / time : other_rate(rate, random);
  const double instantaneous = at_once ? soft : 0;
  const double amplitude = soft * random.log_uniform(1e-3, 1e3) * (rate == 0 ? 1 / time : rate);
  const double amplitude_2 = two ? soft * random.log_uniform(1e-3, 1e3) * rate_2 : 0;
  const auto put = [&](const std::string& name, double at_start, double first, double second) {
    x[name + "_instantaneous"] = at_start;
    x[name + "_amplitude"] = first;
    x[name + "_rate"] = rate;
    x[name + "_amplitude_2"] = second;
    x[name + "_rate_2"] = rate_2;
  };
  put("theta1", instantaneous, amplitude, amplitude_2);
  // Each part of theta2 is less than that of theta1, so that the bulk modulus is positive.
  const bool fades = random.chance(0.8);
  std::array<double, 3> parts{instantaneous, amplitude, amplitude_2};
  for (double& part : std::span(parts).first(fades ? 3 : 2))
    part *= random.chance(0.2) ? 0.25 : random.uniform(0.01, 0.9);
  put("theta2", parts[0], parts[1], fades ? parts[2] : 0);
}

void draw_operators(const NamedNumbers& x, double stiff, double time, Random& random) {
  const double rate = random.log_uniform(1e-2, 1e2) / time;
  const Quadratic p = draw_p(rate, random);
  const Quadratic p_dilatation = random.chance(0.3) ? p : draw_p(rate * random.uniform(0.1, 10), random);
  const auto put = [&](const std::string& name, const Quadratic& polynomial) {
    for (std::size_t k = 0; k < per_polynomial; ++k) x[coefficient(name, k)] = polynomial[k];
  };
  put("P", p);
  put("Q", draw_q(p, stiff * random.log_uniform(0.1, 10), random));
  put("P_dilatation", p_dilatation);
  put("Q_dilatation", draw_q(p_dilatation, stiff * random.log_uniform(0.1, 10), random));
}

}  // namespace nipref::verify
