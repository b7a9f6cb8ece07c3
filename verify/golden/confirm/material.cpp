#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include <nipref/verify/golden/confirm/material.hpp>
#include <nipref/verify/golden/confirm/number.hpp>

namespace nipref::verify::confirm {
namespace {

using Arguments = std::span<const double>;
using Wide = Number<400>;
using WideComplex = ComplexNumber<400>;

/// x' = A x
struct States {
  std::array<std::array<Wide, 2>, 2> change;
  std::array<Wide, 2> start;

  /// By the exponential's series at t/2^k, squared k times.
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

enum Model { standard_linear, kelvin_voigt, maxwell, elastic, prony, operators, thesis };

/// Springs and dashpot of a modulus; the second spring 0 where there is none.
struct Parts {
  Wide spring, second, viscosity;
};

Model model_of(Arguments x) { return static_cast<Model>(static_cast<int>(x[1])); }

Parts parts(Arguments x, std::size_t at) {
  return {x[at], model_of(x) == standard_linear ? x[at + 1] : 0.0, x[at + 2]};
}

/// The strain e of what is beside the dashpot, and 1: e' = drive - fade e.
Wide internal(const Wide& drive, const Wide& fade, double t) {
  const States states{{{{-fade, drive}, {0, 0}}}, {0, 1}};
  return states.after(t)[0];
}

Wide relaxation(Arguments x, std::size_t at) {
  const Parts m = parts(x, at);
  if (model_of(x) == elastic || model_of(x) == kelvin_voigt) return m.spring;
  // Written so that what fades is not left over of a difference: e is short of its last value by what fades.
  const Wide both = m.spring + m.second, part = m.spring / both;
  const States states{{{{-both / m.viscosity, 0}, {0, 0}}}, {part, 1}};
  return m.spring * (m.second / both + states.after(x[0])[0]);
}

Wide creep(Arguments x, std::size_t at) {
  const Parts m = parts(x, at);
  if (model_of(x) == elastic) return 1 / m.spring;
  if (model_of(x) == kelvin_voigt) return internal(1 / m.viscosity, m.spring / m.viscosity, x[0]);
  return 1 / m.spring + internal(1 / m.viscosity, m.second / m.viscosity, x[0]);
}

WideComplex modulus(Arguments x, std::size_t at) {
  const Parts m = parts(x, at);
  const WideComplex dashpot(Wide(0), m.viscosity * x[0]), spring(m.spring);
  if (model_of(x) == elastic) return spring;
  if (model_of(x) == kelvin_voigt) return spring + dashpot;
  const WideComplex beside = WideComplex(m.second) + dashpot;
  return spring * beside / (spring + beside);
}

Wide theta1(Arguments x) {
  const Parts m = parts(x, 2);
  if (model_of(x) == elastic) return 0;
  const Wide beside = model_of(x) == kelvin_voigt ? m.spring : m.second;
  const States states{{{{-beside / m.viscosity, 0}, {0, 0}}}, {1 / m.viscosity, 0}};
  return states.after(x[0])[0] / 2;
}

/// Six bulk moduli and two shear moduli side by side, under three units of impulse.
Wide theta2(Arguments x) {
  const Parts G = parts(x, 2), K = parts(x, 5);
  if (model_of(x) == elastic) return 0;
  if (model_of(x) == kelvin_voigt) {
    const Wide viscosity = 6 * K.viscosity + 2 * G.viscosity;
    const States states{{{{-(6 * K.spring + 2 * G.spring) / viscosity, 0}, {0, 0}}}, {3 / viscosity, 0}};
    return states.after(x[0])[0];
  }
  const Wide at_once = 6 * K.spring + 2 * G.spring, a = 6 * K.spring / at_once, b = 2 * G.spring / at_once;
  const Wide k = K.spring / K.viscosity, g = G.spring / G.viscosity;
  const States states{
      {{{a * k - k - K.second / K.viscosity, b * k}, {a * g, b * g - g - G.second / G.viscosity}}},
      {3 * k / at_once, 3 * g / at_once}};
  const auto strain = states.after(x[0]);
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

Ratio series(Arguments x) {
  Ratio sum{{x[0]}, {1}};
  for (const std::size_t k : {std::size_t{1}, std::size_t{3}}) {
    if (x[k] != 0) sum = sum + Ratio{{x[k]}, {x[k + 1], 1}};
  }
  return sum;
}

/// 1/(2G), 3/(6K + 2G), G, K by the constants of what is not made of springs.
struct Responses {
  Ratio theta1, theta2, G, K;

  explicit Responses(Arguments x) {
    if (model_of(x) == operators) {
      const auto coefficients = [&](std::size_t at) {
        return Coefficients{x[19 + at], x[20 + at], x[21 + at]};
      };
      G = {coefficients(3), coefficients(0)};
      K = {coefficients(9), coefficients(6)};
      theta1 = inverse(Wide(2) * G);
      theta2 = Wide(3) * inverse(Wide(6) * K + Wide(2) * G);
      return;
    }
    if (model_of(x) == thesis) {
      const Wide rate = 1 / Wide(x[8]), at_once = 3 / (6 * Wide(x[5]) + 2 * Wide(x[2]));
      theta1 = (1 / (2 * Wide(x[2]))) * Ratio{{2 * rate, 1}, {rate, 1}};
      theta2 = at_once * Ratio{{3 * rate, 1}, {2 * rate, 1}};
    } else {
      theta1 = series(x.subspan(9));
      theta2 = series(x.subspan(14));
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

/// Beside impulses: the solution of the differential equation whose characteristic polynomial is the denominator, by
/// the exponential's series at t/2^k, squared k times. In the unit of time that the fastest of it sets.
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
  // f and its derivatives at 0: the expansion of the ratio in 1/p; what is of p^0 and more is an impulse.
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

WideComplex swung(const Coefficients& c, double omega) {
  WideComplex sum(0);
  for (std::size_t k = c.size(); k-- > 0;) sum = sum * WideComplex(Wide(0), Wide(omega)) + WideComplex(c[k]);
  return sum;
}

/// What a quantity is of those ratios; at: 2 for G, 5 for K.
Wide relaxation_of_ratio(Arguments x, std::size_t at) {
  const Responses all(x);
  const Ratio& modulus = at == 2 ? all.G : all.K;
  return in_time({modulus.above, times({0, 1}, modulus.below)}, x[0]);
}
Wide creep_of_ratio(Arguments x, std::size_t at) {
  const Responses all(x);
  const Ratio& modulus = at == 2 ? all.G : all.K;
  return in_time({modulus.below, times({0, 1}, modulus.above)}, x[0]);
}
WideComplex modulus_of_ratio(Arguments x, std::size_t at) {
  const Responses all(x);
  const Ratio& modulus = at == 2 ? all.G : all.K;
  return swung(modulus.above, x[0]) / swung(modulus.below, x[0]);
}
Wide storage_of_ratio(Arguments x, std::size_t at) { return modulus_of_ratio(x, at).real(); }
Wide loss_of_ratio(Arguments x, std::size_t at) { return modulus_of_ratio(x, at).imag(); }
Wide theta1_of_ratio(Arguments x) { return in_time(Responses(x).theta1, x[0]); }
Wide theta2_of_ratio(Arguments x) { return in_time(Responses(x).theta2, x[0]); }

using Value = Wide (*)(Arguments);

Confirm by_states(Value springs, Value ratio) {
  return [=](Arguments x) {
    const bool is_of_springs = model_of(x) <= elastic;
    const Wide found = (is_of_springs ? springs : ratio)(x);
    return confirmation<Wide>(is_of_springs ? "equations of springs and dashpots by their series"
                                            : "the differential equation by its series",
                              found, abs(found) * Wide(is_of_springs ? "1e-200" : "1e-100"));
  };
}

template <std::size_t at, Wide (*value)(Arguments, std::size_t)>
Wide of(Arguments x) {
  return value(x, at);
}
Wide real_part(Arguments x, std::size_t at) { return modulus(x, at).real(); }
Wide imaginary_part(Arguments x, std::size_t at) { return modulus(x, at).imag(); }

}  // namespace

Confirm of_material(std::string_view quantity) {
  static const Methods methods{
      {"material.theta1", by_states(theta1, theta1_of_ratio)},
      {"material.theta2", by_states(theta2, theta2_of_ratio)},
      {"material.G", by_states(of<2, relaxation>, of<2, relaxation_of_ratio>)},
      {"material.K", by_states(of<5, relaxation>, of<5, relaxation_of_ratio>)},
      {"material.creep_shear", by_states(of<2, creep>, of<2, creep_of_ratio>)},
      {"material.creep_bulk", by_states(of<5, creep>, of<5, creep_of_ratio>)},
      {"material.storage_shear", by_states(of<2, real_part>, of<2, storage_of_ratio>)},
      {"material.storage_bulk", by_states(of<5, real_part>, of<5, storage_of_ratio>)},
      {"material.loss_shear", by_states(of<2, imaginary_part>, of<2, loss_of_ratio>)},
      {"material.loss_bulk", by_states(of<5, imaginary_part>, of<5, loss_of_ratio>)}};
  return found_in(methods, quantity);
}

}  // namespace nipref::verify::confirm
