#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/ref/memory/internal/contour_nodes.hpp>
#include <nipref/ref/memory/internal/fading.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/sheet/internal/residues.hpp>

namespace nipref::ref {
namespace {

using std::numbers::ln2;
constexpr double half_strip = 7.0 / 16;
constexpr double path_angle = 0.5;
constexpr double path_height = 1.5;  ///< height of Contour::down at t = 0 plus sin(1/2)
constexpr mpfr_prec_t grain_bits = 32;

bool is_odd(Symbol kernel) { return bounds(kernel).parity == Parity::odd; }

/// A lower bound of q(t), see contour_memory(), from cosh t >= e^t/2, sinh t >= (e^t - 1)/2; ln_alpha may be
/// -infinity, and exponentials may overflow.
double nats_below_one(Symbol kernel, double ln_alpha, bool ahead, double t) {
  const double wave = std::sin(path_angle) * std::exp(ln_alpha + t) / 2;
  const double raised = ahead ? 0 : path_height * std::exp(ln_alpha);
  const double symbol =
      is_odd(kernel) ? bounds(kernel).decay * std::cos(path_angle) * (std::exp(t) - 1) / 2 : t;
  return symbol + wave - raised;
}

struct Rule {
  ContourKey key;  ///< key of the first block
  long last;       ///< J
};

Rule make_rule(Symbol kernel, const Exact& alpha, double nats) {
  const bool ahead = alpha.sign() >= 0;
  const double ln_alpha = alpha.log2_magnitude() * ln2;
  const double step = contour_step(2 * std::numbers::pi * half_strip / (nats + 5));
  // The last node is found by bisection. q(t) >= t - 3/2 for I1, and larger for the other kernels.
  long last = static_cast<long>((nats + 6) / step) + 1;
  for (long below = 0; last - below > 1;) {
    const long middle = below + (last - below) / 2;
    const double q = nats_below_one(kernel, ln_alpha, ahead, static_cast<double>(middle) * step);
    (q >= nats + 4 ? last : below) = middle;
  }
  const auto nodes = static_cast<double>(last + 1);
  // The nats that the aliasing allows, so that arguments with the same step share the nodes.
  const double reached = 2 * std::numbers::pi * half_strip / step - 5;
  const double bits =
      (reached + std::log(4 * contour_term * step * nodes * (nodes + contour_rounding))) / ln2;
  const auto precision = static_cast<mpfr_prec_t>(std::ceil(std::max(bits, 64.0) / grain_bits)) * grain_bits;
  return {{kernel, ahead ? Contour::up : Contour::down, step, precision, 0}, last};
}

/// The real or imaginary part, as the kernel needs, of F = G(z) dz/dt e^{i z alpha}/(rate - i z) at the nodes.
/// The error of a term is at most contour_rounding 2^-p (1 + |alpha z|) |F|: ref/memory/README.md.
class Integrand {
 public:
  Integrand(const Exact& alpha, const Exact& rate, bool imaginary, mpfr_prec_t bits)
      : imaginary_(imaginary), alpha_(zero_of_bits(bits)) {
    mpfr_set_q(raw(alpha_), alpha.value().get_mpq_t(), MPFR_RNDN);
    mpfr_set_q(raw(rate_), rate.value().get_mpq_t(), MPFR_RNDN);
  }

  const Float& at(const ContourNode& node) {
    const mpfr_srcptr x = mpc_realref(node.z.get());
    set_wave(x, mpc_imagref(node.z.get()));
    set_weighted_wave(mpc_realref(node.weight.get()), mpc_imagref(node.weight.get()));
    // The denominator is sine_ - i x.
    mpfr_add(raw(sine_), raw(rate_), mpc_imagref(node.z.get()), MPFR_RNDN);
    if (imaginary_) {
      mpfr_fmma(raw(product_), raw(real_), x, raw(imag_), raw(sine_), MPFR_RNDN);
    } else {
      mpfr_fmms(raw(product_), raw(real_), raw(sine_), raw(imag_), x, MPFR_RNDN);
    }
    mpfr_fmma(raw(cosine_), raw(sine_), raw(sine_), x, x, MPFR_RNDN);
    mpfr_mul(raw(product_), raw(product_), raw(size_), MPFR_RNDN);
    mpfr_div(raw(product_), raw(product_), raw(cosine_), MPFR_RNDN);
    return product_;
  }

 private:
  /// e^{i z alpha} = size (cosine + i sine)
  void set_wave(mpfr_srcptr x, mpfr_srcptr y) {
    mpfr_mul(raw(size_), raw(alpha_), y, MPFR_RNDN);
    mpfr_neg(raw(size_), raw(size_), MPFR_RNDN);
    mpfr_exp(raw(size_), raw(size_), MPFR_RNDN);
    mpfr_mul(raw(product_), raw(alpha_), x, MPFR_RNDN);
    mpfr_sin_cos(raw(sine_), raw(cosine_), raw(product_), MPFR_RNDN);
  }

