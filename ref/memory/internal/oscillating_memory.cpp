#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <nipref/ref/memory/internal/contour_nodes.hpp>
#include <nipref/ref/memory/internal/oscillating_memory.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>

namespace nipref::ref {
namespace {

constexpr double narrow_strip = 3.0 / 16;
constexpr double low_angle = 0.25, high_angle = 0.75;
/// The t at which Re z = 2 on the higher path, rounded up.
constexpr double beyond_two = 1.75;

/// A lower bound of q(t).
double nats_of_integrand(Symbol kernel, double distance, double angle, double t) {
  const bool odd = bounds(kernel).parity == Parity::odd;
  const double symbol = odd ? bounds(kernel).decay * std::cos(angle) * std::sinh(t) : t;
  return symbol + distance * std::sin(angle) * std::cosh(t);
}

long last_node(Symbol kernel, double distance, double angle, double step, double nats) {
  // q(t) >= t for I1, and at least about sinh t for the other kernels.
  long last = static_cast<long>(1.4 * (nats + 10) / step) + 1;
  for (long below = static_cast<long>(beyond_two / step) + 1; last - below > 1;) {
    const long middle = below + (last - below) / 2;
    const double q = nats_of_integrand(kernel, distance, angle, static_cast<double>(middle) * step);
    (q >= nats + 9 ? last : below) = middle;
  }
  return last;
}

/// The complex interval around `number` with the relative half-width 2^-bits.
ComplexInterval enclosed(const Complex& number, mpfr_prec_t bits) {
  const mpfr_srcptr real = mpc_realref(number.get()), imag = mpc_imagref(number.get());
  ComplexInterval result{Interval(bits), Interval(bits)};
  mpfi_set_fr(result.real.get(), real);
  mpfi_set_fr(result.imag.get(), imag);
  Interval radius = sqrt(square(result.real) + square(result.imag));
  mpfi_div_2ui(radius.get(), radius.get(), static_cast<unsigned long>(bits));
  return {result.real.widened(radius), result.imag.widened(radius)};
}

ComplexInterval times_i(const ComplexInterval& z) { return {-z.imag, z.real}; }
ComplexInterval over_i(const ComplexInterval& z) { return {z.imag, -z.real}; }

/// U(A, m)
ComplexInterval along_path(Symbol kernel, const Exact& distance, const ComplexInterval& m, Contour path,
                           double nats) {
  const double step = contour_step(2 * std::numbers::pi * narrow_strip / (nats + 10));
  const double angle = path == Contour::low ? low_angle : high_angle;
  const long last = last_node(kernel, distance.approximate(), angle, step, nats);
  const mpfr_prec_t bits = std::max(working_precision(nats + 12, distance.approximate()), m.real.precision());
  const Interval A(distance, bits), half(0.5, bits);
  const ComplexInterval conjugate_m = conj(m);
  const bool odd = bounds(kernel).parity == Parity::odd;
  ComplexInterval sum{Interval(bits), Interval(bits)};
  ContourKey key{kernel, path, step, bits, 0};
  for (; key.block * nodes_in_block <= last; ++key.block) {
    const auto nodes = contour_nodes(key);
    const long first = key.block * nodes_in_block;
    for (long k = 0; k < std::min(nodes_in_block, last + 1 - first); ++k) {
      const ContourNode& node = (*nodes)[static_cast<std::size_t>(k)];
      const ComplexInterval z = enclosed(node.z, bits), turn = times_i(z);
      const ComplexInterval wave = enclosed(node.weight, bits) * exp(A * turn);
      const ComplexInterval right = wave * inverse(m - turn);
      // The node at -t, whose weighted wave is the conjugate, for odd kernels with the opposite sign.
      const ComplexInterval left = conj(wave * inverse(conjugate_m - turn));
      if (first + k == 0) {
        sum = sum + right;
      } else {
        sum = sum + right + (odd ? -left : left);
      }
    }
  }
  const ComplexInterval integral = Interval(step, bits) * half * sum;
  const Interval left_out = exp(Interval(-nats, 64));
  const ComplexInterval enclosure{integral.real.widened(left_out), integral.imag.widened(left_out)};
  return odd ? over_i(enclosure) : enclosure;
}

/// P/e^{-L A}, with S(i r) = i (sin 2r + 2r).
ComplexInterval whole_line_from_load(Symbol kernel, const ComplexInterval& rate) {
  const ComplexInterval sine = sin(rate), cosine = cos(rate);
  const ComplexInterval size = Interval::pi(rate.real.precision()) * inverse(sine * cosine + rate);
  switch (kernel) {
    case Symbol::I3:
      return size;
    case Symbol::I4:
      return size * sine * inverse(rate);
    case Symbol::I5:
      return size * cosine;
    default:
      return size * sine * sine * inverse(rate);
  }
}

/// The same for so large an Im L > 0 that sine and cosine overflow, by r = e^{i L}: sin L = (r - 1/r)/(2i) and
/// cos L = (r + 1/r)/2, with numerator and denominator multiplied by r or r^2.
ComplexInterval whole_line_of_fast_oscillation(Symbol kernel, const ComplexInterval& rate) {
  const mpfr_prec_t bits = rate.real.precision();
  const ComplexInterval one{Interval(1L, bits), Interval(bits)}, r = exp(times_i(rate)), square = r * r;
  const Interval half(0.5, bits);
  const ComplexInterval sine = half * over_i(square - one), cosine = half * (square + one);
  const ComplexInterval size = Interval::pi(bits) * inverse(sine * cosine + rate * square);
  switch (kernel) {
    case Symbol::I3:
      return size * square;
    case Symbol::I4:
      return size * sine * r * inverse(rate);
    case Symbol::I5:
      return size * cosine * r;
    default:
      return size * sine * sine * inverse(rate);
  }
}

/// P
ComplexInterval whole_line(Symbol kernel, const ComplexInterval& rate, const Exact& distance) {
  constexpr double fast_oscillation = 64;
  const ComplexInterval faded = exp(-(Interval(distance, rate.real.precision()) * rate));
  const double frequency = mpfr_get_d(rate.imag.lower(), MPFR_RNDN);
  if (frequency > fast_oscillation) return whole_line_of_fast_oscillation(kernel, rate) * faded;
  // For a real rate the result is real.
  if (frequency < -fast_oscillation) return conj(whole_line_of_fast_oscillation(kernel, conj(rate))) * faded;
  return whole_line_from_load(kernel, rate) * faded;
}

/// psi of the pole at i rate, reflected to Re z >= 0.
double angle_of_pole(const ComplexInterval& rate) {
  const std::complex<double> pole(std::fabs(mpfr_get_d(rate.imag.lower(), MPFR_RNDN)),
                                  mpfr_get_d(rate.real.lower(), MPFR_RNDN));
  return std::asinh(pole).imag();
}

}  // namespace

ComplexInterval oscillating_memory(Symbol kernel, const Exact& alpha, const ComplexInterval& rate,
                                   double nats) {
  const bool odd = bounds(kernel).parity == Parity::odd;
  const Exact distance = alpha.magnitude();
  const Interval quarter = Interval::pi(rate.real.precision()) / 4;
  const ComplexInterval at_origin = quarter * inverse(rate);
  if (alpha.sign() >= 0) {
    const ComplexInterval integral = along_path(kernel, distance, rate, Contour::high, nats);
    return odd ? integral + at_origin : integral;
  }
  const bool above = angle_of_pole(rate) >= 0.5;
  const ComplexInterval passed =
      along_path(kernel, distance, -rate, above ? Contour::low : Contour::high, nats);
  const ComplexInterval known = odd ? passed - at_origin : -passed;
  return above ? known : known + whole_line(kernel, rate, distance);
}

}  // namespace nipref::ref
