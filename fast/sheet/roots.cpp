#include <cmath>
#include <numbers>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/sheet/roots.hpp>

namespace nipref::fast {
namespace {

using Complex = std::complex<double>;

/// The equation, solved for its large exponential with an explicit branch of the logarithm, is z = map(z) + i n pi with
/// map(z) = ln(-4z + e^(-2z))/2. It has exactly one root for each n, so that an iteration cannot end in another.
struct MapAndSlope {
  Complex value;
  Complex slope;
};

MapAndSlope map(Complex z) {
  const Complex small = std::exp(-2.0 * z);
  const Complex inside = -4.0 * z + small;
  return {0.5 * std::log(inside), (-2.0 - small) / inside};
}

}  // namespace

std::complex<double> sheet_root(int n) {
  constexpr int largest = 1000000;
  if (n < 1 || n > largest) throw data::BadInput("n", n, "must satisfy 1 <= n <= 1000000");
  constexpr double pi_low = 0x1.1a62633145c07p-53;
  const double height = std::numbers::pi * n;
  // The error of the guess is at most ln(n)/(pi n) and the derivative of the map 1/(2z): after four Newton steps the
  // error is 1e-30.
  constexpr int steps = 4;
  Complex z(0.5 * std::log(4 * (height - std::numbers::pi / 4)), height - std::numbers::pi / 4);
  for (int step = 0; step < steps; ++step) {
    const MapAndSlope at = map(z);
    z += (at.value + Complex(0, height) - z) / (1.0 - at.slope);
  }
  // The last step is a fixed-point iteration: the difference in Newton's step has a rounding error of the size of z's,
  // while the map contracts the remaining error.
  const Complex value = map(z).value;
  return {value.real(), std::fma(n, std::numbers::pi, n * pi_low + value.imag())};
}

}  // namespace nipref::fast
