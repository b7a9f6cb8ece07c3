#include <Eigen/Dense>
#include <boost/multiprecision/eigen.hpp>

#include <nipref/verify/golden/confirm/rational.hpp>

namespace nipref::verify::confirm {
namespace {

enum Model { standard_linear, kelvin_voigt, maxwell, elastic, prony, operators, thesis, one_time };

/// The modulus of springs and a dashpot. `name` is shear or bulk.
Ratio springs(Arguments x, Model model, const std::string& name) {
  const Long spring = x[name], dashpot = x[name + "_viscosity"];
  if (model == elastic) return {{spring}, {Long(1)}};
  if (model == kelvin_voigt) return {{spring, dashpot}, {Long(1)}};
  const Long second = model == maxwell ? Long(0) : Long(x[name + "_2"]);
  return {{Long(spring * second), Long(spring * dashpot)}, {Long(spring + second), dashpot}};
}

/// The Prony series of `function`, which is theta1 or theta2.
Ratio series(Arguments x, const std::string& function) {
  Ratio sum{{Long(x[function + "_instantaneous"])}, {Long(1)}};
  const auto amplitudes = x.list(function + "_amplitude"), rates = x.list(function + "_rate");
  // Terms of equal rate are added up, because a double root would be found slowly or not at all.
  std::map<double, Long> by_rate;
  for (std::size_t k = 0; k < amplitudes.size(); ++k)
    if (amplitudes[k] != 0) by_rate[rates[k]] += amplitudes[k];
  for (const auto& [rate, amplitude] : by_rate) sum = sum + Ratio{{amplitude}, {Long(rate), Long(1)}};
  return sum;
}

struct Responses : Compliance, Moduli {
  explicit Responses(const Moduli& moduli) : Compliance(moduli), Moduli(moduli) {}
  explicit Responses(const Compliance& of)
      : Compliance(of),
        Moduli{(Long(1) / 2) * inverse(of.theta1),
               (Long(1) / 6) * (Long(3) * inverse(of.theta2) + Long(-1) * inverse(of.theta1))} {}
};

Responses responses(Arguments x) {
  const Model model = static_cast<Model>(static_cast<int>(x["material"]));
  if (model <= elastic) return Responses(Moduli{springs(x, model, "shear"), springs(x, model, "bulk")});
  if (model == operators) return Responses(operator_moduli(x));
  if (model == prony) return Responses(Compliance(series(x, "theta1"), series(x, "theta2")));
  return Responses(Compliance(x["bulk"], x["shear"], x["relaxation_time"], model == thesis ? 2 : 1));
}

/// The inverse Laplace transform of r at the time t, without impulses. It solves the differential equation whose
/// characteristic polynomial is the denominator, with the companion matrix A. The exponential of A t is its series at
/// t/2^k, squared k times, in a unit of time that suits the largest root. The last column of (p - A)^-1 is 1, p, p^2,
/// ... over the denominator.
Long in_time(Ratio r, double t) {
  using Matrix = Eigen::Matrix<Long, Eigen::Dynamic, Eigen::Dynamic>;
  r.above.normalize();
  r.below.normalize();
  // A common root 0 would add rounding errors that do not decay.
  while (r.below[0] == 0 && r.above[0] == 0) {
    r.below >>= 1;
    r.above >>= 1;
  }
  const std::size_t n = r.below.size() - 1;
  if (n == 0) return 0;
  const Long last = r.below[n];
  Long unit = 0;
  for (std::size_t k = 0; k < n; ++k)
    unit = std::max<Long>(unit, pow(Long(abs(r.below[k] / last)), 1 / Long(n - k)));
  if (unit == 0) unit = 1;
  Long step = unit * t;
  int halvings = 0;
  for (; step > Long(1) / 16; step /= 2) ++halvings;
  const auto size = static_cast<Eigen::Index>(n);
  Matrix change = Matrix::Zero(size, size), sum = Matrix::Identity(size, size), term = sum;
  for (std::size_t k = 0; k < n; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    if (k + 1 < n) change(i, i + 1) = step;
    change(size - 1, i) = -step * r.below[k] / last / pow(unit, Long(n - k));
  }
  for (int m = 1; m < 160; ++m) {
    term = (term.lazyProduct(change) / Long(m)).eval();
    sum += term;
  }
  for (int k = 0; k < halvings; ++k) sum = sum.lazyProduct(sum).eval();
  // The quotient of the division, which is left out, transforms to the impulses.
  const Polynomial rest = r.above % r.below;
  Long value = 0;
  for (std::size_t k = 0; k < rest.size(); ++k)
    value += rest[k] / last / pow(unit, Long(n - 1 - k)) * sum(static_cast<Eigen::Index>(k), size - 1);
  return value;
}

/// `ratio` over the Laplace variable: the response to a step.
Ratio to_step(const Ratio& ratio) { return {ratio.above, ratio.below * Polynomial{Long(0), Long(1)}}; }

/// The ratio at growth + i omega.
LongComplex at_frequency(const Ratio& ratio, double omega, double growth = 0) {
  const LongComplex p(growth, omega);
  return value_at(ratio.above, p) / value_at(ratio.below, p);
}

/// Returns the method that computes `value` from the responses and the point.
template <class Value>
Confirm by_series(Value value) {
  return [value](Arguments x) {
    const Long found = value(responses(x), x);
    return confirmation("the differential equation by its series", found, abs(found) * Long("1e-100"));
  };
}

void add_modulus(Methods& methods, const std::string& letter, const std::string& name, Ratio Moduli::*m) {
  const auto add = [&](const std::string& quantity, auto value) {
    methods["material." + quantity] =
        by_series([=](const Responses& all, Arguments x) -> Long { return value(all.*m, x); });
  };
  add(letter, [](const Ratio& modulus, Arguments x) { return in_time(to_step(modulus), x["t"]); });
  add("creep_" + name,
      [](const Ratio& modulus, Arguments x) { return in_time(to_step(inverse(modulus)), x["t"]); });
  add("storage_" + name,
      [](const Ratio& modulus, Arguments x) { return at_frequency(modulus, x["omega"]).real(); });
  add("loss_" + name,
      [](const Ratio& modulus, Arguments x) { return at_frequency(modulus, x["omega"]).imag(); });
  add(letter + "_of_p", [](const Ratio& modulus, Arguments x) -> Long {
    const LongComplex value = at_frequency(modulus, x["omega"], x["p"]);
    return x["part"] == 0 ? value.real() : value.imag();
  });
}

/// The amplitude gamma or the rate lambda of a term.
Confirmation of_term(Arguments x, bool amplitude) {
  const Responses all = responses(x);
  auto [at_once, terms] = in_exponentials(x["of"] == 0 ? all.theta1 : all.theta2);
  std::ranges::sort(terms, [](const auto& a, const auto& b) {
    const Long apart = a.rate.real() - b.rate.real();
    return abs(apart) <= Long("1e-90") * abs(a.rate) ? a.rate.imag() < b.rate.imag() : apart < 0;
  });
  const auto number = static_cast<std::size_t>(x["term"]);
  const LongComplex value = number == 0 ? LongComplex(at_once)
                            : amplitude ? terms.at(number - 1).amplitude
                                        : terms.at(number - 1).rate;
  return confirmation("roots by Durand and Kerner", x["part"] == 0 ? value.real() : value.imag(),
                      abs(value) * Long("1e-60"));
}

}  // namespace

Moduli operator_moduli(std::span<const double> p, std::span<const double> q,
                       std::span<const double> p_dilatation, std::span<const double> q_dilatation) {
  const auto polynomial = [](std::span<const double> all) { return Polynomial(all.begin(), all.end()); };
  return {{polynomial(q), polynomial(p)}, {polynomial(q_dilatation), polynomial(p_dilatation)}};
}

Compliance::Compliance(const Long& bulk, const Long& shear, const Long& relaxation_time, int rate_factor) {
  // at_once (1 + rate/(p + decay))
  const Long rate = 1 / relaxation_time;
  const auto relaxing = [&](const Long& at_once, const Long& decay) {
    return at_once * Ratio{{Long(decay + rate), Long(1)}, {decay, Long(1)}};
  };
  theta1 = relaxing(1 / (2 * shear), rate);
  theta2 = relaxing(3 / (6 * bulk + 2 * shear), rate_factor * rate);
}

Methods material_methods() {
  Methods all{{"material.theta1",
               by_series([](const Responses& of, Arguments x) { return in_time(of.theta1, x["t"]); })},
              {"material.theta2",
               by_series([](const Responses& of, Arguments x) { return in_time(of.theta2, x["t"]); })},
              {"material.gamma", [](Arguments x) { return of_term(x, true); }},
              {"material.lambda", [](Arguments x) { return of_term(x, false); }}};
  add_modulus(all, "G", "shear", &Moduli::G);
  add_modulus(all, "K", "bulk", &Moduli::K);
  return all;
}

}  // namespace nipref::verify::confirm
