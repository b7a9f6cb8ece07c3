#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/contact.hpp>
#include <nipref/ref/number/internal/float.hpp>

namespace nipref::ref {
namespace {

constexpr int most_digits = 100;
/// For the roundings of thousands of terms, and the small factors of what is computed from the integrals.
constexpr int guard_digits = 12;

struct Answer {
  Float compliance, coupling, coupling_across, in_line;
};

/// The surface at working digits.
class Surface {
 public:
  Surface(const SurfaceAnswer& answer, int digits) : answer_(answer), digits_(digits) {}

  [[nodiscard]] Answer at(const Exact& degrees) const {
    const LineAnswer line = answer_(degrees, digits_);
    return {to_float(line.compliance), to_float(line.coupling), to_float(line.coupling_across),
            to_float(line.in_line)};
  }

 private:
  const SurfaceAnswer& answer_;
  int digits_;
};

/// cos of an angle in degrees, exactly 0 across.
Float cosine(const Exact& degrees) {
  mpq_class from_90 = 90 - abs(degrees.value());
  return sin(to_float(Exact(from_90)) * pi() / 180);
}

Float sine(const Exact& degrees) { return sin(to_float(degrees) * pi() / 180); }

Float tolerance(int digits) { return pow(Float(10), -digits); }

Enclosure result(const Float& value, Float error, int digits) {
  // Two results may agree to the last bit: then rounding and the surface's own digits are what is left.
  error += tolerance(digits + guard_digits / 2) * std::min(Float(1), Float(abs(value)));
  if (!(error <= tolerance(digits) * std::min(Float(1), Float(abs(value)))))
    throw std::runtime_error("the reference's quadrature did not converge");
  return {to_real(value), to_real(error), digits};
}

/// Without quadrature: what the surface's own digits and rounding leave.
Enclosure closed(const Float& value, int digits) { return result(value, 0, digits); }

template <class Compute>
Enclosure with_digits(int digits, Compute compute) {
  if (digits < 16 || digits > most_digits)
    throw data::BadInput("digits", digits, "must be from 16 to " + std::to_string(most_digits));
  const WorkingDigits working(digits + guard_digits);
  return compute(digits + guard_digits);
}

/// One line of a sliding contact.
struct SlidingLine {
  Float omega;
  Float h;  ///< sqrt(K^2 + (friction (cos(psi) S - sin(psi) S'))^2)

  SlidingLine(const Surface& surface, const Exact& friction, const Exact& degrees) {
    const Answer answer = surface.at(degrees);
    const Float shear =
        to_float(friction) * (cosine(degrees) * answer.coupling - sine(degrees) * answer.coupling_across);
    omega = atan(shear / answer.compliance) / pi() - Float(0.5);
    h = sqrt(answer.compliance * answer.compliance + shear * shear);
  }
  /// Q = (1 + Omega)^(1 + Omega) (-Omega)^(-Omega): peak of the pressure over span/h and curvature.
  [[nodiscard]] Float Q() const { return pow(1 + omega, 1 + omega) * pow(-omega, -omega); }
};

/// int_0^1 f(x, 1 - x) dx for f with algebraic ends.
Float unit_integral(int digits, const std::function<Float(const Float& left, const Float& right)>& f) {
  const Float step = Float(1) / (digits + 20) * 2;
  // Where the weights have fallen to 10^-digits times any algebraic growth of the ends.
  const int last =
      static_cast<int>((std::asinh(2.3026 * (digits + 10) / 3.14159) + 0.5) / static_cast<double>(step));
  Float sum = 0;
  for (int i = -last; i <= last; ++i) {
    const Float s = i * step;
    const Float growth = exp(pi() * sinh(s));
    const Float right = 1 / (1 + growth), left = growth / (1 + growth);
    sum += f(left, right) * step * pi() * cosh(s) * left * right;
  }
  return sum;
}

/// int |x| (x+ - x)^(1 + Omega) (x - x-)^(-Omega) dx for span 1, cut at the kink x = 0.
Float line_moment(const Float& omega, int digits) {
  const Float ahead = -omega, behind = 1 + omega;
  const Float front = unit_integral(digits, [&](const Float& left, const Float& right) {
    const Float x = ahead * left;
    return ahead * x * pow(ahead * right, behind) * pow(x + behind, ahead);
  });
  const Float back = unit_integral(digits, [&](const Float& left, const Float& right) {
    const Float x = behind * left;
    return behind * x * pow(ahead + x, behind) * pow(behind * right, ahead);
  });
  return front + back;
}

Exact direction(long i, long count) { return Exact(mpq_class(180 * i, count) - 90); }

/// Values at directions spread evenly over half a turn, doubled until `converged` says of them that they are
/// enough.
template <class Value>
void doubled(const std::function<Value(const Exact& degrees)>& value,
             const std::function<bool(const std::vector<Value>& values)>& converged) {
  constexpr long most = 4096;
  std::vector<Value> values;
  for (long count = 8; count <= most; count *= 2) {
    std::vector<Value> finer;
    for (long i = 0; i < count; ++i) {
      const bool known = !values.empty() && i % 2 == 0;
      finer.push_back(known ? values[static_cast<std::size_t>(i / 2)] : value(direction(i, count)));
      if (finer.back() != finer.back()) throw std::runtime_error("not a number");
    }
    values = std::move(finer);
    if (converged(values)) return;
  }
  throw std::runtime_error("the reference's quadrature did not converge");
}

/// Of w^2 = 1 + e cos 2 psi + f sin 2 psi.
struct Ellipse {
  Float e = 0, f = 0;
};

/// cos and sin of twice the angles of evenly spread directions.
struct DoubledAngles {
  std::vector<Float> c, s;