  void set_weighted_wave(mpfr_srcptr real, mpfr_srcptr imag) {
    mpfr_fmms(raw(real_), real, raw(cosine_), imag, raw(sine_), MPFR_RNDN);
    mpfr_fmma(raw(imag_), real, raw(sine_), imag, raw(cosine_), MPFR_RNDN);
  }

  bool imaginary_;
  Float alpha_, rate_ = alpha_;
  Float size_ = alpha_, sine_ = alpha_, cosine_ = alpha_;
  Float real_ = alpha_, imag_ = alpha_;
  Float product_ = alpha_;
};

/// An interval that contains [-e^{-nats}, e^{-nats}] and is little wider.
Interval small(double nats) { return Interval(0L, 64).widened(exp(Interval(-nats, 64))); }

/// The bits that a number of the size 1/rate needs for an error of e^{-nats}.
mpfr_prec_t bits_over_rate(const Exact& rate, double nats) {
  return working_precision(nats + std::max(0.0, -rate.log2_magnitude() * ln2), 1);
}

/// pi/(4 rate)
Interval pole_at_origin(const Exact& rate, double nats) {
  const mpfr_prec_t bits = bits_over_rate(rate, nats);
  return Interval::pi(bits) / (4 * Interval(rate, bits));
}

/// The finite part at rate 0 for an odd kernel, where the infinite pi/(4 rate) is left out: -pi/4 distance.
Interval finite_part_at_rate_0(const Exact& distance, double nats) {
  const mpfr_prec_t bits = working_precision(nats + std::max(0.0, distance.log2_magnitude() * ln2), 1);
  return -(Interval::pi(bits) * Interval(distance, bits) / 4);
}

/// pi G(i rate) e^{-rate distance}, for odd kernels times i. S(i r) = i (sin 2r + 2r).
Interval pole_of_fading(Symbol kernel, const Exact& rate, const Exact& distance, double nats) {
  const Exact faded(mpq_class(rate.value() * distance.value()));
  const double large = std::max(0.0, rate.log2_magnitude() * ln2);
  const mpfr_prec_t bits = bits_over_rate(rate, std::max(nats - faded.approximate(), 1.0) + large);
  const Interval r(rate, bits), sine = sin(r), cosine = cos(r);
  const Interval s = 2 * (sine * cosine + r);
  const Interval size = 2 * Interval::pi(bits) * exp(-Interval(faded, bits)) / s;
  switch (kernel) {
    case Symbol::I3:
      return size;
    case Symbol::I4:
      return size * sine / r;
    case Symbol::I5:
      return size * cosine;
    default:
      return size * square(sine) / r;
  }
}

}  // namespace

Interval contour_memory(Symbol kernel, const Exact& alpha, const Exact& rate, double nats) {
  const Rule rule = make_rule(kernel, alpha, nats);
  ContourKey key = rule.key;
  Integrand integrand(alpha, rate, is_odd(kernel), key.bits);
  Float sum = zero_of_bits(key.bits);
  for (; key.block * nodes_in_block <= rule.last; ++key.block) {
    const auto nodes = contour_nodes(key);
    const long first = key.block * nodes_in_block;
    const long end = std::min(nodes_in_block, rule.last + 1 - first);
    for (long k = 0; k < end; ++k) {
      mpfr_add(raw(sum), raw(sum), raw(integrand.at((*nodes)[static_cast<std::size_t>(k)])), MPFR_RNDN);
      if (first + k == 0) mpfr_div_2ui(raw(sum), raw(sum), 1, MPFR_RNDN);
    }
  }
  mpfr_mul_d(raw(sum), raw(sum), key.step, MPFR_RNDN);
  const Interval integral = Interval(sum, sum, key.bits) + small(nats);
  if (!is_odd(kernel)) return integral;
  return integral + (rate.sign() == 0 ? finite_part_at_rate_0(alpha, nats) : pole_at_origin(rate, nats));
}

Interval steady_memory(Symbol kernel, const Exact& alpha, const Exact& rate, double nats) {
  const Exact distance = alpha.magnitude();
  if (distance.value() < 1) return contour_memory(kernel, alpha, rate, nats);
  const Interval roots = fading_residue_series(kernel, alpha, rate, nats);
  if (rate.sign() == 0) {
    if (is_odd(kernel)) return roots + finite_part_at_rate_0(distance, nats);
    return alpha.sign() > 0 ? roots : roots + Interval::pi(working_precision(nats, 1)) / 2;
  }
  if (alpha.sign() > 0) return is_odd(kernel) ? roots + pole_at_origin(rate, nats) : roots;
  const Interval passed = roots + pole_of_fading(kernel, rate, distance, nats);
  return is_odd(kernel) ? passed - pole_at_origin(rate, nats) : passed;
}

}  // namespace nipref::ref
