#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include <nipref/verify/golden/confirm/number.hpp>

namespace nipref::verify::confirm {
namespace {

using Wide = Number<400>;
using WideComplex = ComplexNumber<400>;

/// The linear differential equations x' = A x.
struct States {
  std::array<std::array<Wide, 2>, 2> change;
  std::array<Wide, 2> start;

  /// The solution at t by the series of the matrix exponential at t/2^k, which is squared k times.
  [[nodiscard]] std::array<Wide, 2> after(const Wide& t) const {
    Matrix step{change[0][0] * t, change[0][1] * t, change[1][0] * t, change[1][1] * t};
    int halvings = 0;
    while (step.size() > 1) {
      step = step.over(2);
      ++halvings;
    }
    Matrix term{1, 0, 0, 1}, sum = term;
    for (int n = 1; n < 220; ++n) {
      term = (term * step).over(n);
      sum = sum + term;
    }
    for (int k = 0; k < halvings; ++k) sum = sum * sum;
    return {sum.a * start[0] + sum.b * start[1], sum.c * start[0] + sum.d * start[1]};
  }

 private:
  struct Matrix {
    Wide a, b, c, d;

    Matrix operator*(const Matrix& m) const {
      return {a * m.a + b * m.c, a * m.b + b * m.d, c * m.a + d * m.c, c * m.b + d * m.d};
    }
    Matrix operator+(const Matrix& m) const { return {a + m.a, b + m.b, c + m.c, d + m.d}; }
    [[nodiscard]] Matrix over(int n) const { return {a / n, b / n, c / n, d / n}; }
    [[nodiscard]] Wide size() const { return abs(a) + abs(b) + abs(c) + abs(d); }
  };
};

enum Model { standard_linear, kelvin_voigt, maxwell, elastic, prony, operators, thesis, one_time };

/// The springs and the dashpot of a modulus; the second spring is 0 in models that have none.
struct Parts {
  Wide spring, second, viscosity;
};

Model model_of(Arguments x) { return static_cast<Model>(static_cast<int>(x["material"])); }

/// modulus: shear or bulk.
Parts parts(Arguments x, const std::string& modulus) {
  return {x[modulus], model_of(x) == standard_linear ? x[modulus + "_2"] : 0.0, x[modulus + "_viscosity"]};
}

/// The strain e of a spring parallel to the dashpot: e' = drive - fade e, e(0) = 0.
Wide internal(const Wide& drive, const Wide& fade, double t) {
  const States states{{{{-fade, drive}, {0, 0}}}, {0, 1}};
  return states.after(t)[0];
}

Wide relaxation(Arguments x, const std::string& modulus) {
  const Parts m = parts(x, modulus);
  if (model_of(x) == elastic || model_of(x) == kelvin_voigt) return m.spring;
  // The state is the distance of e from its limit, so that the decaying part is not a difference of larger numbers.
  const Wide both = m.spring + m.second, part = m.spring / both;
  const States states{{{{-both / m.viscosity, 0}, {0, 0}}}, {part, 1}};
  return m.spring * (m.second / both + states.after(x["t"])[0]);
}

Wide creep(Arguments x, const std::string& modulus) {
  const Parts m = parts(x, modulus);
  if (model_of(x) == elastic) return 1 / m.spring;
  if (model_of(x) == kelvin_voigt) return internal(1 / m.viscosity, m.spring / m.viscosity, x["t"]);
  return 1 / m.spring + internal(1 / m.viscosity, m.second / m.viscosity, x["t"]);
}

WideComplex complex_modulus(Arguments x, const std::string& modulus) {
  const Parts m = parts(x, modulus);
  const WideComplex dashpot(Wide(0), m.viscosity * x["omega"]), spring(m.spring);
  if (model_of(x) == elastic) return spring;
  if (model_of(x) == kelvin_voigt) return spring + dashpot;
  const WideComplex beside = WideComplex(m.second) + dashpot;
  return spring * beside / (spring + beside);
}

Wide theta1(Arguments x) {
  const Parts m = parts(x, "shear");
  if (model_of(x) == elastic) return 0;
  const Wide beside = model_of(x) == kelvin_voigt ? m.spring : m.second;
  const States states{{{{-beside / m.viscosity, 0}, {0, 0}}}, {1 / m.viscosity, 0}};
  return states.after(x["t"])[0] / 2;
}

/// The response of 6 K + 2 G, two models in parallel, to an impulse of 3.
Wide theta2(Arguments x) {
  const Parts G = parts(x, "shear"), K = parts(x, "bulk");
  if (model_of(x) == elastic) return 0;
  if (model_of(x) == kelvin_voigt) {
    const Wide viscosity = 6 * K.viscosity + 2 * G.viscosity;
    const States states{{{{-(6 * K.spring + 2 * G.spring) / viscosity, 0}, {0, 0}}}, {3 / viscosity, 0}};
    return states.after(x["t"])[0];
  }
  const Wide at_once = 6 * K.spring + 2 * G.spring, a = 6 * K.spring / at_once, b = 2 * G.spring / at_once;
  const Wide k = K.spring / K.viscosity, g = G.spring / G.viscosity;
  const States states{
      {{{a * k - k - K.second / K.viscosity, b * k}, {a * g, b * g - g - G.second / G.viscosity}}},
      {3 * k / at_once, 3 * g / at_once}};
  const auto strain = states.after(x["t"]);
  return a * strain[0] + b * strain[1];
}

using Coefficients = std::vector<Wide>;

Coefficients times(const Coefficients& a, const Coefficients& b) {
  Coefficients c(a.size() + b.size() - 1, Wide(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) c[i + k] += a[i] * b[k];
  }
  return c;
}

Coefficients plus(const Coefficients& a, const Coefficients& b) {
  Coefficients c(std::max(a.size(), b.size()), Wide(0));
  for (std::size_t i = 0; i < a.size(); ++i) c[i] += a[i];
  for (std::size_t i = 0; i < b.size(); ++i) c[i] += b[i];
  return c;
}

struct Ratio {
  Coefficients above, below;
};

Ratio operator+(const Ratio& a, const Ratio& b) {
  return {plus(times(a.above, b.below), times(b.above, a.below)), times(a.below, b.below)};
}
Ratio operator*(const Wide& a, const Ratio& b) { return {times({a}, b.above), b.below}; }
Ratio inverse(const Ratio& a) { return {a.below, a.above}; }

/// instantaneous, amplitude, rate, amplitude, rate
Ratio series(std::span<const double> x) {
  Ratio sum{{x[0]}, {1}};
  for (const std::size_t k : {std::size_t{1}, std::size_t{3}}) {
    if (x[k] != 0) sum = sum + Ratio{{x[k]}, {x[k + 1], 1}};
  }
  return sum;
}

/// 1/(2G), 3/(6K + 2G), G and K of the models that are not given by springs.
struct Responses {
  Ratio theta1, theta2, G, K;