  explicit DoubledAngles(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const Float angle = 2 * pi() * static_cast<long>(i) / static_cast<long>(count) - pi();
      c.push_back(cos(angle));
      s.push_back(sin(angle));
    }
  }
};

/// (C1 - C2)/(C1 + C2) of the curvatures along and across the motion.
Float eccentricity(const Exact& curvature_ratio) {
  if (curvature_ratio.sign() <= 0)
    throw data::BadInput("curvature_ratio", curvature_ratio.approximate(), "must be positive");
  return to_float(Exact(mpq_class((1 - curvature_ratio.value()) / (1 + curvature_ratio.value()))));
}

/// int K n n/w^3 dpsi is proportional to the curvatures where int K (cos 2 psi - eccentricity)/w^3 dpsi and
/// int K sin 2 psi/w^3 dpsi vanish: Newton's method on the trapezoidal sums; nothing if it does not converge.
std::optional<Ellipse> solve_ellipse(const std::vector<Float>& compliance, const Float& eccentricity) {
  const auto count = compliance.size();
  Ellipse ellipse;
  const auto [c, s] = DoubledAngles(count);
  for (int step = 0; step < 60; ++step) {
    Float r1 = 0, r2 = 0, j11 = 0, j12 = 0, j21 = 0, j22 = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Float square = 1 + ellipse.e * c[i] + ellipse.f * s[i];
      const Float term = compliance[i] / (square * sqrt(square));
      const Float slope = Float(-1.5) * term / square;
      const Float off = c[i] - eccentricity;
      r1 += term * off;
      r2 += term * s[i];
      j11 += slope * off * c[i];
      j12 += slope * off * s[i];
      j21 += slope * s[i] * c[i];
      j22 += slope * s[i] * s[i];
    }
    const Float determinant = j11 * j22 - j12 * j21;
    Float de = -(r1 * j22 - r2 * j12) / determinant, df = -(r2 * j11 - r1 * j21) / determinant;
    const auto beyond = [&] { return hypot(ellipse.e + de, ellipse.f + df) >= 1; };
    while (beyond()) {
      de /= 2;
      df /= 2;
    }
    ellipse.e += de;
    ellipse.f += df;
    if (hypot(de, df) < sqrt(std::numeric_limits<Float>::epsilon()) * Float(1e-3)) return ellipse;
  }
  return std::nullopt;
}

Float axis_ratio(const Ellipse& ellipse) {
  const Float r = hypot(ellipse.e, ellipse.f);
  return sqrt((1 - r) / (1 + r));
}

Float stiffness(const Ellipse& ellipse, const std::vector<Float>& compliance) {
  const auto [c, s] = DoubledAngles(compliance.size());
  Float first = 0, third = 0;
  for (std::size_t i = 0; i < compliance.size(); ++i) {
    const Float square = 1 + ellipse.e * c[i] + ellipse.f * s[i];
    const Float term = compliance[i] / sqrt(square);
    first += term;
    third += term / square;
  }
  const Float step = pi() / static_cast<long>(compliance.size());
  return 8 * pi() / 3 * sqrt(third * step) / pow(first * step, Float(1.5));
}

