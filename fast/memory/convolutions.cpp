#include <algorithm>
#include <cmath>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/memory/convolutions.hpp>
#include <nipref/fast/number/two_words.hpp>

namespace nipref::fast {
namespace {

using internal::Two;
using Wide = long double;

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

struct Wave {
  Wide cosine, sine;
};

/// The phase b u, whose rounding to one word would be felt from 10 radians on.
Wave wave(double b, Two u) {
  const Two phase = Two{b, 0} * u;
  const Wide c = std::cos(Wide{phase.high}), s = std::sin(Wide{phase.high});
  const Wide dc = std::cos(Wide{phase.low}), ds = std::sin(Wide{phase.low});
  return {c * dc - s * ds, s * dc + c * ds};
}

Wide fading(double rate, Two time) {
  const Two exponent = Two{rate, 0} * time;
  return std::exp(-Wide{exponent.high}) * (1 - Wide{exponent.low});
}

/// (1 - e^(-x))/x for x >= 0.
Wide phi1(Wide x) { return x < 1e-25L ? 1 : -std::expm1(-x) / x; }

/// int_0^m e^(-(decay - i b) s) ds.
Wave integral(Wide decay, double b, Two length) {
  const Wide m = Wide{length.high} + length.low;
  const Wide x = decay * m;
  const Wide y = b * m;
  if (x + y < 1) {
    // sum (i y - x)^k/(k+1)!: to first order in y its sine cancels in the closed form.
    Wave sum{0, 0};
    for (int k = 20; k >= 0; --k) {
      sum = {1 + (-x * sum.cosine - y * sum.sine) / (k + 2), (y * sum.cosine - x * sum.sine) / (k + 2)};
    }
    return {m * sum.cosine, m * sum.sine};
  }
  const Wide faded = std::exp(-x);
  const Wave end = wave(b, length);
  const Wave half = wave(b / 2, length);
  const Wide rise = -std::expm1(-x) + 2 * faded * half.sine * half.sine;  // 1 - e^(-x) cos y
  const Wide slant = faded * end.sine;
  const Wide square = decay * decay + Wide{b} * b;
  return {(rise * decay + slant * b) / square, (rise * b - slant * decay) / square};
}

/// The two integrals at once, e^(i b |T - tau|) under them: nothing but products, and one sum of terms that
/// are each within the scale.
Wave convolution(Wide amplitude, Wide rate, double b, Two start, Two length) {
  if (amplitude == 0 || length.high == 0) return {0, 0};
  const Wave w = wave(b, start);
  const Wave z = integral(rate, b, length);
  return {amplitude * (w.cosine * z.cosine - w.sine * z.sine),
          amplitude * (w.sine * z.cosine + w.cosine * z.sine)};
}

/// While the load comes nearer: J2 + i J1. From tau = min(t, T) backwards both factors fade.
Wave approaching(double lambda, double a, double b, double t, double T) {
  check_times(lambda, t, T);
  check("a", a, 0);
  check("b", b, 0);
  if (T <= 0) return {0, 0};
  if (T >= t) {
    const Two ahead = internal::two_sum(T, -t);
    return convolution(fading(a, ahead), Wide{lambda} + a, b, ahead, {t, 0});
  }
  return convolution(fading(lambda, internal::two_sum(t, -T)), Wide{lambda} + a, b, {0, 0}, {T, 0});
}

/// Once it has passed: J4 - i J3. With lambda >= a the memory fades faster than the residue and the integral
/// runs back from tau = t, else forward from tau = max(0, T); either way nothing grows.
Wave receding(double lambda, double a, double b, double t, double T) {
  check_times(lambda, t, T);
  check("a", a, 0);
  check("b", b, 0);
  if (T >= t) return {0, 0};
  const double first = std::max(0.0, T);
  const Two length = internal::two_sum(t, -first);
  if (lambda >= a) {
    const Two behind = internal::two_sum(t, -T);
    // Backwards the distance shrinks: e^(i b (behind - s)) is the conjugate of e^(i b (s - behind)).
    const Wave back = convolution(fading(a, behind), Wide{lambda} - a, b, -behind, length);
    return {back.cosine, -back.sine};
  }
  const Two behind = T < 0 ? Two{-T, 0} : Two{0, 0};
  const Wide amplitude = fading(a, behind) * fading(lambda, length);
  return convolution(amplitude, Wide{a} - lambda, b, behind, length);
}

/// int_first^last e^(-lambda (t - tau)) dtau.
Wide faded_time(double lambda, double t, double first, double last) {
  const Wide length = Wide{last} - first;
  return fading(lambda, internal::two_sum(t, -last)) * length * phi1(lambda * length);
}

double sign_memory(double gamma0, double gamma, double lambda, double t, double T) {
  check_times(lambda, t, T);
  check("gamma0", gamma0, -largest);
  check("gamma", gamma, -largest);
  const double passed = std::clamp(T, 0.0, t);
  const Wide before = passed > 0 ? faded_time(lambda, t, 0, passed) : 0;
  const Wide after = passed < t ? faded_time(lambda, t, passed, t) : 0;
  const int sign = (T > t) - (T < t);
  return static_cast<double>(Wide{gamma0} * sign + gamma * (before - after));
}

}  // namespace

double J1(double lambda, double a, double b, double t, double T) {
  return static_cast<double>(approaching(lambda, a, b, t, T).sine);
}

double J2(double lambda, double a, double b, double t, double T) {
  return static_cast<double>(approaching(lambda, a, b, t, T).cosine);
}

double J3(double lambda, double a, double b, double t, double T) {
  return static_cast<double>(-receding(lambda, a, b, t, T).sine);
}

double J4(double lambda, double a, double b, double t, double T) {
  return static_cast<double>(receding(lambda, a, b, t, T).cosine);
}

double J5(double gamma0, double gamma, double lambda, double t, double T) {
  return sign_memory(gamma0, gamma, lambda, t, T);
}

double J6(double gamma0, double gamma, double lambda, double t, double T) {
  return sign_memory(gamma0, gamma, lambda, t, T);
}

}  // namespace nipref::fast
