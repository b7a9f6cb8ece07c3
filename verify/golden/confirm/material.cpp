#include <Eigen/Dense>
#include <algorithm>
#include <boost/multiprecision/eigen.hpp>
#include <map>
#include <string>

#include <nipref/verify/golden/confirm/rational.hpp>

namespace nipref::verify::confirm {
namespace {

using Wide = Number<400>;
using WideComplex = ComplexNumber<400>;
using Coefficients = Polynomial<Wide>;
using Response = Ratio<Wide>;

enum Model { standard_linear, kelvin_voigt, maxwell, elastic, prony, operators, thesis, one_time };

/// A modulus of springs and a dashpot. name: shear or bulk.
Response springs(Arguments x, Model model, const std::string& name) {
  const Wide spring = x[name], dashpot = x[name + "_viscosity"];
  if (model == elastic) return {{spring}, {Wide(1)}};
  if (model == kelvin_voigt) return {{spring, dashpot}, {Wide(1)}};
  const Wide second = model == maxwell ? Wide(0) : Wide(x[name + "_2"]);
  return {{Wide(spring * second), Wide(spring * dashpot)}, {Wide(spring + second), dashpot}};
}

/// function: theta1 or theta2.
Response series(Arguments x, const std::string& function) {
  Response sum{{Wide(x[function + "_instantaneous"])}, {Wide(1)}};
  const auto amplitudes = x.list(function + "_amplitude"), rates = x.list(function + "_rate");
  // Terms of one rate are one, as a double root would be found slowly or not at all.
  std::map<double, Wide> by_rate;
  for (std::size_t k = 0; k < amplitudes.size(); ++k)
    if (amplitudes[k] != 0) by_rate[rates[k]] += amplitudes[k];
  for (const auto& [rate, amplitude] : by_rate) sum = sum + Response{{amplitude}, {Wide(rate), Wide(1)}};
  return sum;
}

/// at_once (1 + rate/(p + decay))
Response relaxing(const Wide& at_once, const Wide& rate, const Wide& decay) {
  return at_once * Response{{Wide(decay + rate), Wide(1)}, {decay, Wide(1)}};
}

/// G and K, theta1 = 1/(2G) and theta2 = 3/(6K + 2G).
struct Responses {
  Response theta1, theta2, G, K;

