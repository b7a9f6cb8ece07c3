#include <array>
#include <map>
#include <string>

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

enum Model { standard_linear, kelvin_voigt, maxwell, elastic };

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

Confirm by_states(Wide (*value)(Arguments)) {
  return [value](Arguments x) {
    const Wide found = value(x);
    return witness<Wide>("equations of springs and dashpots by their series", found, found * Wide("1e-200"));
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
  static const Methods methods{{"material.theta1", by_states(theta1)},
                               {"material.theta2", by_states(theta2)},
                               {"material.G", by_states(of<2, relaxation>)},
                               {"material.K", by_states(of<5, relaxation>)},
                               {"material.creep_shear", by_states(of<2, creep>)},
                               {"material.creep_bulk", by_states(of<5, creep>)},
                               {"material.storage_shear", by_states(of<2, real_part>)},
                               {"material.storage_bulk", by_states(of<5, real_part>)},
                               {"material.loss_shear", by_states(of<2, imaginary_part>)},
                               {"material.loss_bulk", by_states(of<5, imaginary_part>)}};
  return found_in(methods, quantity);
}

}  // namespace nipref::verify::confirm
