#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <tuple>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/material/internal/polynomial.hpp>
#include <nipref/ref/memory/internal/fading.hpp>
#include <nipref/ref/memory/moving_load.hpp>
#include <nipref/ref/number/internal/cache.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/sheet/kernels.hpp>

namespace nipref::ref {
namespace {

using std::numbers::ln2;
double at_least_40(double nats) { return std::max(nats, 40.0); }
/// The nats of cached results: rounded up, so that only a few values occur.
double nats_of_cached(double nats) { return std::ceil(nats / 16) * 16; }

/// I1, I3, I4 or I5; nothing for I2, which has no symbol.
using Kernel = std::optional<Symbol>;

/// A kernel, or the thesis's sum of `residue_terms` residues if this number is not 0. For I2, a constant, both agree.
Interval kernel_interval(Kernel kernel, const Exact& alpha, double nats, int residue_terms) {
  if (alpha.sign() == 0 && kernel != Symbol::I1) return Interval(64);
  if (!kernel) return I2_interval(alpha, nats);
  if (residue_terms > 0)
    return plain_kernel_at(*kernel, alpha, residue_terms, nats_of_cached(at_least_40(nats)));
  // In the order of Symbol.
  return std::array{I1_interval, I3_interval, I4_interval, I5_interval}[static_cast<std::size_t>(*kernel)](
      alpha, nats);
}

Interval rational(const mpq_class& value, double nats) {
  return {value, working_precision(at_least_40(nats), 1) + 64};
}

double ln_magnitude(const mpq_class& x) { return Exact(x).log2_magnitude() * ln2; }

/// -ln of the relative error of a number of the size 1/rate, or of a distance at rate 0, with error e^{-nats}.
double relative_nats(const mpq_class& rate, double nats) {
  constexpr double of_longest_way = 8;
  if (rate == 0) return nats + of_longest_way;
  return nats + std::max(0.0, -ln_magnitude(rate));
}

/// int_alpha^inf e^{-rate (w - alpha)} (pi/2) sign(w) dw; its finite part if the rate is 0.
ComplexInterval sign_history(const Exact& alpha, const ComplexInterval& rate) {
  const mpfr_prec_t bits = rate.re.precision();
  const Interval half_pi = Interval::pi(bits) / 2, way(alpha, bits);
  if (is_zero(rate)) return {-(half_pi * Interval(alpha.magnitude(), bits)), Interval(bits)};
  const ComplexInterval long_ago = half_pi * inverse(rate);
  if (alpha.sign() >= 0) return long_ago;
  const ComplexInterval faded = exp(way * rate);
  return long_ago * ComplexInterval{2 * faded.re - 1, 2 * faded.im};
}

/// A rate of the memory per half thickness of the load's way: as an interval and, if it is known exactly, as a number.
struct HistoryRate {
  ComplexInterval interval;
  std::optional<mpq_class> exact = {};
};

/// The key of a memory from infinity: kernel, nats, number of residues, alpha and rate.
using HistoryKey = std::tuple<Symbol, double, int, mpq_class, mpq_class>;

Interval make_history(const HistoryKey& key) {
  const auto& [kernel, nats, residue_terms, alpha, rate] = key;
  return residue_terms > 0
             ? plain_memory(kernel, Exact(alpha), Exact(rate), residue_terms, relative_nats(rate, nats))
             : steady_memory(kernel, Exact(alpha), Exact(rate), nats);
}

std::size_t size_of_history(const Interval& history) {
  return static_cast<std::size_t>(history.precision()) + sizeof(HistoryKey);
}

/// The memory from infinity. For exact rates it is cached with up to 16 nats more than requested, because the loads of
/// a contact have distances in common.
ComplexInterval whole_history(Kernel kernel, const Exact& alpha, const HistoryRate& rate, double nats,
                              int residue_terms) {
  static Cache<HistoryKey, Interval> kept(make_history, size_of_history, std::size_t{1} << 24);
  if (!kernel) return sign_history(alpha, rate.interval);
  if (!rate.exact) return steady_memory(*kernel, alpha, rate.interval, nats);
  return {*kept.at({*kernel, nats_of_cached(nats), residue_terms, alpha.value(), *rate.exact}), Interval(64)};
}

/// The nats for a number whose product with e^{-faded} is to have an error of e^{-nats}. They are nats/2^k for a whole
/// k, so that loads with the same start share cached results.
double nats_before_fading(double nats, double faded) {
  double needed = nats;
  while (needed > 2 && needed / 2 >= nats - faded) needed /= 2;
  return needed;
}

/// int_alpha^start e^{-rate (w - alpha)} I(w) dw: the memory from infinity minus its part before the start.
ComplexInterval history(Kernel kernel, const LoadPath& path, const HistoryRate& rate, double wanted_nats,
                        int residue_terms) {
  const double nats = at_least_40(wanted_nats + 2);
  const mpfr_prec_t bits = rate.interval.re.precision();
  ComplexInterval whole = whole_history(kernel, path.alpha, rate, nats, residue_terms);
  if (!path.start) {
    // The infinite part that is left out is counted from the point, not from 0: it is then the same for all points.
    if (is_zero(rate.interval) && kernel != Symbol::I1)
      whole.re = whole.re + (kernel ? 1L : 2L) * (Interval::pi(bits) / 4 * Interval(path.alpha, bits));
    return whole;
  }
  const Interval distance(Exact(mpq_class(path.start->value() - path.alpha.value())), bits);
  const double faded = mpfr_get_d((rate.interval.re * distance).lower(), MPFR_RNDD);
  return whole - exp(-(distance * rate.interval)) *
                     whole_history(kernel, *path.start, rate, nats_before_fading(nats, faded), residue_terms);
}

double ln_size(const ComplexInterval& z) {
  const Float size = upper_end(abs(z));
  return size > 0 ? log2_magnitude(size) * ln2 : 0;
}

/// The memory of a fraction: the sum of the real parts of its terms, because conjugate rates have conjugate terms.
Interval remembered(const ExactRatio& fraction, Kernel kernel, const LoadPath& path,
                    const mpq_class& travel_rate, double nats) {
  constexpr double spare_nats = 48;  // for distances of up to 1000, and for sums
  const auto terms_to = [&](double good_to) {
    return partial_fractions(fraction.numerator, fraction.denominator, working_precision(good_to, 1));
  };
  double large = spare_nats;
  for (const auto& [amplitude, rate] : terms_to(spare_nats)) {
    const double ln_rate = ln_size(rate) - ln_magnitude(travel_rate);
    large = std::max(large, spare_nats + std::max(0.0, ln_size(amplitude) - ln_magnitude(travel_rate)) +
                                std::fabs(ln_rate));
  }
  Interval sum(64);
  for (const auto& [amplitude, rate] : terms_to(at_least_40(nats) + large)) {
    const Interval unit = 1 / Interval(travel_rate, rate.re.precision());
    const ComplexInterval over_distance = unit * amplitude;
    const double needed = at_least_40(nats + ln_size(over_distance) + 4);
    sum = sum + (over_distance * history(kernel, path, {unit * rate}, needed, 0)).re;
  }
  return sum;
}

/// I1 itself, not a sum of its residues. All other kernels have the same bound everywhere.
bool is_unbounded(Kernel kernel, int residue_terms) { return kernel == Symbol::I1 && residue_terms == 0; }

/// Bounds of a kernel and of its slope at distances from the load that are off by at most `error`; BadInput "y" if the
/// load may be there: ref/memory/README.md, What a displacement changes by.
struct KernelBounds {
  Interval size, slope;
};
constexpr mpfr_prec_t few_bits = 64;

KernelBounds kernel_bounds(Kernel kernel, const Exact& around, const mpq_class& error, int residue_terms) {
  const mpq_class nearest = abs(around.value()) - error;
  if (nearest <= 0) throw data::BadInput("y", around.approximate(), "must not be the place of a line load");
  if (is_unbounded(kernel, residue_terms)) {
    const Interval distance(nearest, few_bits);
    return {nearest < 1 ? 3 - log(distance) : Interval(3L, few_bits), 1 / distance + 2};
  }
  const long n = residue_terms;
  const Interval size(n > 0 ? 7 * n + 1 : 4, few_bits), terms(n, few_bits);
  return {size, !kernel ? Interval(few_bits) : n > 0 ? 13 * terms * sqrt(terms) : size};
}

/// The convolution theta * I along a path, without the sheet's factor 1/pi.
struct Part {
  ExactFunction theta;
  Kernel kernel;
  LoadPath path;
  bool negative = false;
  int residue_terms = 0;

