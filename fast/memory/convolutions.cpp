#include <algorithm>
#include <cmath>
#include <complex>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/memory/convolutions.hpp>
#include <nipref/fast/number/two_words.hpp>

namespace nipref::fast {
namespace {

using internal::Two;
using Extended = long double;
using Wave = std::complex<Extended>;

constexpr double largest = 1e150;

void check(const char* name, double value, double least) {
  if (value >= least && value <= largest) return;
  throw data::BadInput(name, value, least < 0 ? "must be from -1e150 to 1e150" : "must be from 0 to 1e150");
}

void check_times(double lambda, double t, double T) {
  check("lambda", lambda, 0);
  check("t", t, 0);
  check("T", T, -largest);
}

/// e^(i b u). The phase b u has two words; above 10 radians its rounding to one word would affect the result.
Wave wave(double b, Two u) {
  const Two phase = Two{b, 0} * u;
  return std::polar(Extended{1}, Extended{phase.high}) * std::polar(Extended{1}, Extended{phase.low});
}

Extended fading(double rate, Two time) {
  const Two exponent = Two{rate, 0} * time;
  return std::exp(-Extended{exponent.high}) * (1 - Extended{exponent.low});
}

/// (1 - e^(-x))/x for x >= 0.
Extended extended_phi1(Extended x) { return x < 1e-25L ? 1 : -std::expm1(-x) / x; }

/// int_0^m e^(-(decay - i b) s) ds.
Wave integral(Extended decay, double b, Two length) {
  const Extended m = Extended{length.high} + length.low;
  const Extended x = decay * m;
  const Extended y = b * m;
  if (x + y < 1) {
    // The power series sum (i y - x)^k/(k+1)!, as the closed form loses the sine's first order in y by cancellation.
    Wave sum = 0;
    for (int k = 20; k >= 0; --k) sum = Extended{1} + Wave(-x, y) * sum / static_cast<Extended>(k + 2);
    return m * sum;
  }
  const Extended faded = std::exp(-x), sine_of_half = wave(b / 2, length).imag();
  const Extended rise = -std::expm1(-x) + 2 * faded * sine_of_half * sine_of_half;  // 1 - e^(-x) cos y
  return Wave(rise, -faded * wave(b, length).imag()) * Wave(decay, b) / (decay * decay + Extended{b} * b);
}

/// The integral with e^(i b |T - tau|). Its real part is the integral with the cosine, its imaginary part that with the
/// sine. Nothing cancels: each part is a sum of two products, neither of which exceeds the scale.
Wave convolution(Extended amplitude, Extended rate, double b, Two start, Two length) {
  if (amplitude == 0 || length.high == 0) return 0;
  return amplitude * (wave(b, start) * integral(rate, b, length));
}

/// J2 + i J1, for the time before the load passes the point. The integral runs backwards from tau = min(t, T), so that
/// both exponentials decay.
Wave approaching(double lambda, double a, double b, double t, double T) {
  check_times(lambda, t, T);
  check("a", a, 0);
  check("b", b, 0);
  if (T <= 0) return 0;
  if (T >= t) {
    const Two ahead = internal::two_sum(T, -t);
    return convolution(fading(a, ahead), Extended{lambda} + a, b, ahead, {t, 0});
  }
  return convolution(fading(lambda, internal::two_sum(t, -T)), Extended{lambda} + a, b, {0, 0}, {T, 0});
}

/// J4 - i J3, for the time after the load has passed the point. If lambda >= a, the relaxation decays faster than the
/// residue, and the integral runs backwards from tau = t; otherwise it runs forwards from tau = max(0, T). Either way
/// the integrand decays.
Wave receding(double lambda, double a, double b, double t, double T) {
  check_times(lambda, t, T);
  check("a", a, 0);
  check("b", b, 0);
  if (T >= t) return 0;
  const double first = std::max(0.0, T);
  const Two length = internal::two_sum(t, -first);
  if (lambda >= a) {
    const Two behind = internal::two_sum(t, -T);
    // Backwards the distance decreases: e^(i b (behind - s)) is the conjugate of e^(i b (s - behind)).
    return std::conj(convolution(fading(a, behind), Extended{lambda} - a, b, -behind, length));
  }
  const Two behind = T < 0 ? Two{-T, 0} : Two{0, 0};
  const Extended amplitude = fading(a, behind) * fading(lambda, length);
  return convolution(amplitude, Extended{a} - lambda, b, behind, length);
}

/// int_first^last e^(-lambda (t - tau)) dtau.
Extended faded_time(double lambda, double t, double first, double last) {
  const Extended length = Extended{last} - first;
  return fading(lambda, internal::two_sum(t, -last)) * length * extended_phi1(lambda * length);
}

}  // namespace

double J1(double lambda, double a, double b, double t, double T) {
  return static_cast<double>(approaching(lambda, a, b, t, T).imag());
}

double J2(double lambda, double a, double b, double t, double T) {
  return static_cast<double>(approaching(lambda, a, b, t, T).real());
}

double J3(double lambda, double a, double b, double t, double T) {
  return static_cast<double>(-receding(lambda, a, b, t, T).imag());
}

double J4(double lambda, double a, double b, double t, double T) {
  return static_cast<double>(receding(lambda, a, b, t, T).real());
}

double J5(double gamma0, double gamma, double lambda, double t, double T) {
  check_times(lambda, t, T);
  check("gamma0", gamma0, -largest);
  check("gamma", gamma, -largest);
  const double passed = std::clamp(T, 0.0, t);
  const Extended before = passed > 0 ? faded_time(lambda, t, 0, passed) : 0;
  const Extended after = passed < t ? faded_time(lambda, t, passed, t) : 0;
  const int sign = (T > t) - (T < t);
  return static_cast<double>(Extended{gamma0} * sign + gamma * (before - after));
}

double J6(double gamma0, double gamma, double lambda, double t, double T) {
  return J5(gamma0, gamma, lambda, t, T);
}

}  // namespace nipref::fast