/// `value` of the ellipse and K at evenly spread directions, doubled until it changes no more.
template <class Value>
Enclosure of_ellipse(const SurfaceAnswer& surface, const Exact& curvature_ratio, int digits, Value value) {
  return with_digits(digits, [&](int working) {
    const Surface lines(surface, working);
    const Float off_centre = eccentricity(curvature_ratio);
    std::optional<Float> last;
    Float change = 1;
    doubled<Float>([&](const Exact& degrees) -> Float { return lines.at(degrees).compliance; },
                   [&](const std::vector<Float>& compliance) {
                     const std::optional<Ellipse> ellipse = solve_ellipse(compliance, off_centre);
                     if (!ellipse) return false;
                     const Float finer = value(*ellipse, compliance);
                     if (last) change = abs(finer - *last);
                     last = finer;
                     return change <= tolerance(digits) * std::min(Float(1), finer) / 10;
                   });
    return result(*last, change, digits);
  });
}

}  // namespace

Enclosure sliding_exponent(const SurfaceAnswer& surface, const Exact& friction, const Exact& degrees,
                           int digits) {
  return with_digits(digits, [&](int working) {
    return closed(SlidingLine(Surface(surface, working), friction, degrees).omega, digits);
  });
}

Enclosure sliding_span_ratio(const SurfaceAnswer& surface, const Exact& friction, const Exact& degrees,
                             int digits) {
  return with_digits(digits, [&](int working) {
    const Surface lines(surface, working);
    const SlidingLine along(lines, friction, Exact(0.0)), line(lines, friction, degrees);
    return closed(along.Q() / line.Q() * line.h / along.h, digits);
  });
}

Enclosure sliding_force(const SurfaceAnswer& surface, const Exact& friction, int digits) {
  return with_digits(digits, [&](int working) {
    const Surface lines(surface, working);
    const SlidingLine along(lines, friction, Exact(0.0));
    const Float steepness = along.Q() / along.h;
    // On a line of span L the pressure is (C/h) L times that of span 1, and L = steepness h/Q.
    const auto of_line = [&](const Exact& degrees) -> Float {
      const SlidingLine line(lines, friction, degrees);
      const Float span = steepness * line.h / line.Q();
      return pow(span, 3) / line.h * line_moment(line.omega, working);
    };
    Float sum = 0, change = 1;
    doubled<Float>(of_line, [&](const std::vector<Float>& values) {
      Float total = 0;
      for (const Float& value : values) total += value;
      total *= pi() / static_cast<long>(values.size());
      change = abs(total - sum);
      sum = total;
      return change <= tolerance(digits) * sum / 10;
    });
    return result(sum, change, digits);
  });
}

Enclosure rolling_index(const SurfaceAnswer& surface, const Exact& degrees, int digits) {
  return with_digits(digits, [&](int working) {
    const Answer line = Surface(surface, working).at(degrees);
    const Float q = line.coupling / sqrt(line.compliance * line.in_line);
    return closed(atanh(q) / pi(), digits);
  });
}

Enclosure rolling_span_ratio(const SurfaceAnswer& surface, const Exact& degrees, int digits) {
  return with_digits(digits, [&](int working) {
    const Surface lines(surface, working);
    const auto squared_amplitude = [&](const Exact& at) -> Float {
      const Answer line = lines.at(at);
      return line.in_line / line.compliance /
             (line.compliance * line.in_line - line.coupling * line.coupling);
    };
    return closed(sqrt(squared_amplitude(Exact(0.0)) / squared_amplitude(degrees)), digits);
  });
}

Enclosure elliptic_axis_ratio(const SurfaceAnswer& surface, const Exact& curvature_ratio, int digits) {
  return of_ellipse(surface, curvature_ratio, digits,
                    [](const Ellipse& ellipse, const std::vector<Float>&) { return axis_ratio(ellipse); });
}

Enclosure elliptic_stiffness(const SurfaceAnswer& surface, const Exact& curvature_ratio, int digits) {
  return of_ellipse(surface, curvature_ratio, digits, stiffness);
}

}  // namespace nipref::ref
