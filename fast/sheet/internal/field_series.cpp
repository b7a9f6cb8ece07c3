#include <cmath>
#include <complex>
#include <numbers>

#include <nipref/fast/sheet/internal/field_series.hpp>

namespace nipref::fast::internal {
namespace {

using Complex = std::complex<double>;

constexpr double quarter_pi = std::numbers::pi / 4;

struct Rests {
  Complex I5, I7;
};

/// The rests at w, for 0 <= Im w up to the radius of the circle below.
Rests rests_at(Complex w) {
  const Complex v(std::fabs(w.real()), w.imag());
  Rests rests;
  if (v.real() < near_load_end) {
    const FieldFunctions f = near_rest(v.real(), v.imag(), FieldFunction::I5);
    rests = {{f[FieldFunction::I5].re, f[FieldFunction::I5].im},
             {f[FieldFunction::I7].re, f[FieldFunction::I7].im}};
  } else {
    const FieldFunctions f = decaying(v.real(), v.imag());
    const Complex planes = 2.0 / (1.0 + v * v);
    rests = {Complex(f[FieldFunction::I5].re + quarter_pi, f[FieldFunction::I5].im) - v * planes,
             Complex(f[FieldFunction::I7].re, f[FieldFunction::I7].im) - planes};
  }
  // I5 is odd, I7 even.
  if (w.real() < 0) return {-std::conj(rests.I5), std::conj(rests.I7)};
  return rests;
}

/// Points on a circle around c, whose radius is chosen so that near_rest or the residues hold at each of them.
constexpr std::size_t points = 64;
constexpr double circle = 1.4;

const std::array<Complex, points>& turns() {
  static const std::array<Complex, points> table = [] {
    std::array<Complex, points> result;
    for (std::size_t j = 0; j < points; ++j)
      result[j] = std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(j) / points);
    return result;
  }();
  return table;
}

/// f and f' at v.
struct ValueAndSlope {
  Complex value, slope;
};
ValueAndSlope horner(const FieldSeries::Coefficients& coefficients, Complex v) {
  double re = 0, im = 0, slope_re = 0, slope_im = 0;
  const double x = v.real(), y = v.imag();
  for (std::size_t k = coefficients.size(); k-- > 0;) {
    const double next_slope = slope_re * x - slope_im * y + re;
    slope_im = slope_re * y + slope_im * x + im;
    slope_re = next_slope;
    const double next = re * x - im * y + coefficients[k];
    im = re * y + im * x;
    re = next;
  }
  return {{re, im}, {slope_re, slope_im}};
}

/// Adds Re(a e^{i z t}) as a series in t, for each root.
void add_waves(const AlongWaves& loads, double side, FieldSeries& series) {
  for (std::size_t n = 0; n < static_cast<std::size_t>(loads.count); ++n) {
    const Complex z(field_table.root[n][0][0], field_table.root[n][1][0]);
    const auto amplitude = [&](FieldFunction f) {
      const auto& a = field_table.amplitude[n][static_cast<std::size_t>(f)];
      return Complex(a[0], a[1]) * loads.of[n];
    };
    // Seen from the other side t is -t, and I5 changes its sign.
    const Complex step = side * Complex(-z.imag(), z.real());
    Complex of_I5 = side * amplitude(FieldFunction::I5), of_I7 = amplitude(FieldFunction::I7);
    for (std::size_t k = 0; k < FieldSeries::count; ++k) {
      series.I5[k] += of_I5.real();
      series.I7[k] += of_I7.real();
      of_I5 *= step / static_cast<double>(k + 1);
      of_I7 *= step / static_cast<double>(k + 1);
    }
  }
}

}  // namespace

void FieldSeries::add(double factor, const FieldSeries& other) {
  for (std::size_t k = 0; k < count; ++k) {
    I5[k] += factor * other.I5[k];
    I7[k] += factor * other.I7[k];
  }
}

/// The Taylor coefficients by Cauchy's integral and the trapezoidal rule. f is real on the axis, so that half of the
/// circle suffices.
FieldSeries rest_series(double c) {
  constexpr std::size_t half = points / 2;
  std::array<Rests, half + 1> values;
  for (std::size_t j = 0; j <= half; ++j) {
    const Complex turn = j == half ? Complex(-1) : turns()[j];
    values[j] = rests_at({c + circle * turn.real(), circle * turn.imag()});
  }
  FieldSeries series;
  double weight = 2.0 / points;
  for (std::size_t k = 0; k < FieldSeries::count; ++k, weight /= circle) {
    const double sign = k % 2 == 0 ? 0.5 : -0.5;
    double of_I5 = values[0].I5.real() / 2 + sign * values[half].I5.real();
    double of_I7 = values[0].I7.real() / 2 + sign * values[half].I7.real();
    for (std::size_t j = 1; j < half; ++j) {
      const Complex turn = turns()[j * k % points];
      of_I5 += values[j].I5.real() * turn.real() + values[j].I5.imag() * turn.imag();
      of_I7 += values[j].I7.real() * turn.real() + values[j].I7.imag() * turn.imag();
    }
    series.I5[k] = weight * of_I5;
    series.I7[k] = weight * of_I7;
  }
  return series;
}

void StressSeries::add_far(const FarLoads& loads, double side) {
  add_waves(loads.pressure, side, pressure);
  add_waves(loads.shear, side, shear);
  shear.I5[0] += side * quarter_pi * loads.shear_force;
}

// The formulas are those of sheet/field.cpp.
SheetStresses StressSeries::at(double along, double depth) const {
  const double s = std::fabs(depth);
  const Complex v(along, s);
  const auto [p5, p5_slope] = horner(pressure.I5, v);
  const auto [p7, p7_slope] = horner(pressure.I7, v);
  const auto [q5, q5_slope] = horner(shear.I5, v);
  const auto [q7, q7_slope] = horner(shear.I7, v);
  const double tau =
      s * p7_slope.real() - p5_slope.imag() + q7_slope.imag() + q5.imag() + s * q5_slope.real();
  return {std::numbers::inv_pi *
              (-p7.real() - p5_slope.real() - s * p7_slope.imag() + q7_slope.real() - s * q5_slope.imag()),
          std::numbers::inv_pi * (p5_slope.real() - p7.real() + s * p7_slope.imag() - q7_slope.real() -
                                  2 * q5.real() + s * q5_slope.imag()),
          std::numbers::inv_pi * std::copysign(1.0, depth) * tau};
}

}  // namespace nipref::fast::internal
