#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <nipref/verify/catalogue/material/internal/rational_arguments.hpp>

namespace nipref::verify {
namespace {

constexpr std::array<const char*, 2> functions{"theta1", "theta2"};
constexpr std::array<const char*, 4> polynomials{"P", "Q", "P_dilatation", "Q_dilatation"};
constexpr std::size_t per_function = 5, per_polynomial = 3;

data::PronyList prony_list(std::span<const double> x) { return {x[0], {x[1], x[3]}, {x[2], x[4]}}; }
ref::ExactSeries exact_series(std::span<const ref::Exact> x) { return {x[0], {x[1], x[3]}, {x[2], x[4]}}; }

template <class Number>
std::vector<Number> coefficients(std::span<const Number> x, std::size_t polynomial) {
  const auto part = x.subspan(polynomial * per_polynomial, per_polynomial);
  return {part.begin(), part.end()};
}

/// Twice as fast, or equal, nearly so, or any.
double other_rate(double rate, Random& random) {
  if (random.chance(0.2)) return rate;
  if (random.chance(0.3)) return rate * (1 + random.log_uniform(1e-16, 1e-2));
  return rate * random.log_uniform(1e-4, 1e4);
}

using Quadratic = std::array<double, per_polynomial>;

/// (p + a)(p + b), to rounding, or with complex roots; or p + a.
Quadratic draw_p(double rate, Random& random) {
  if (random.chance(0.4)) return {rate, 1, 0};
  const double other = other_rate(rate, random), product = rate * other;
  const double turn = random.chance(0.3) ? random.log_uniform(1e-3, 1) : 1;
  return {product, turn < 1 ? 2 * std::sqrt(product) * turn : rate + other, 1};
}

/// Of a modulus Q/P that gains no energy: q1 p0 >= q0 p1, q2 p1 >= q1 p2. Roots that are one, or nearly, among them.
Quadratic draw_q(const Quadratic& p, double size, Random& random) {
  const double q0_of_q1 = p[0] / p[1];
  if (p[2] == 0) {
    const double soft = random.chance(0.15) ? 0 : random.uniform(0.05, 0.9);  // 0: Maxwell's
    // Nothing gives way at once.
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

void append_prony_arguments(std::vector<Argument>& arguments) {
  for (const std::string name : functions) {
    const char* one = name == "theta1" ? "1" : "0.25";
    arguments.push_back({name + "_instantaneous", ArgumentKind::nonnegative, one, {}});
    arguments.push_back({name + "_amplitude", ArgumentKind::amplitude, one, {}});
    arguments.push_back({name + "_rate", ArgumentKind::rate, "1", {}});
    arguments.push_back({name + "_amplitude_2", ArgumentKind::amplitude, "0", {}});
    arguments.push_back({name + "_rate_2", ArgumentKind::rate, "1", {}});
  }
}

void append_operator_arguments(std::vector<Argument>& arguments) {
  // G = 0.375 (1 + p)/(2 + p), K = (1 + p)/(2 + p)
  constexpr std::array<std::array<const char*, per_polynomial>, 4> standard{
      {{"2", "1", "0"}, {"0.375", "0.375", "0"}, {"2", "1", "0"}, {"1", "1", "0"}}};
  for (std::size_t i = 0; i < polynomials.size(); ++i) {
    for (std::size_t k = 0; k < per_polynomial; ++k)
      arguments.push_back({std::string(polynomials[i]) + "_" + std::to_string(k),
                           ArgumentKind::nonnegative,
                           standard[i][k],
                           {}});
  }
}

std::vector<ModelKey> keys_of_numbers(const std::vector<std::string>& arguments) {
  std::vector<ModelKey> keys;
  for (const std::string& argument : arguments) keys.push_back({argument, {argument}});
  return keys;
}

std::vector<ModelKey> prony_keys() {
  std::vector<ModelKey> keys;
  for (const std::string name : functions) {
    keys.push_back({name + "_instantaneous", {name + "_instantaneous"}});
    keys.push_back({name + "_amplitudes", {name + "_amplitude", name + "_amplitude_2"}});
    keys.push_back({name + "_rates", {name + "_rate", name + "_rate_2"}});
  }
  return keys;
}

std::vector<ModelKey> operator_keys() {
  std::vector<ModelKey> keys;
  for (const std::string name : polynomials) keys.push_back({name, {name + "_0", name + "_1", name + "_2"}});
  return keys;
}

void default_unread(std::span<double> x, const std::vector<Argument>& arguments) {
  const auto has = [](const std::vector<ModelKey>& keys, const std::string& argument) {
    return std::ranges::any_of(keys, [&](const ModelKey& key) {
      return std::ranges::find(key.arguments, argument) != key.arguments.end();
    });
  };
  const std::size_t at =
      static_cast<std::size_t>(std::ranges::find(arguments, "material", &Argument::name) - arguments.begin());
  const auto& keys = arguments[at].keys;
  const auto model = static_cast<std::size_t>(x[at]);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto has_it = [&](const std::vector<ModelKey>& of_one) { return has(of_one, arguments[i].name); };
    if (std::ranges::any_of(keys, has_it) && !has_it(keys[model]))
      x[i] = std::stod(*arguments[i].default_text);
  }
}

data::PronySeries prony_of(std::span<const double> x) {
  return {prony_list(x), prony_list(x.subspan(per_function))};
}

data::DifferentialOperators operators_of(std::span<const double> x) {
  return {coefficients(x, 0), coefficients(x, 1), coefficients(x, 2), coefficients(x, 3)};
}

ref::ExactRationalSolid exact_prony_of(std::span<const ref::Exact> x) {
  return ref::exact_prony(exact_series(x), exact_series(x.subspan(per_function)));
}

ref::ExactRationalSolid exact_operators_of(std::span<const ref::Exact> x) {
  return ref::exact_operators(coefficients(x, 0), coefficients(x, 1), coefficients(x, 2), coefficients(x, 3));
}

void draw_prony(Point& x, double soft, double time, Random& random) {
  const bool at_once = !random.chance(0.1), two = random.chance(0.7);
  double rate = random.chance(0.1) ? 0 : random.log_uniform(1e-3, 1e3) / time;
  const double rate_2 = rate == 0 ? 1 / time : other_rate(rate, random);
  const double instantaneous = at_once ? soft : 0;
  const double amplitude = soft * random.log_uniform(1e-3, 1e3) * (rate == 0 ? 1 / time : rate);
  const double amplitude_2 = two ? soft * random.log_uniform(1e-3, 1e3) * rate_2 : 0;
  // theta2 is less in each part, so that K resists.
  const auto part = [&] { return random.chance(0.2) ? 0.25 : random.uniform(0.01, 0.9); };
  x.insert(x.end(), {instantaneous, amplitude, rate, amplitude_2, rate_2});
  const bool fades = random.chance(0.8);
  x.insert(x.end(),
           {instantaneous * part(), amplitude * part(), rate, fades ? amplitude_2 * part() : 0, rate_2});
}

void draw_operators(Point& x, double stiff, double time, Random& random) {
  const double rate = random.log_uniform(1e-2, 1e2) / time;
  const Quadratic p = draw_p(rate, random);
  const Quadratic p_dilatation = random.chance(0.3) ? p : draw_p(rate * random.uniform(0.1, 10), random);
  for (const Quadratic* part : {&p, &p_dilatation}) {
    const Quadratic q = draw_q(*part, stiff * random.log_uniform(0.1, 10), random);
    x.insert(x.end(), part->begin(), part->end());
    x.insert(x.end(), q.begin(), q.end());
  }
}

}  // namespace nipref::verify