  [[nodiscard]] Interval at_once(double nats) const {
    if (theta.instantaneous == 0) return Interval(64);
    const double needed = at_least_40(nats + ln_magnitude(theta.instantaneous) + 3);
    return rational(theta.instantaneous, needed) * kernel_interval(kernel, path.alpha, needed, residue_terms);
  }

  /// The value, with `travel_rate` = speed/half_thickness.
  [[nodiscard]] Interval value(const mpq_class& travel_rate, double nats) const {
    Interval sum = at_once(nats);
    const bool no_history = path.start && path.start->value() == path.alpha.value();
    for (const ExactFunction::Term& term : theta.terms) {
      if (no_history || sgn(term.amplitude) == 0) continue;
      const mpq_class amplitude = term.amplitude / travel_rate;
      const mpq_class rate = term.rate / travel_rate;
      const double needed = nats + ln_magnitude(amplitude) + 3;
      const HistoryRate known{rate_interval(Exact(rate), needed + 8), rate};
      sum = sum + rational(amplitude, relative_nats(rate, at_least_40(needed))) *
                      history(kernel, path, known, needed, residue_terms).re;
    }
    for (const ExactRatio& fraction : theta.fractions) {
      if (!no_history) sum = sum + remembered(fraction, kernel, path, travel_rate, nats + 3);
    }
    return negative ? -sum : sum;
  }

