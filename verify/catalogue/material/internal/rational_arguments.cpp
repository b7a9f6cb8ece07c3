#include <nipref/data/magnitude.hpp>
#include <nipref/verify/catalogue/material/internal/rational_arguments.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {
namespace {

bool is_nothing(double x) { return x == 0; }
bool is_nothing(const ref::Exact& x) { return x.sign() == 0; }

/// Series is data::PronyList or ref::ExactSeries. Amplitudes of 0 at the end of the list belong to no term.
template <class Series, class Number>
Series series_of(const Named<const Number>& x, const std::string& function) {
  const auto amplitudes = x.list(function + "_amplitude"), rates = x.list(function + "_rate");
  std::size_t terms = amplitudes.size();
  while (terms > 0 && is_nothing(amplitudes[terms - 1])) --terms;
  return {x[function + "_instantaneous"],
          {amplitudes.begin(), amplitudes.begin() + static_cast<std::ptrdiff_t>(terms)},
          {rates.begin(), rates.begin() + static_cast<std::ptrdiff_t>(terms)}};
}

template <class Number>
std::vector<Number> coefficients(const Named<const Number>& x, const std::string& polynomial) {
  const auto all = x.list(polynomial + "_0");
  return {all.begin(), all.end()};
}

/// Draws a second rate: the same, nearly the same, or any within four decades.
double other_rate(double rate, Random& random) {
  if (random.chance(0.2)) return rate;
  if (random.chance(0.3)) return rate * (1 + random.log_uniform(1e-16, 1e-2));
  return rate * random.log_uniform(1e-4, 1e4);
}

using Quadratic = std::array<double, 3>;

/// Draws p + a, or (p + a)(p + b) with real roots up to rounding, or a quadratic with complex roots.
Quadratic draw_p(double rate, Random& random) {
  if (random.chance(0.4)) return {rate, 1, 0};
  const double other = other_rate(rate, random), product = rate * other;
  const double turn = random.chance(0.3) ? random.log_uniform(1e-3, 1) : 1;
  return {product, turn < 1 ? 2 * std::sqrt(product) * turn : rate + other, 1};
}

/// Draws Q of a modulus Q/P that gains no energy: q1 p0 >= q0 p1, q2 p1 >= q1 p2. Some Q have a (nearly) double root.
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

/// A modulus Q/P of a spring and three or more branches side by side, each a spring in series with a dashpot: it gains
/// no energy. Empty if a coefficient would not be a magnitude.
struct Branches {
  std::vector<double> p{1}, q;
};
Branches draw_branches(double rate, double size, Random& random) {
  const auto times = [](const std::vector<double>& polynomial, double root) {
    std::vector<double> product(polynomial.size() + 1);
    for (std::size_t k = 0; k < polynomial.size(); ++k) {
      product[k] += root * polynomial[k];
      product[k + 1] += polynomial[k];
    }
    return product;
  };
  std::vector<double> rates(3 + random.index(random.chance(0.2) ? 14 : 4));
  for (double& one : rates) one = rate * random.log_uniform(1e-2, 1e2);
  Branches both;
  for (const double one : rates) both.p = times(both.p, one);
  both.q = both.p;
  for (double& c : both.q) c *= size;
  for (std::size_t k = 0; k < rates.size(); ++k) {
    std::vector<double> others{size * random.log_uniform(1e-2, 1e2)};
    for (std::size_t l = 0; l < rates.size(); ++l) others = times(others, l == k ? 0 : rates[l]);
    for (std::size_t i = 0; i < others.size(); ++i) both.q[i] += others[i];
  }
  const bool within =
      std::ranges::all_of(both.p, data::is_magnitude) && std::ranges::all_of(both.q, data::is_magnitude);
  return within ? both : Branches{};
}

void put_list(std::span<double> list, std::span<const double> values) {
  std::ranges::fill(list, 0);
  std::ranges::copy(values, list.begin());
}

}  // namespace

void default_unread(const NamedNumbers& x) {
  const auto& models = x.arguments()[argument_number(x.arguments(), "material")].models;
  const MaterialModel& chosen = models[x.choice("material")];
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
  const bool at_once = !random.chance(0.1);
  const std::size_t terms = random.chance(0.3) ? 1 : random.chance(0.6) ? 2 : 3 + random.index(14);
  const double slow = random.chance(0.1) ? 0 : random.log_uniform(1e-3, 1e3) / time;
  // Each part of theta2 is less than that of theta1, so that the bulk modulus is positive.
  const auto part = [&] { return random.chance(0.2) ? 0.25 : random.uniform(0.01, 0.9); };
  std::vector<double> rates, first, second;
  for (std::size_t k = 0; k < terms; ++k) {
    const double apart = (slow > 0 ? slow : 1 / time) * random.log_uniform(1e-3, 1e3);
    const bool is_near = slow > 0 && (k < 3 || random.chance(0.3));
    rates.push_back(k == 0 ? slow : is_near ? other_rate(slow, random) : apart);
    first.push_back(soft * random.log_uniform(1e-3, 1e3) * (rates[k] == 0 ? 1 / time : rates[k]));
    second.push_back(k > 0 && random.chance(0.2) ? 0 : first[k] * part());
  }
  x["theta1_instantaneous"] = at_once ? soft : 0;
  x["theta2_instantaneous"] = x["theta1_instantaneous"] * part();
  put_list(x.list("theta1_amplitude"), first);
  put_list(x.list("theta2_amplitude"), second);
  put_list(x.list("theta1_rate"), rates);
  put_list(x.list("theta2_rate"), rates);
}

void draw_operators(const NamedNumbers& x, double stiff, double time, Random& random) {
  const double rate = random.log_uniform(1e-2, 1e2) / time;
  const bool many = random.chance(0.3);
  const auto put = [&](const std::string& suffix, double near, const Quadratic* same) {
    const double size = stiff * random.log_uniform(0.1, 10);
    const Branches branches = many ? draw_branches(near, size, random) : Branches{};
    const Quadratic p = same != nullptr ? *same : draw_p(near, random);
    const bool use = !branches.q.empty();
    put_list(x.list("P" + suffix + "_0"), use ? std::span<const double>(branches.p) : p);
    put_list(x.list("Q" + suffix + "_0"),
             use ? std::span<const double>(branches.q) : draw_q(p, size, random));
    return p;
  };
  const Quadratic p = put("", rate, nullptr);
  const bool same = random.chance(0.3);
  put("_dilatation", rate * random.uniform(0.1, 10), same ? &p : nullptr);
}

}  // namespace nipref::verify
