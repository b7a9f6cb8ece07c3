#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <nipref/verify/catalogue/sheet/internal/envelopes.hpp>

namespace nipref::verify {
namespace {

using Complex = std::complex<double>;

/// First root of sinh 2z + 2z = 0 in the first quadrant.
const Complex first_root{1.1253643058009303, 2.1061961152453303};

double decaying(Complex coefficient, double argument) {
  return 2 * std::numbers::pi * std::abs(coefficient) * std::exp(-first_root.imag() * std::fabs(argument));
}

double bounded(double slope, double largest, double argument) {
  return std::min(slope * std::fabs(argument), largest);
}

}  // namespace

double envelope_I1(double alpha) {
  const Complex tangent = std::tanh(first_root);
  return decaying(tangent * tangent / (2.0 * first_root), alpha);
}

double envelope_I7(double eta) {
  const Complex cosine = std::cosh(first_root);
  return decaying(std::sinh(first_root) / (2.0 * cosine * cosine), eta);
}

double envelope_r(double alpha) { return decaying(1.0 / (2.0 * first_root), alpha); }

double envelope_s(double eta) { return decaying(1.0 / (2.0 * first_root * std::cosh(first_root)), eta); }

// The slopes are the integrals of x times the kernel's transform, which bound the kernel because |sin(x a)|
// <= x |a|.
double magnitude_I3(double alpha) { return bounded(0.76858, 0.787, alpha); }
double magnitude_I4(double eta) { return bounded(1.05372, 0.791, eta); }
double magnitude_I5(double eta) { return bounded(1.83496, 0.905, eta); }

}  // namespace nipref::verify