  explicit Responses(Arguments x) {
    if (model_of(x) == operators) {
      const auto coefficients = [&](const std::string& name) {
        return Coefficients{x[name + "_0"], x[name + "_1"], x[name + "_2"]};
      };
      G = {coefficients("Q"), coefficients("P")};
      K = {coefficients("Q_dilatation"), coefficients("P_dilatation")};
      theta1 = inverse(Wide(2) * G);
      theta2 = Wide(3) * inverse(Wide(6) * K + Wide(2) * G);
      return;
    }
    if (model_of(x) == thesis || model_of(x) == one_time) {
      const Wide rate = 1 / Wide(x["relaxation_time"]),
                 at_once = 3 / (6 * Wide(x["bulk"]) + 2 * Wide(x["shear"]));
      theta1 = (1 / (2 * Wide(x["shear"]))) * Ratio{{2 * rate, 1}, {rate, 1}};
      const Wide theta2_rate = (model_of(x) == thesis ? 2 : 1) * rate;
      theta2 = at_once * Ratio{{theta2_rate + rate, 1}, {theta2_rate, 1}};
    } else {
      theta1 = series(x.from("theta1_instantaneous"));
      theta2 = series(x.from("theta2_instantaneous"));
    }
    G = (Wide(1) / 2) * inverse(theta1);
    K = (Wide(1) / 6) * (Wide(3) * inverse(theta2) + Wide(-1) * inverse(theta1));
  }
};

using Rows = std::vector<Coefficients>;

Rows squared(const Rows& a, const Rows& b) {
  Rows c(a.size(), Coefficients(a.size(), Wide(0)));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < a.size(); ++k) {
      for (std::size_t j = 0; j < a.size(); ++j) c[i][j] += a[i][k] * b[k][j];
    }
  }
  return c;
}

