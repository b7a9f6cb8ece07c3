#include <algorithm>
#include <cmath>

#include <nipref/fast/memory/convolutions.hpp>
#include <nipref/fast/sheet/roots.hpp>
#include <nipref/ref/memory/convolutions.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>
#include <nipref/verify/catalogue/memory/internal/passing_times.hpp>

namespace nipref::verify {
namespace {

using Arguments = std::span<const double>;
using Exacts = std::span<const ref::Exact>;
using fast::Accuracy;

constexpr double memory_promise = 4;

/// int_0^x e^(-k v) dv.
double faded(double k, double x) { return k * x == 0 ? x : -std::expm1(-k * x) / k; }

/// int_0^x v e^(-k v) dv.
double faded_moment(double k, double x) {
  const double fade = k * x;
  if (fade < 1e-2) return x * x * (0.5 - fade / 3);
  return (faded(k, x) - x * std::exp(-fade)) / k;
}

/// int_0^x e^(-k v) min(1, b (from + v)) dv.
double faded_wave(double k, double x, double b, double from) {
  const double until = b == 0 ? x : std::clamp(1 / b - from, 0.0, x);
  const double rising = until > 0 ? b * (from * faded(k, until) + faded_moment(k, until)) : 0;
  return rising + std::exp(-k * until) * faded(k, x - until);
}

/// int_0^x e^(-k v) min(1, b (to - v)) dv, to >= x.
double fading_wave(double k, double x, double b, double to) {
  const double from = b == 0 ? 0 : std::clamp(to - 1 / b, 0.0, x);
  const double rest = x - from;
  const double falling =
      rest > 0 ? b * std::max(0.0, (to - from) * faded(k, rest) - faded_moment(k, rest)) : 0;
  return faded(k, from) + std::exp(-k * from) * falling;
}

/// Of J1, and of J2 with b = infinity. The load ahead of the point: distances w = T - tau from lo to T, faded
/// by e^(-lambda (w - (T - t))) and e^(-a w).
double size_ahead(double lambda, double a, double b, double t, double T) {
  if (T <= 0) return 0;
  const double lo = std::max(T - t, 0.0);
  return std::exp(-lambda * std::max(t - T, 0.0) - a * lo) * faded_wave(lambda + a, T - lo, b, lo);
}

/// Of J3 and J4: w = tau - T from lo to t - T, faded by e^(-lambda (t - T - w)) and e^(-a w).
double size_behind(double lambda, double a, double b, double t, double T) {
  if (t <= T) return 0;
  const double lo = std::max(-T, 0.0), hi = t - T, length = std::min(t, hi);
  return a > lambda ? std::exp(-lambda * length - a * lo) * faded_wave(a - lambda, length, b, lo)
                    : std::exp(-a * hi) * fading_wave(lambda - a, length, b, hi);
}

Point draw_wave(Random& random) {
  double a = random.log_uniform(1e-6, 1e4), b = random.log_uniform(1e-6, 1e4);
  if (random.chance(0.5)) {
    const auto root = fast::sheet_root(static_cast<int>(random.log_uniform(1, 1000)));
    a = root.imag();
    b = root.real();
  }
  const double lambda = random.chance(0.15) ? nearby(a, random) : random.log_uniform(1e-12, 1e12);
  const double t = random.log_uniform(1e-9, 50);
  return {lambda, a, b, t, draw_passing_time(t, random)};
}

template <class ByRef, class ByFast, class Size>
Quantity wave_entry(std::string name, std::string definition, std::string source, ByRef by_ref,
                    ByFast by_fast, Size size) {
  Quantity entry;
  entry.name = std::move(name);
  entry.definition = std::move(definition);
  entry.source = "thesis (6.20), " + source;
  entry.unit = "unit of t";
  entry.scale = "the integral of the exponentials, under a sine times min(1, b |T - tau|)";
  for (const char* rate : {"lambda", "a", "b"}) entry.arguments.push_back({rate, ArgumentKind::rate, {}, {}});
  entry.arguments.push_back({"t", ArgumentKind::time, {}, {}});
  entry.arguments.push_back({"T", ArgumentKind::passing_time, {}, {}});
  entry.promise = memory_promise;
  entry.draw = draw_wave;
  entry.by_ref = [by_ref](Exacts x, int digits) { return by_ref(x[0], x[1], x[2], x[3], x[4], digits); };
  set_fast(entry, [by_fast](Arguments x, Accuracy) { return by_fast(x[0], x[1], x[2], x[3], x[4]); });
  entry.envelope = [size](Arguments x) { return size(x[0], x[1], x[2], x[3], x[4]); };
  return entry;
}

template <class ByRef, class ByFast>
Quantity sign_entry(std::string name, std::string of, ByRef by_ref, ByFast by_fast) {
  Quantity entry;
  entry.name = std::move(name);
  entry.definition =
      "int_0^t theta(t - tau) sign(T - tau) dtau, theta = gamma0 delta + gamma e^(-lambda t) a term of " + of;
  entry.source = "thesis (6.20), (AII.20), (AII.21)";
  entry.unit = "unit of gamma0";
  entry.scale = "|gamma0| + |gamma| int_0^t e^(-lambda tau) dtau";
  for (const char* amplitude : {"gamma0", "gamma"})
    entry.arguments.push_back({amplitude, ArgumentKind::amplitude, {}, {}});
  entry.arguments.push_back({"lambda", ArgumentKind::rate, {}, {}});
  entry.arguments.push_back({"t", ArgumentKind::time, {}, {}});
  entry.arguments.push_back({"T", ArgumentKind::passing_time, {}, {}});
  entry.promise = memory_promise;
  entry.draw = [](Random& random) {
    const double t = random.log_uniform(1e-9, 50);
    const double sign = random.chance(0.5) ? 1 : -1;
    return Point{random.log_uniform(1e-6, 1e6), sign * random.log_uniform(1e-6, 1e6),
                 random.log_uniform(1e-12, 1e12), t, draw_passing_time(t, random)};
  };
  entry.by_ref = [by_ref](Exacts x, int digits) { return by_ref(x[0], x[1], x[2], x[3], x[4], digits); };
  set_fast(entry, [by_fast](Arguments x, Accuracy) { return by_fast(x[0], x[1], x[2], x[3], x[4]); });
  entry.envelope = [](Arguments x) { return std::fabs(x[0]) + std::fabs(x[1]) * faded(x[2], x[3]); };
  return entry;
}

constexpr double cosine = HUGE_VAL;  // min(1, b w) = 1

double size_ahead_cosine(double lambda, double a, double, double t, double T) {
  return size_ahead(lambda, a, cosine, t, T);
}
double size_behind_cosine(double lambda, double a, double, double t, double T) {
  return size_behind(lambda, a, cosine, t, T);
}

}  // namespace

std::vector<Quantity> memory_entries() {
  return {wave_entry("J1", "int_0^t H(T - tau) e^(-lambda (t - tau) - a (T - tau)) sin b(T - tau) dtau",
                     "(AII.6)", ref::J1, fast::J1, size_ahead),
          wave_entry("J2", "int_0^t H(T - tau) e^(-lambda (t - tau) - a (T - tau)) cos b(T - tau) dtau",
                     "(AII.6)", ref::J2, fast::J2, size_ahead_cosine),
          wave_entry("J3", "int_0^t H(tau - T) e^(-lambda (t - tau) + a (T - tau)) sin b(T - tau) dtau",
                     "(AII.9), (AII.13)", ref::J3, fast::J3, size_behind),
          wave_entry("J4", "int_0^t H(tau - T) e^(-lambda (t - tau) + a (T - tau)) cos b(T - tau) dtau",
                     "(AII.9), (AII.13)", ref::J4, fast::J4, size_behind_cosine),
          sign_entry("J5", "theta1", ref::J5, fast::J5),
          sign_entry("J6", "theta2", ref::J6, fast::J6)};
}

}  // namespace nipref::verify