  explicit Responses(Arguments x) {
    const Model model = static_cast<Model>(static_cast<int>(x["material"]));
    if (model <= elastic || model == operators) {
      const auto coefficients = [&](const std::string& name) {
        const auto all = x.list(name + "_0");
        return Coefficients(all.begin(), all.end());
      };
      const bool has_springs = model <= elastic;
      G = has_springs ? springs(x, model, "shear") : Response{coefficients("Q"), coefficients("P")};
      K = has_springs ? springs(x, model, "bulk")
                      : Response{coefficients("Q_dilatation"), coefficients("P_dilatation")};
      theta1 = inverse(Wide(2) * G);
      theta2 = Wide(3) * inverse(Wide(6) * K + Wide(2) * G);
      return;
    }
    if (model == prony) {
      theta1 = series(x, "theta1");
      theta2 = series(x, "theta2");
    } else {
      const Wide shear = x["shear"], rate = 1 / Wide(x["relaxation_time"]);
      theta1 = relaxing(1 / (2 * shear), rate, rate);
      theta2 = relaxing(3 / (6 * Wide(x["bulk"]) + 2 * shear), rate, model == thesis ? Wide(2 * rate) : rate);
    }
    G = (Wide(1) / 2) * inverse(theta1);
    K = (Wide(1) / 6) * (Wide(3) * inverse(theta2) + Wide(-1) * inverse(theta1));
  }
};

/// The inverse Laplace transform without impulses: the solution of the differential equation whose characteristic
/// polynomial is the denominator, by the series of the matrix exponential at t/2^k, which is squared k times. The
/// unit of time is that of the largest root.
Wide in_time(Response r, double t) {
  using Matrix = Eigen::Matrix<Wide, Eigen::Dynamic, Eigen::Dynamic>;
  r.above.normalize();
  r.below.normalize();
  // A common root 0 would leave rounding errors beside what decays.
  while (r.below[0] == 0 && r.above[0] == 0) {
    r.below >>= 1;
    r.above >>= 1;
  }
  const std::size_t n = r.below.size() - 1;
  if (n == 0) return 0;
  const Wide last = r.below[n];
  Wide unit = 0;
  for (std::size_t k = 0; k < n; ++k)
    unit = std::max<Wide>(unit, pow(Wide(abs(r.below[k] / last)), 1 / Wide(n - k)));
  if (unit == 0) unit = 1;
  std::vector<Wide> d(n), numerator(n), at_start;
  for (std::size_t k = 0; k < n; ++k) d[k] = r.below[k] / last / pow(unit, Wide(n - k));
  // f and its derivatives at 0 are the coefficients of the ratio's expansion in 1/p; p^0 and higher powers are
  // impulses.
  const Coefficients rest = r.above % r.below;
  for (std::size_t k = 0; k < rest.size(); ++k) numerator[k] = rest[k] / last / pow(unit, Wide(n - 1 - k));
  for (std::size_t m = 0; m < n; ++m) {
    Wide next = numerator[n - 1 - m];
    for (std::size_t i = 0; i < m; ++i) next -= d[n - m + i] * at_start[i];
    at_start.push_back(next);
  }
  Wide step = unit * t;
  int halvings = 0;
  for (; step > Wide(1) / 16; step /= 2) ++halvings;
  const auto size = static_cast<Eigen::Index>(n);
  Matrix change = Matrix::Zero(size, size), sum = Matrix::Identity(size, size), term = sum;
  for (Eigen::Index i = 0; i < size; ++i) {
    if (i + 1 < size) change(i, i + 1) = step;
    change(size - 1, i) = -d[static_cast<std::size_t>(i)] * step;
  }
  for (int m = 1; m < 160; ++m) {
    term = (term * change / Wide(m)).eval();
    sum += term;
  }
  for (int k = 0; k < halvings; ++k) sum = (sum * sum).eval();
  Wide value = 0;
  for (std::size_t k = 0; k < n; ++k) value += sum(0, static_cast<Eigen::Index>(k)) * at_start[k];
  return value;
}

/// `ratio` over the Laplace variable: the response to a step.
Response to_step(const Response& ratio) {
  return {ratio.above, ratio.below * Coefficients{Wide(0), Wide(1)}};
}

WideComplex at_frequency(const Response& ratio, double omega) {
  const WideComplex p(Wide(0), Wide(omega));
  return value_at(ratio.above, p) / value_at(ratio.below, p);
}

/// `value`: of the responses and the point.
template <class Value>
Confirm by_series(Value value) {
  return [value](Arguments x) {
    const Wide found = value(Responses(x), x);
    return confirmation<Wide>("the differential equation by its series", found, abs(found) * Wide("1e-100"));
  };
}

void add_modulus(Methods& methods, const std::string& letter, const std::string& name,
                 Response Responses::*m) {
  const auto add = [&](const std::string& quantity, auto value) {
    methods["material." + quantity] =
        by_series([=](const Responses& all, Arguments x) -> Wide { return value(all.*m, x); });
  };
  add(letter, [](const Response& modulus, Arguments x) { return in_time(to_step(modulus), x["t"]); });
  add("creep_" + name,
      [](const Response& modulus, Arguments x) { return in_time(to_step(inverse(modulus)), x["t"]); });
  add("storage_" + name,
      [](const Response& modulus, Arguments x) { return at_frequency(modulus, x["omega"]).real(); });
  add("loss_" + name,
      [](const Response& modulus, Arguments x) { return at_frequency(modulus, x["omega"]).imag(); });
  add(letter + "_of_p", [](const Response& modulus, Arguments x) -> Wide {
    const Wide growth = x["p"], omega = x["omega"];
    const WideComplex p(growth, omega);
    const WideComplex value = value_at(modulus.above, p) / value_at(modulus.below, p);
    return x["part"] == 0 ? value.real() : value.imag();
  });
}

/// gamma or lambda of a term.
Confirmation of_term(Arguments x, bool amplitude) {
  const Responses all(x);
  Response theta = x["of"] == 0 ? all.theta1 : all.theta2;
  theta.above.normalize();
  theta.below.normalize();
  auto [at_once, terms] = in_exponentials<400>(theta);
  std::ranges::sort(terms, [](const auto& a, const auto& b) {
    const Wide apart = a.rate.real() - b.rate.real();
    return abs(apart) <= Wide("1e-90") * abs(a.rate) ? a.rate.imag() < b.rate.imag() : apart < 0;
  });
  const auto number = static_cast<std::size_t>(x["term"]);
  const WideComplex value = number == 0 ? WideComplex(at_once)
                            : amplitude ? terms.at(number - 1).amplitude
                                        : terms.at(number - 1).rate;
  return confirmation<Wide>("roots by Durand and Kerner", x["part"] == 0 ? value.real() : value.imag(),
                            abs(value) * Wide("1e-60"));
}

}  // namespace

const Methods& material_methods() {
  static const Methods methods = [] {
    Methods all{{"material.theta1",
                 by_series([](const Responses& of, Arguments x) { return in_time(of.theta1, x["t"]); })},
                {"material.theta2",
                 by_series([](const Responses& of, Arguments x) { return in_time(of.theta2, x["t"]); })},
                {"material.gamma", [](Arguments x) { return of_term(x, true); }},
                {"material.lambda", [](Arguments x) { return of_term(x, false); }}};
    add_modulus(all, "G", "shear", &Responses::G);
    add_modulus(all, "K", "bulk", &Responses::K);
    return all;
  }();
  return methods;
}

}  // namespace nipref::verify::confirm