/// The inverse Laplace transform without impulses: the solution of the differential equation whose characteristic
/// polynomial is the denominator, by the series of the matrix exponential at t/2^k, which is squared k times. The
/// unit of time is that of the largest root.
Wide in_time(Ratio r, double t) {
  const auto trim = [](Coefficients& c) {
    while (c.size() > 1 && c.back() == 0) c.pop_back();
  };
  trim(r.above);
  trim(r.below);
  const std::size_t n = r.below.size() - 1;
  if (n == 0) return 0;
  const Wide last = r.below.back();
  Wide unit = 0;
  for (std::size_t k = 0; k < n; ++k)
    unit = std::max<Wide>(unit, pow(Wide(abs(r.below[k] / last)), 1 / Wide(n - k)));
  if (unit == 0) unit = 1;
  Coefficients d(n), at_start;
  for (std::size_t k = 0; k < n; ++k) d[k] = r.below[k] / last / pow(unit, Wide(n - k));
  // f and its derivatives at 0 are the coefficients of the ratio's expansion in 1/p; p^0 and higher powers are
  // impulses.
  const std::size_t order = std::max(r.above.size(), n + 1);
  Coefficients left(order, Wide(0));
  for (std::size_t k = 0; k < r.above.size(); ++k) left[k] = r.above[k] / last;
  for (std::size_t k = order; k-- > n;) {
    for (std::size_t i = 0; i < n; ++i) left[k - n + i] -= left[k] * r.below[i] / last;
  }
  Coefficients numerator(n);
  for (std::size_t k = 0; k < n; ++k) numerator[k] = left[k] / pow(unit, Wide(n - 1 - k));
  for (std::size_t m = 0; m < n; ++m) {
    Wide next = numerator[n - 1 - m];
    for (std::size_t i = 0; i < m; ++i) next -= d[n - m + i] * at_start[i];
    at_start.push_back(next);
  }
  Wide step = unit * t;
  int halvings = 0;
  for (; step > Wide(1) / 16; step /= 2) ++halvings;
  Rows change(n, Coefficients(n, Wide(0))), term(n, Coefficients(n, Wide(0))), sum = change;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k)
      change[i][k] = i + 1 < n ? Wide(k == i + 1 ? 1 : 0) * step : Wide(-d[k] * step);
    term[i][i] = sum[i][i] = 1;
  }
  for (int m = 1; m < 160; ++m) {
    term = squared(term, change);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < n; ++k) sum[i][k] += term[i][k] /= m;
    }
  }
  for (int k = 0; k < halvings; ++k) sum = squared(sum, sum);
  Wide value = 0;
  for (std::size_t k = 0; k < n; ++k) value += sum[0][k] * at_start[k];
  return value;
}

/// The polynomial at i omega.
WideComplex at_frequency(const Coefficients& c, double omega) {
  WideComplex sum(0);
  for (std::size_t k = c.size(); k-- > 0;) sum = sum * WideComplex(Wide(0), Wide(omega)) + WideComplex(c[k]);
  return sum;
}

const Ratio& ratio_of(const Responses& all, const std::string& modulus) {
  return modulus == "shear" ? all.G : all.K;
}
Wide relaxation_of_ratio(Arguments x, const std::string& modulus) {
  const Responses all(x);
  const Ratio& ratio = ratio_of(all, modulus);
  return in_time({ratio.above, times({0, 1}, ratio.below)}, x["t"]);
}
Wide creep_of_ratio(Arguments x, const std::string& modulus) {
  const Responses all(x);
  const Ratio& ratio = ratio_of(all, modulus);
  return in_time({ratio.below, times({0, 1}, ratio.above)}, x["t"]);
}
WideComplex complex_modulus_of_ratio(Arguments x, const std::string& modulus) {
  const Responses all(x);
  const Ratio& ratio = ratio_of(all, modulus);
  return at_frequency(ratio.above, x["omega"]) / at_frequency(ratio.below, x["omega"]);
}

/// `springs` is for models of springs and dashpots, `ratio` for the others.
using Value = std::function<Wide(Arguments)>;

Confirm by_states(const Value& springs, const Value& ratio) {
  return [=](Arguments x) {
    const bool is_of_springs = model_of(x) <= elastic;
    const Wide found = (is_of_springs ? springs : ratio)(x);
    return confirmation<Wide>(is_of_springs ? "equations of springs and dashpots by their series"
                                            : "the differential equation by its series",
                              found, abs(found) * Wide(is_of_springs ? "1e-200" : "1e-100"));
  };
}

/// The same of a function of the modulus called `modulus`; `part` is Wide itself, or a part of a complex number.
template <class Of, class Part>
Confirm of_modulus(Of springs, Of ratio, const std::string& modulus, Part part) {
  return by_states(Value([=](Arguments x) { return part(springs(x, modulus)); }),
                   Value([=](Arguments x) { return part(ratio(x, modulus)); }));
}

void add_modulus(Methods& methods, const std::string& letter, const std::string& modulus) {
  const auto whole = [](const Wide& value) { return value; };
  const auto real = [](const WideComplex& value) -> Wide { return value.real(); };
  const auto imaginary = [](const WideComplex& value) -> Wide { return value.imag(); };
  methods["material." + letter] = of_modulus(relaxation, relaxation_of_ratio, modulus, whole);
  methods["material.creep_" + modulus] = of_modulus(creep, creep_of_ratio, modulus, whole);
  methods["material.storage_" + modulus] =
      of_modulus(complex_modulus, complex_modulus_of_ratio, modulus, real);
  methods["material.loss_" + modulus] =
      of_modulus(complex_modulus, complex_modulus_of_ratio, modulus, imaginary);
}

}  // namespace

const Methods& material_methods() {
  static const Methods methods = [] {
    Methods all{
        {"material.theta1",
         by_states(Value(theta1), Value([](Arguments x) { return in_time(Responses(x).theta1, x["t"]); }))},
        {"material.theta2",
         by_states(Value(theta2), Value([](Arguments x) { return in_time(Responses(x).theta2, x["t"]); }))}};
    add_modulus(all, "G", "shear");
    add_modulus(all, "K", "bulk");
    return all;
  }();
  return methods;
}

}  // namespace nipref::verify::confirm
