#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/memory/convolutions.hpp>
#include <nipref/ref/number/internal/complex.hpp>

namespace nipref::ref {
namespace {

mpfr_prec_t bits_for(double nats) {
  constexpr mpfr_prec_t spare_bits = 96;  // angles are below 2^50
  return static_cast<mpfr_prec_t>(std::ceil(std::max(nats, 1.0) / std::numbers::ln2)) + spare_bits;
}

/// The memory of a decaying wave: e^{-decay} int_0^length e^{-rate v} e^{i (angle + frequency v)} dv with exact
/// numbers, length > 0. e^{-decay} is the largest exponential of the integrand, so that rate >= 0.
struct DampedWave {
  mpq_class decay;
  mpq_class angle;
  mpq_class rate;
  mpq_class frequency;
  mpq_class length;

  /// e^{-decay + i angle} (1 - e^{-z length})/z, z = rate - i frequency, with more bits where the difference cancels.
  [[nodiscard]] ComplexInterval integral(double nats) const {
    const mpq_class turn = std::max<mpq_class>(rate, abs(frequency)) * length;
    const double lost = turn == 0 ? 0 : std::max(0.0, -Exact(turn).log2_magnitude());
    const mpfr_prec_t bits = bits_for(nats) + static_cast<mpfr_prec_t>(lost);
    const auto exactly = [&](const mpq_class& x) { return Interval(x, bits); };
    const ComplexInterval largest = exp(ComplexInterval{-exactly(decay), exactly(angle)});
    if (turn == 0) return exactly(length) * largest;
    const ComplexInterval z{exactly(rate), -exactly(frequency)}, one{exactly(1), exactly(0)};
    return largest * (one - exp(-(exactly(length) * z))) * inverse(z);
  }
};

struct Arguments {
  const mpq_class& lambda;
  const mpq_class& a;
  const mpq_class& b;
  const mpq_class& t;
  const mpq_class& T;
};

/// The wave before the load passes, in v = T - tau - last, where `last` is T - tau at the end of the integral.
DampedWave before(const Arguments& x) {
  const mpq_class last = x.T > x.t ? mpq_class(x.T - x.t) : mpq_class(0);
  return {x.lambda * (x.t - x.T) + (x.lambda + x.a) * last, x.b * last, x.lambda + x.a, x.b, x.T - last};
}

/// The wave after the load has passed, w = tau - T from `first` to `last`. v is counted from the end of this range at
/// which the integrand is larger.
DampedWave after(const Arguments& x) {
  const mpq_class first = x.T < 0 ? mpq_class(-x.T) : mpq_class(0);
  const mpq_class last = x.t - x.T;
  const mpq_class length = last - first;
  if (x.lambda >= x.a) return {x.a * last, x.b * last, x.lambda - x.a, -x.b, length};
  return {x.lambda * length + x.a * first, x.b * first, x.a - x.lambda, x.b, length};
}

void check_not_negative(const Exact& value, const char* name) {
  if (value.sign() < 0) throw data::BadInput(name, value.approximate(), "must be >= 0");
}

void check_extent(const Exact& rate, const char* name, const Exact& t, const Exact& T) {
  check_not_negative(rate, name);
  const mpq_class longest = std::max<mpq_class>(t.value(), abs(T.value()));
  if (rate.value() * longest > mpq_class(1'000'000'000'000'000)) {
    throw data::BadInput(name, rate.approximate(), "times t and times |T| must be at most 1e15");
  }
}

/// 0 with an error bound, for values below e^{-7e8} times a length, which is below e^{1e8}.
Enclosure faded_away(int digits) {
  Enclosure result = exact_zero(digits);
  result.error = upper_end(exp(Interval(-600'000'000L, 64)));
  return result;
}

/// `sign` times the real or, for a sine, the imaginary part of a wave's integral.
Enclosure part(const DampedWave& wave, bool sine, long sign, int digits) {
  if (wave.length <= 0 || (sine && wave.frequency == 0)) return exact_zero(digits);
  if (wave.decay > 700'000'000) return faded_away(digits);
  return enclose(digits, 0, [&](double nats) {
    const ComplexInterval integral = wave.integral(nats);
    return sign * (sine ? integral.im : integral.re);
  });
}

Enclosure convolution(DampedWave (*side)(const Arguments&), bool sine, long sign, const Exact& lambda,
                      const Exact& a, const Exact& b, const Exact& t, const Exact& T, int digits) {
  check_not_negative(t, "t");
  check_extent(lambda, "lambda", t, T);
  check_extent(a, "a", t, T);
  check_extent(b, "b", t, T);
  return part(side({lambda.value(), a.value(), b.value(), t.value(), T.value()}), sine, sign, digits);
}

/// e^{-decay} int_0^length e^{-rate v} dv
Interval fading(const mpq_class& decay, const mpq_class& rate, const mpq_class& length, double nats) {
  return DampedWave{decay, 0, rate, 0, length}.integral(nats).re;
}

/// int_0^t e^{-lambda (t - tau)} sign(T - tau) dtau, t > 0, lambda > 0, with an error of e^{-nats} times each of its
/// two parts, before and after T.
Interval sign_memory(const mpq_class& lambda, const mpq_class& t, const mpq_class& T, double nats) {
  const mpq_class turn = std::clamp<mpq_class>(T, 0, t);
  const mpq_class since = t - turn;
  return fading(lambda * since, lambda, turn, nats) - fading(0, lambda, since, nats);
}

}  // namespace

Enclosure J1(const Exact& lambda, const Exact& a, const Exact& b, const Exact& t, const Exact& T,
             int digits) {
  return convolution(before, true, 1, lambda, a, b, t, T, digits);
}

Enclosure J2(const Exact& lambda, const Exact& a, const Exact& b, const Exact& t, const Exact& T,
             int digits) {
  return convolution(before, false, 1, lambda, a, b, t, T, digits);
}

Enclosure J3(const Exact& lambda, const Exact& a, const Exact& b, const Exact& t, const Exact& T,
             int digits) {
  return convolution(after, true, -1, lambda, a, b, t, T, digits);
}

Enclosure J4(const Exact& lambda, const Exact& a, const Exact& b, const Exact& t, const Exact& T,
             int digits) {
  return convolution(after, false, 1, lambda, a, b, t, T, digits);
}

Enclosure J5(const Exact& gamma0, const Exact& gamma, const Exact& lambda, const Exact& t, const Exact& T,
             int digits) {
  check_not_negative(t, "t");
  check_extent(lambda, "lambda", t, T);
  const mpq_class at_once = gamma0.value() * sgn(mpq_class(T.value() - t.value()));
  const mpq_class turn = std::clamp<mpq_class>(T.value(), 0, t.value());
  const bool forgets = lambda.sign() > 0 && gamma.sign() != 0 && t.sign() > 0;
  // Without decay the value is a rational number, which may be 0. Otherwise it is irrational, as exponentials of
  // different rational numbers are linearly independent over the rationals.
  const mpq_class unfading = at_once + gamma.value() * (2 * turn - t.value());
  if (!forgets && unfading == 0) return exact_zero(digits);
  return enclose(digits, 0, [&](double nats) {
    const mpfr_prec_t bits = bits_for(nats);
    if (!forgets) return Interval(unfading, bits);
    return Interval(at_once, bits) +
           Interval(gamma, bits) * sign_memory(lambda.value(), t.value(), T.value(), nats);
  });
}

}  // namespace nipref::ref
