#include <algorithm>
#include <cmath>

#include <nipref/fast/half_space/internal/pressure_potential.hpp>

namespace nipref::fast::internal {
namespace {

using Complex = std::complex<double>;

/// L(z) for any z. At z = +-1, where L is infinite, the result is L at a distance of one rounding.
Complex logarithm(Complex z) {
  const double x = std::fabs(z.real()), y = z.imag();
  const double squared_distance = std::max((x - 1) * (x - 1) + y * y, 0x1p-106);
  return {-std::copysign(std::log1p(4 * x / squared_distance) / 2, z.real()),
          std::atan2(2 * y, (x - 1) * (x + 1) + y * y)};
}

/// ln(1 + z)/z.
Complex slope_of_log1p(Complex z) {
  if (z == 0.0) return 1;
  return Complex(std::log1p(2 * z.real() + std::norm(z)) / 2, std::atan2(z.imag(), 1 + z.real())) / z;
}

/// Uses series in 1/z: the divided difference of z^-(n + 1) is that of z^-1 times the sum of all products of n factors 1/z.
std::array<PressurePotential, 3> far_potentials(const std::array<Complex, 3>& z) {
  const std::array<Complex, 3> x{1.0 / z[0], 1.0 / z[1], 1.0 / z[2]};
  std::array<Complex, 3> products{1, 1, 1};
  std::array<PressurePotential, 3> sums{};
  const double largest = std::max({std::abs(x[0]), std::abs(x[1]), std::abs(x[2])});
  // There are (n + 1)(n + 2)/2 such products at most.
  double power = 1;
  for (int n = 0; (n + 1) * (n + 2) * power > 0x1p-56; n += 2, power *= largest * largest) {
    for (std::size_t j = 0; j < 3; ++j) {
      sums[j].parabola += 4.0 / ((n + 1) * (n + 3)) * products[j];
      sums[j].logarithm += 2.0 / (n + 1) * products[j];
    }
    for (int twice = 0; twice < 2; ++twice) {
      products[0] *= x[0];
      products[1] = x[1] * products[1] + products[0];
      products[2] = x[2] * products[2] + products[1];
    }
  }
  Complex factor = -1;
  for (std::size_t j = 0; j < 3; ++j) {
    factor *= j == 0 ? x[j] : -x[j];
    sums[j].parabola *= factor;
    sums[j].logarithm *= factor;
  }
  return sums;
}

bool is_far(Complex z) { return std::abs(z) > 2; }

PressurePotential at(Complex z) {
  if (is_far(z)) return far_potentials({z, z, z})[0];
  const Complex log = logarithm(z);
  return {(1.0 - z) * (1.0 + z) * log - 2.0 * z, log};
}

PressurePotential quotient(const PressurePotential& a, const PressurePotential& b, Complex distance) {
  return {(a.parabola - b.parabola) / distance, (a.logarithm - b.logarithm) / distance};
}

PressurePotential on_pair(Complex a, Complex b) {
  if (is_far(a) && is_far(b)) return far_potentials({a, b, b})[1];
  // If a and b are far apart, nothing cancels in the quotient, while large terms would cancel in the formula below.
  if (std::abs(a - b) > 0.5) return quotient(at(a), at(b), a - b);
  const Complex factor = 2.0 / ((a + 1.0) * (b - 1.0)), log = factor * slope_of_log1p(factor * (a - b));
  return {(1.0 - a) * (1.0 + a) * log - (a + b) * logarithm(b) - 2.0, log};
}

PressurePotential on_three(const std::array<Complex, 3>& z) {
  if (z[0] != z[2]) return quotient(on_pair(z[0], z[1]), on_pair(z[1], z[2]), z[0] - z[2]);
  const Complex square = (z[0] - 1.0) * (z[0] + 1.0), half_slope = -2.0 * z[0] / square;
  return {half_slope - logarithm(z[0]), half_slope / square};
}

}  // namespace

std::array<PressurePotential, 3> pressure_potentials(const std::array<Complex, 3>& z, std::size_t count) {
  if (count == 1) return {at(z[0]), {}, {}};
  if (std::ranges::all_of(z, is_far)) return far_potentials(z);
  return {at(z[0]), on_pair(z[0], z[1]), count == 2 ? PressurePotential{} : on_three(z)};
}

}  // namespace nipref::fast::internal
