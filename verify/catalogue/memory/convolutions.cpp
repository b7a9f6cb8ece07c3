#include <nipref/fast/memory/convolutions.hpp>
#include <nipref/fast/sheet/roots.hpp>
#include <nipref/ref/memory/convolutions.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {

double nearby(double value, Random& random) {
  const double size = std::ldexp(random.uniform(0.5, 1), -static_cast<int>(random.index(52)));
  const double near = value * (1 + (random.chance(0.5) ? size : -size));
  return near == value ? std::nextafter(value, std::numeric_limits<double>::infinity()) : near;
}

double draw_passing_time(double t, Random& random) {
  const std::size_t way = random.index(6);
  if (way < 2) return nearby(t, random);
  if (way == 2) return t * random.log_uniform(1e-16, 1e-3) * (random.chance(0.5) ? 1 : -1);
  if (way == 3) return -random.log_uniform(1e-9, 50);
  return way == 4 ? t * random.uniform() : random.log_uniform(1e-9, 50);
}

namespace {

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

/// The size of J1, and of J2 with b = infinity: the load is ahead of the point. The integral is over the distances
/// w = T - tau from lo to T with the factors e^(-lambda (w - (T - t))) and e^(-a w).
double size_ahead(double lambda, double a, double b, double t, double T) {
  if (T <= 0) return 0;
  const double lo = std::max(T - t, 0.0);
  return std::exp(-lambda * std::max(t - T, 0.0) - a * lo) * faded_wave(lambda + a, T - lo, b, lo);
}

/// The size of J3 and J4: over w = tau - T from lo to t - T with the factors e^(-lambda (t - T - w)) and e^(-a w).
double size_behind(double lambda, double a, double b, double t, double T) {
  if (t <= T) return 0;
  const double lo = std::max(-T, 0.0), hi = t - T, length = std::min(t, hi);
  return a > lambda ? std::exp(-lambda * length - a * lo) * faded_wave(a - lambda, length, b, lo)
                    : std::exp(-a * hi) * fading_wave(lambda - a, length, b, hi);
}

void draw_wave(Random& random, const NamedNumbers& x) {
  x["a"] = random.log_uniform(1e-6, 1e4);
  x["b"] = random.log_uniform(1e-6, 1e4);
  if (random.chance(0.5)) {
    const auto root = fast::sheet_root(static_cast<int>(random.log_uniform(1, 1000)));
    x["a"] = root.imag();
    x["b"] = root.real();
  }
  x["lambda"] = random.chance(0.15) ? nearby(x["a"], random) : random.log_uniform(1e-12, 1e12);
  x["t"] = random.log_uniform(1e-9, 50);
  x["T"] = draw_passing_time(x["t"], random);
}

template <class ByRef, class ByFast, class Size>
Quantity wave_entry(const char* name, ByRef by_ref, ByFast by_fast, Size size) {
  return sampled(entry_of(name, {"lambda", "a", "b", "t", "T"}, by_ref, by_fast, size), draw_wave);
}

void draw_sign(Random& random, const NamedNumbers& x) {
  x["t"] = random.log_uniform(1e-9, 50);
  const double sign = random.chance(0.5) ? 1 : -1;
  x["gamma0"] = random.log_uniform(1e-6, 1e6);
  x["gamma"] = sign * random.log_uniform(1e-6, 1e6);
  x["lambda"] = random.log_uniform(1e-12, 1e12);
  x["T"] = draw_passing_time(x["t"], random);
}

template <class ByRef, class ByFast>
Quantity sign_entry(const char* name, ByRef by_ref, ByFast by_fast) {
  const auto size = [](double gamma0, double gamma, double lambda, double t, double) {
    return std::fabs(gamma0) + std::fabs(gamma) * faded(lambda, t);
  };
  return sampled(entry_of(name, {"gamma0", "gamma", "lambda", "t", "T"}, by_ref, by_fast, size), draw_sign);
}

constexpr double cosine = HUGE_VAL;  // min(1, b w) = 1

/// The size without b.
auto of_cosine(double (*size)(double lambda, double a, double b, double t, double T)) {
  return
      [size](double lambda, double a, double, double t, double T) { return size(lambda, a, cosine, t, T); };
}

}  // namespace

std::vector<Quantity> memory_entries() {
  return {wave_entry("J1", ref::J1, fast::J1, size_ahead),
          wave_entry("J2", ref::J2, fast::J2, of_cosine(size_ahead)),
          wave_entry("J3", ref::J3, fast::J3, size_behind),
          wave_entry("J4", ref::J4, fast::J4, of_cosine(size_behind)),
          sign_entry("J5", ref::J5, fast::J5),
          sign_entry("J6", ref::J6, fast::J6)};
}

}  // namespace nipref::verify