  /// A bound of the change of value() if the distances are off by `error` at most, and amplitudes and rates by `share`
  /// of them at most. theta has no fractions.
  [[nodiscard]] Interval change(const mpq_class& travel_rate, const PathError& error,
                                const mpq_class& share) const {
    const mpq_class longest_way = path.start->value() - path.alpha.value() + error.alpha + error.start;
    const Interval way(longest_way, few_bits);
    const Interval off_now(error.alpha, few_bits), off_at_start(error.start, few_bits);
    const KernelBounds now = kernel_bounds(kernel, path.alpha, error.alpha, residue_terms);
    Interval sum = rational(theta.instantaneous, 0) * now.slope * off_now;
    for (const ExactFunction::Term& term : theta.terms) {
      const Interval rate(mpq_class(term.rate / travel_rate), few_bits);
      const mpq_class amplitude = abs(term.amplitude) / travel_rate * (1 + share);
      const Interval size_at_start = kernel == Symbol::I1
                                         ? kernel_bounds(kernel, *path.start, error.start, residue_terms).size
                                         : now.size;
      // Bounds of int_alpha^start |I(w)| dw, and of the rate times the memory.
      const bool unbounded = is_unbounded(kernel, residue_terms);
      const Interval integral = unbounded ? Interval(8L, few_bits) : now.size * way;
      const Interval rate_times_memory = unbounded ? 8 * rate : now.size;
      sum = sum + rational(amplitude, 0) *
                      ((now.size + rate_times_memory) * off_now + size_at_start * off_at_start +
                       3 * Interval(share, few_bits) * integral);
    }
    return sum;
  }
};

/// About -ln of the size of a displacement near the load.
double size_nats(const ExactFunction& normal) {
  return normal.instantaneous == 0 ? 0 : std::max(0.0, -ln_magnitude(normal.instantaneous));
}

Enclosure sum_over_pi(const std::vector<Part>& parts, const mpq_class& travel_rate, double first_nats,
                      int digits) {
  return enclose(digits, first_nats, [&](double nats) {
    Interval sum(64);
    for (const Part& part : parts) sum = sum + part.value(travel_rate, nats);
    return sum / Interval::pi(sum.precision());
  });
}

void check_positive(const Exact& value, const char* name) {
  if (value.sign() <= 0) throw data::BadInput(name, value.approximate(), "must be > 0");
}

void check_not_below_0(const mpq_class& value, const std::string& name) {
  if (value < 0) throw data::BadInput(name, Exact(value).approximate(), "must be >= 0");
}

/// Refuses too large rates, because the cost of a value grows with the square of the rate's logarithm.
void check_function(const ExactFunction& function, const std::string& name, const mpq_class& travel_rate) {
  constexpr double most = 1e100;
  check_not_below_0(function.instantaneous, name + " instantaneous");
  double fastest = -HUGE_VAL;  // log2
  for (const ExactFunction::Term& term : function.terms) {
    check_not_below_0(term.rate, name + " rate");
    fastest = std::max(fastest, Exact(term.rate).log2_magnitude());
  }
  for (const ExactRatio& fraction : function.fractions)
    fastest = std::max(fastest, log2_root_bound(fraction.denominator));
  if (fastest - Exact(travel_rate).log2_magnitude() > std::log2(most))
    throw data::BadInput("material", "(as given)", "must have no rates above 1e100 speed/half_thickness");
}

LoadPath started_place(const Exact& t, const Exact& T, const mpq_class& travel_rate, const char* name) {
  if (t.sign() < 0) throw data::BadInput("t", t.approximate(), "must be >= 0");
  const Exact alpha(mpq_class((T.value() - t.value()) * travel_rate));
  const Exact start(mpq_class(T.value() * travel_rate));
  for (const Exact* distance : {&alpha, &start}) {
    if (abs(distance->value()) > 1000) {
      throw data::BadInput(name, T.approximate(), "must be within 1000 half_thickness/speed of both 0 and t");
    }
  }
  return {alpha, start};
}

/// Refuses too large distances, because with fractions the cost of a value grows at least with the distance squared.
void check_distance(const ExactFunction& function, const LoadPath& path) {
  constexpr double farthest = 250;
  if (function.fractions.empty()) return;
  const double distance =
      std::max(std::fabs(path.alpha.approximate()), path.start ? std::fabs(path.start->approximate()) : 0);
  if (distance > farthest)
    throw data::BadInput(
        "distance from the load", distance,
        "half thicknesses, must be at most 250 for operators whose roots are no rational numbers");
}

/// The slowest rate at which Un decays with the distance from the load, 1/half thickness.
double decay_of_normal(const ExactFunction& normal, const LoadPath& path, const mpq_class& travel_rate) {
  double slowest = slowest_decay;
  if (path.alpha.sign() > 0) return slowest;
  for (const ExactFunction::Term& term : normal.terms)
    slowest = std::min(slowest, mpq_class(term.rate / travel_rate).get_d());
  for (const ExactRatio& fraction : normal.fractions)
    slowest = std::min(slowest, slowest_rate(fraction.denominator) / travel_rate.get_d());
  return slowest;
}

std::vector<Part> tangential_parts(const LoadPath& alpha, const LoadPath& eta, const ExactFunction& normal,
                                   const ExactMaterial& material, int residue_terms) {
  return {{normal, Symbol::I3, alpha, false, residue_terms},
          {material.theta2, std::nullopt, alpha, true, residue_terms},
          {material.theta2, Symbol::I4, eta, false, residue_terms},
          {material.theta1, Symbol::I5, eta, true, residue_terms}};
}

}  // namespace

MovingLoad::MovingLoad(ExactMaterial material, const Exact& speed, const Exact& half_thickness,
                       int residue_terms)
    : material_(std::move(material)), normal_(material_.normal()), residue_terms_(residue_terms) {
  check_positive(speed, "speed");
  check_positive(half_thickness, "half_thickness");
  travel_rate_ = speed.value() / half_thickness.value();
  check_function(material_.theta1, "theta1", travel_rate_);
  check_function(material_.theta2, "theta2", travel_rate_);
}

Enclosure MovingLoad::normal_at(const LoadPath& path, int digits) const {
  check_distance(normal_, path);
  const double distance = std::abs(path.alpha.approximate());
  const double first_nats = size_nats(normal_) + distance * decay_of_normal(normal_, path, travel_rate_);
  return sum_over_pi({{normal_, Symbol::I1, path, false, residue_terms_}}, travel_rate_, first_nats, digits);
}

Enclosure MovingLoad::tangential_at(const LoadPath& alpha, const LoadPath& eta, int digits) const {
  for (const LoadPath& path : {alpha, eta}) check_distance(normal_, path);
  const bool at_rest = alpha.start && alpha.start->value() == alpha.alpha.value();
  if (at_rest && alpha.alpha.sign() == 0 && eta.alpha.sign() == 0) return exact_zero(digits);
  return sum_over_pi(tangential_parts(alpha, eta, normal_, material_, residue_terms_), travel_rate_,
                     size_nats(normal_), digits);
}

Enclosure MovingLoad::normal_displacement(const Exact& t, const Exact& T, int digits) const {
  const LoadPath path = started_place(t, T, travel_rate_, "T");
  if (path.alpha.sign() == 0)
    throw data::BadInput("T", T.approximate(), "must differ from t: the displacement is infinite there");
  return normal_at(path, digits);
}

Enclosure MovingLoad::tangential_displacement(const Exact& t, const Exact& T, const Exact& t0,
                                              int digits) const {
  return tangential_at(started_place(t, T, travel_rate_, "T"), started_place(t, t0, travel_rate_, "t0"),
                       digits);
}

Interval MovingLoad::normal_change(const Exact& t, const Exact& T, const MovingLoadError& error) const {
  const Part part{normal_, Symbol::I1, started_place(t, T, travel_rate_, "T"), false, residue_terms_};
  return part.change(travel_rate_, error.load, error.memory) / Interval::pi(64);
}

Interval MovingLoad::tangential_change(const Exact& t, const Exact& T, const Exact& t0,
                                       const MovingLoadError& error) const {
  const LoadPath alpha = started_place(t, T, travel_rate_, "T"),
                 eta = started_place(t, t0, travel_rate_, "t0");
  Interval sum(64);
  for (const Part& part : tangential_parts(alpha, eta, normal_, material_, residue_terms_)) {
    const bool of_load = !part.kernel || part.kernel == Symbol::I3;
    sum = sum + part.change(travel_rate_, of_load ? error.load : error.fixed_point, error.memory);
  }
  return sum / Interval::pi(64);
}

Enclosure MovingLoad::steady_normal_displacement(const Exact& alpha, int digits) const {
  check_nonzero_argument(alpha, "alpha");
  return normal_at({alpha, std::nullopt}, digits);
}

Enclosure MovingLoad::steady_tangential_displacement(const Exact& alpha, const Exact& eta, int digits) const {
  check_argument(alpha, "alpha");
  check_argument(eta, "eta");
  return tangential_at({alpha, std::nullopt}, {eta, std::nullopt}, digits);
}

}  // namespace nipref::ref
