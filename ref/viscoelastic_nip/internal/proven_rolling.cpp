#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/material/exact_material.hpp>
#include <nipref/ref/memory/internal/fading.hpp>
#include <nipref/ref/nip/internal/chebyshev_system.hpp>
#include <nipref/ref/nip/internal/length_search.hpp>
#include <nipref/ref/nip/internal/proven_contact.hpp>
#include <nipref/ref/number/internal/bracketed_root.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/viscoelastic_nip/internal/proven_rolling.hpp>

namespace nipref::ref {
namespace {

using Intervals = std::vector<Interval>;

constexpr int most_points = 500;
constexpr double most_growth = 160;  ///< largest 2A (r_n + sum a_i)

Interval zero() { return Interval(working_bits()); }
Interval upper(const Interval& x) { return interval_of(upper_end(x)); }

/// The memory of the sheet in intervals: a_i, r_i of C = 1 + sum a_i/(D + r_i), and s_j, b_j of its inverse.
struct Memory {
  Intervals a, r, s, b;

  /// C at D = -s.
  [[nodiscard]] Interval compliance(const Interval& s_value) const {
    Interval sum(1L, working_bits());
    for (std::size_t i = 0; i < a.size(); ++i) sum = sum + a[i] / (r[i] - s_value);
    return sum;
  }
  /// 1/C(0) = 1 + sum b_j/s_j.
  [[nodiscard]] Interval stiffness() const {
    Interval sum(1L, working_bits());
    for (std::size_t j = 0; j < s.size(); ++j) sum = sum + b[j] / s[j];
    return sum;
  }
};

/// The zero of C(-s) between low and high, where C(-s) rises from -inf to a value > 0. Bisection approximates the zero;
/// the signs on both sides of the approximation prove it.
std::optional<Interval> zero_between(const Memory& memory, Float low, Float high) {
  const Float from = low, to = high;
  for (long step = 0; step < 2 * working_bits(); ++step) {
    const Float middle = (low + high) / 2;
    (middle_of(memory.compliance(interval_of(middle))) < Float(0) ? low : high) = middle;
  }
  return proven_bracket(high, ldexp(high, 8 - working_bits()), (to - from) / 4, 16, -1, [&](const Float& at) {
    return from < at && at < to ? sign_of(memory.compliance(interval_of(at))) : 0;
  });
}

std::optional<Memory> memory_of(const ProvenMemories& memories) {
  Memory memory;
  const auto widened = [share = Interval(memories.error, working_bits())](const mpq_class& near) {
    const Interval x(near, working_bits());
    return x.widened(x * share);
  };
  for (const ExactFunction::Term& term : memories.terms) {
    memory.a.push_back(widened(term.amplitude));
    memory.r.push_back(widened(term.rate));
  }
  Float all(0);
  for (const Interval& a : memory.a) all += upper_end(a);
  for (std::size_t j = 0; j < memory.a.size(); ++j) {
    const bool is_last = j + 1 == memory.a.size();
    // C(-s) > 0 from s = r_n + sum a_i on.
    const Float low = middle_of(memory.r[j]),
                high = is_last ? Float(upper_end(memory.r[j]) + 2 * all) : middle_of(memory.r[j + 1]);
    const auto s = zero_between(memory, low, high);
    if (!s) return std::nullopt;
    Interval slope = zero();
    for (std::size_t i = 0; i < memory.a.size(); ++i) slope = slope + memory.a[i] / square(memory.r[i] - *s);
    memory.s.push_back(*s);
    memory.b.push_back(-(1 / slope));
  }
  return memory;
}

/// e^{-z} I_m(z), m = 0 .. n, z >= 0, by their series. For k >= z each term is at most half of the one before.
Intervals scaled_bessel(const Interval& z, long n) {
  const Interval half = z / 2, fourth = square(half), factor = exp(-z);
  Interval first = factor;  // (z/2)^m/m!
  Intervals result;
  for (long m = 0; m <= n; ++m) {
    if (m > 0) first = first * half / m;
    Interval term = first, sum = first;
    const long terms = mpfr_get_si(z.upper(), MPFR_RNDU) + 2;
    const Float enough = ldexp(Float(1), -working_bits() - 16);
    for (long k = 1; k < terms || upper_end(term) > enough * upper_end(sum); ++k) {
      term = term * fourth / (k * (k + m));
      sum = sum + term;
      if (mpfr_zero_p(term.upper()) != 0) break;
    }
    result.push_back(sum.widened(term));
  }
  return result;
}

/// The right-hand side f_m of e^{-s x}, x = A (1 - t).
SlopeSeries exponential_series(const Interval& s, const Interval& half_length, int points) {
  const Intervals bessel = scaled_bessel(s * half_length, points);
  SlopeSeries series{{zero()}, 2 * magnitude_of(bessel.back())};
  for (int m = 1; m < points; ++m) series.coefficients.push_back(-(2 * bessel[static_cast<std::size_t>(m)]));
  return series;
}

/// The moments (1/pi) int_0^pi F cos(k theta), k = 0 .. N, of F = L ln(x) + S, x = A (1 - cos theta), S analytic.
class Moments {
 public:
  Moments(const ChebyshevSystem& system, const Interval& half_length)
      : cosines_(system.cosines()), half_length_(half_length), points_(2L * system.size()) {
    for (long i = 0; i < points_; ++i) places_.push_back(half_length * (1 - cosines_(2 * i + 1)));
    logarithms_.push_back(log(half_length / 2));
    for (long k = 1; k <= 2 * points_; ++k) logarithms_.push_back(Interval(-1L, working_bits()) / k);
  }

  [[nodiscard]] const Intervals& places() const { return places_; }
  [[nodiscard]] const Interval& half_length() const { return half_length_; }
  [[nodiscard]] long points() const { return points_; }

  /// The moments of S, whose Chebyshev coefficients are at most 2 bound e^{-l rate}.
  [[nodiscard]] Intervals smooth(const Intervals& values, const Interval& bound, const Interval& rate) const {
    const long n = points_;
    const Interval first = exp(-(n * rate)), missed = 2 * bound * first / (1 - first);
    Intervals moments;
    for (long k = 0; k <= n; ++k) {
      Interval sum = zero();
      for (long i = 0; i < n; ++i)
        sum = sum + values[static_cast<std::size_t>(i)] * cosines_(k * (2 * i + 1));
      moments.push_back((sum / n).widened(magnitude_of(missed)));
    }
    return moments;
  }
  /// The moments of ln(x) sum e_l cos(l theta). `left_out` bounds the sum of all |e_l| that are left out.
  [[nodiscard]] Intervals logarithmic(const Intervals& e, const Interval& left_out) const {
    Intervals moments;
    const Interval missed = magnitude_of(left_out) * (magnitude_of(logarithm(0)) + 1);
    for (long k = 0; k <= points_; ++k) {
      Interval sum = zero();
      for (long l = 0; l < static_cast<long>(e.size()); ++l)
        sum = sum + e[static_cast<std::size_t>(l)] * (logarithm(l + k) + logarithm(std::abs(l - k)));
      moments.push_back((sum / 2).widened(magnitude_of(missed)));
    }
    return moments;
  }

 private:
  [[nodiscard]] const Interval& logarithm(long k) const { return logarithms_[static_cast<std::size_t>(k)]; }

  const Cosines& cosines_;
  Interval half_length_;
  long points_;
  Intervals places_;
  Intervals logarithms_;  ///< the moments of ln(A (1 - cos theta))
};

/// The semi-axes A sinh(tau) and A cosh(tau) of an ellipse around the contact, for a rate tau.
struct Ellipse {
  Interval rate, height, width;

  Ellipse(const Interval& half_length, const Interval& tau)
      : rate(tau), height(half_length * sinh(tau)), width(half_length * cosh(tau)) {}
  /// The bound 1 + 2 |Re| + height Q(height) of |J| in the ellipse.
  [[nodiscard]] Interval smooth_kernel(const Interval& half_length) const {
    const Interval left = 2 - height;
    return 2 * (half_length + width) + height * (2 / left + 4 / square(left)) + 1;
  }
};

/// The moments of I1.
Intervals kernel_moments(const Moments& moments, SmoothKernel& kernel) {
  const Interval A = upper(moments.half_length());
  const Ellipse ellipse(A, entry_bounds(A, static_cast<int>(moments.points() / 2)).rate);
  Intervals values;
  for (const Interval& x : moments.places()) values.push_back(kernel.over(x));
  Intervals result = moments.smooth(values, ellipse.smooth_kernel(A), ellipse.rate);
  const Intervals logarithm = moments.logarithmic({Interval(-1L, working_bits())}, zero());
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = result[k] + logarithm[k];
  return result;
}

// The memory of I1 at the distance x from the leading end is M(x) = int_0^inf e^{-r w} I1(x + w) dw = E(x) ln(x) + S(x).
// As I1 = J - ln(x) with J analytic and M' = r M - I1, E is (e^{r x} - 1)/r, S analytic and S' = r S - J - E/x.

/// The factor E at x = A (1 - cos theta), a sum of e_l cos(l theta). `left_out` bounds the sum of all further |e_l|.
struct LogarithmFactor {
  Intervals coefficients;
  Interval left_out = zero();

  LogarithmFactor(bool rate_is_0, const Interval& r, const Interval& A, long n) {
    if (rate_is_0) {
      coefficients = {A, -A};  // E = x
      return;
    }
    const Intervals bessel = scaled_bessel(r * A, n);
    const Interval growth = exp(2 * (r * A));
    coefficients = {(growth * bessel[0] - 1) / r};
    for (long l = 1; l < n; ++l)
      coefficients.push_back((l % 2 == 0 ? 2 : -2) * (growth * bessel[static_cast<std::size_t>(l)] / r));
    left_out = 4 * growth * bessel.back() / r;
  }
};

/// S at x, computed at a number next to x. On the way to x it changes by |S'| <= |r S| + |J| + |E/x| times the distance,
/// with |J| <= 1 + 2 x and |E/x| <= e^{r x}. Within a distance d this bound grows by less than e^((2 r + 2) d), so that
/// twice its value in the middle of the interval x, which is as narrow as rounding makes it, is a bound in all of it.
Interval smooth_memory(const Interval& x, const mpq_class& rate, const Interval& r, double nats) {
  const Float near = middle_of(x);
  const Interval here = interval_of(near), growth = exp(r * here);
  const Interval E = rate == 0 ? here : (growth - 1) / r;
  const Interval S = steady_memory(Symbol::I1, to_exact(near), Exact(rate), nats) - log(here) * E;
  const Interval slope = 2 * (r * magnitude_of(S) + 1 + 2 * here + growth);
  return S.widened(magnitude_of(slope) * distance_from(near, x));
}

/// A bound for |S| in the ellipse. On the axis, 0 < x < 2A, it is |M| <= int_0^inf |I1| <= 4 plus |E ln(x)| <=
/// |x ln(x)| e^{r x}. From there a way of at most `way` leads to any place of the ellipse, on which S' bounds the growth,
/// with |E/x| <= e^{r |x|}.
Interval smooth_memory_bound(const Ellipse& ellipse, const Interval& r, const Interval& half_length) {
  const Interval way = ellipse.height + ellipse.width - half_length;
  const Interval far = exp(r * (half_length + ellipse.width)), two_A = 2 * half_length;
  const Interval log_size = larger_of(two_A * magnitude_of(log(two_A)), Interval(1L, working_bits()));
  const Interval on_axis = log_size * exp(r * two_A) + 4;
  return exp(r * way) * (on_axis + way * (ellipse.smooth_kernel(half_length) + far));
}

/// The moments of M. A relative error `share` of the rate changes M by at most twice that error: ref/memory/README.md, What
/// a displacement changes by, with int_0^inf |I1| <= 4.
Intervals memory_moments(const Moments& moments, const mpq_class& rate, const Interval& share, double nats) {
  const Interval r = Interval(rate, working_bits()), top = upper(moments.half_length());
  const long n = moments.points();
  Intervals values;
  for (const Interval& x : moments.places()) values.push_back(smooth_memory(x, rate, r, nats));
  const Interval tau = entry_bounds(top, static_cast<int>(n / 2)).rate, most_tau(1.5, working_bits());
  const Ellipse ellipse(top, mpfr_less_p(tau.lower(), most_tau.lower()) != 0 ? tau : most_tau);
  Intervals result = moments.smooth(values, smooth_memory_bound(ellipse, r, top), ellipse.rate);
  const LogarithmFactor factor(rate == 0, r, moments.half_length(), n);
  const Intervals logarithm = moments.logarithmic(factor.coefficients, factor.left_out);
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = (result[k] + logarithm[k]).widened(2 * share);
  return result;
}

/// F_i = int_0^inf e^{-r_i w} f'(-w) dw/(2A^2) of a column by the moments of M_i, which are at most 4 in magnitude.
Interval memory_functional(const BoundedColumn& column, const Intervals& moments) {
  Interval sum = zero();
  for (std::size_t m = 1; m < column.coefficients.size(); ++m)
    sum = sum + static_cast<long>(m) * (column.coefficients[m] * moments[m]);
  return (-sum).widened(magnitude_of(4 * column.radius));
}

/// Solves a small system by elimination; nothing if a pivot may be 0.
std::optional<Intervals> eliminated(std::vector<Intervals> rows) {
  const std::size_t n = rows.size();
  for (std::size_t k = 0; k < n; ++k) {
    const auto pivot = std::max_element(
        rows.begin() + static_cast<std::ptrdiff_t>(k), rows.end(),
        [&](const Intervals& x, const Intervals& y) { return abs(middle_of(x[k])) < abs(middle_of(y[k])); });
    std::swap(rows[k], *pivot);
    if (mpfi_has_zero(rows[k][k].get()) > 0) return std::nullopt;
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const Interval factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] = rows[i][j] - factor * rows[k][j];
    }
  }
  Intervals solution;
  for (std::size_t k = 0; k < n; ++k) solution.push_back(rows[k][n] / rows[k][k]);
  return solution;
}

double largest_growth(const ProvenMemories& memories, double half_length) {
  double rate = 0;
  for (const ExactFunction::Term& term : memories.terms) rate += term.amplitude.get_d();
  if (!memories.terms.empty()) rate += memories.terms.back().rate.get_d();
  return 2 * rate * half_length;
}

/// Digits that are lost to slow memories, because their exponentials are nearly lines.
double digits_of_slowness(const ProvenMemories& memories, double half_length) {
  double digits = 0;
  for (const ExactFunction::Term& term : memories.terms) {
    const double rate = mpq_class(term.rate + term.amplitude).get_d() * half_length;
    digits += 2 * std::max(0.0, -std::log10(rate));
  }
  return digits;
}

/// The digits of the expansion and of the kernels.
int expansion_digits(const ProvenMemories& memories, double half_length, int digits) {
  return digits + 8 +
         static_cast<int>(digits_of_slowness(memories, half_length) + 2 * std::log10(1 + half_length));
}

struct RollingPlan {
  int expansion_digits, size;  ///< of the columns
  double nats;                 ///< of the memories' integrals
};

/// Nothing if the contact is too long or a memory too fast.
std::optional<RollingPlan> plan_of(const ProvenMemories& memories, double half_length, int digits) {
  const double growth = largest_growth(memories, half_length);
  if (growth > most_growth) return std::nullopt;
  const int expansion = expansion_digits(memories, half_length, digits);
  const double nats = (expansion + 4) * std::numbers::ln10;
  const double decay = std::min(1.5, std::asinh(1.9 / half_length));
  const double points =
      std::max({2.0 * size_for(half_length, expansion), (nats + 4 * growth) / decay, growth + 4});
  if (points > most_points) return std::nullopt;
  return RollingPlan{expansion, static_cast<int>(points / 2 + 1), nats};
}

/// The rolling contact as a sum of the columns, which belong to q_0 and to each q_j, with Gamma and eta_j as factors.
struct RollingSum {
  Intervals factors;
  Interval offset;  ///< omega = o/A
};
using Columns = std::vector<BoundedColumn>;

/// Solves the equations of the eta_j and that of the constants, which come last. `ahead` has the F_i of all columns.
std::optional<RollingSum> solved_sum(const Memory& memory, const Interval& A, const Columns& columns,
                                     const std::vector<Intervals>& ahead) {
  const std::size_t n = memory.s.size(), offset = n, right_side = n + 1;  // in each row, after the eta_j
  const Interval Gamma = memory.stiffness();
  std::vector<Intervals> rows(n + 1, Intervals(n + 2, zero()));
  Intervals& constants = rows.back();
  for (std::size_t j = 0; j < n; ++j) {
    const Interval &s = memory.s[j], &b = memory.b[j];
    Intervals& row = rows[j];
    for (std::size_t i = 0; i < n; ++i) {
      const Interval factor = b * memory.a[i] / (s - memory.r[i]);
      for (std::size_t k = 0; k < n; ++k) row[k] = row[k] - factor * ahead[i][k + 1];
      row[right_side] = row[right_side] + factor * Gamma * ahead[i][0];
    }
    row[j] = row[j] + 1;
    row[offset] = -(b / s);
    row[right_side] = row[right_side] + b * (1 / s + 1 / (A * square(s)));
    const Interval mean = scaled_bessel(s * A, 0).front();
    constants[j] = columns[j + 1].constant - mean;
    constants[right_side] = constants[right_side] - b / (A * square(s));
  }
  constants[offset] = Gamma;
  constants[right_side] = constants[right_side] - Gamma * columns[0].constant;
  const std::optional<Intervals> unknowns = eliminated(std::move(rows));
  if (!unknowns) return std::nullopt;
  RollingSum sum{{Gamma}, (*unknowns)[offset]};
  sum.factors.insert(sum.factors.end(), unknowns->begin(), unknowns->end() - 1);
  return sum;
}

ProvenExpansion pressure_of(const RollingSum& sum, const Columns& columns, const Interval& A) {
  ProvenExpansion pressure{A, Intervals(columns[0].coefficients.size(), zero()), zero(), zero(), zero()};
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const Interval &factor = sum.factors[k], size = magnitude_of(factor);
    for (std::size_t m = 1; m < pressure.coefficients.size(); ++m)
      pressure.coefficients[m] = pressure.coefficients[m] + factor * columns[k].coefficients[m];
    pressure.radius = pressure.radius + size * columns[k].radius;
    pressure.energy_radius = pressure.energy_radius + size * columns[k].energy_radius;
  }
  return pressure;
}

/// d1 = (A/pi) int (I1 + sum a_i M_i) p, by the moments of I1 and those of each M_i.
Interval edge_displacement_of(const ProvenExpansion& pressure, const Memory& memory, Intervals moments,
                              const std::vector<Intervals>& of_memories) {
  Interval largest = magnitude_of(log(pressure.half_length / 2)) + 5;
  for (std::size_t i = 0; i < of_memories.size(); ++i) {
    for (std::size_t k = 0; k < moments.size(); ++k)
      moments[k] = moments[k] + memory.a[i] * of_memories[i][k];
    largest = largest + 4 * magnitude_of(memory.a[i]);
  }
  Interval sum = zero();
  for (std::size_t m = 1; m < pressure.coefficients.size(); ++m)
    sum = sum + pressure.coefficients[m] * (moments[m - 1] - moments[m + 1]);
  return square(pressure.half_length) * sum.widened(magnitude_of(2 * largest * pressure.radius));
}

}  // namespace

std::optional<ProvenMemories> proven_memories(const data::ViscoelasticNip& nip) try {
  constexpr mpfr_prec_t bits = 512;
  const NearMaterial near = with_given_rates(exact_material(nip.material), bits);
  const ExactFunction normal = near.material.normal();
  ProvenMemories result{{}, near.memory_error, normal.instantaneous};
  const mpq_class ways = mpq_class(nip.sheet_thickness) / 2 / mpq_class(nip.speed);
  for (const ExactFunction::Term& term : normal.terms) {
    if (sgn(term.amplitude) == 0) continue;
    if (sgn(term.amplitude) < 0 || sgn(term.rate) < 0) return std::nullopt;
    result.terms.push_back({term.amplitude * ways / normal.instantaneous, term.rate * ways});
  }
  std::ranges::sort(result.terms, {}, &ExactFunction::Term::rate);
  return result;
} catch (const data::BadInput&) {  // complex rates
  return std::nullopt;
}

int proven_rolling_working_digits(const ProvenMemories& memories, double half_length, int digits) {
  // Fast memories have large exponentials.
  const double lost =
      digits_of_slowness(memories, half_length) + largest_growth(memories, half_length) / std::numbers::ln10;
  return expansion_digits(memories, half_length, digits) + static_cast<int>(lost) + 20;
}

std::optional<ProvenContact> proven_rolling(const ProvenMemories& memories, const Interval& A, int digits) {
  const std::optional<RollingPlan> plan = plan_of(memories, static_cast<double>(middle_of(A)), digits);
  if (!plan) return std::nullopt;
  const std::optional<Memory> memory = memory_of(memories);
  if (!memory) return std::nullopt;
  SmoothKernel kernel(I1_interval, plan->expansion_digits + 6);
  const ChebyshevSystem system(middle_of(A), plan->size, kernel, true);
  const Moments moments(system, A);

  std::vector<SlopeSeries> right_sides{SlopeSeries::line(plan->size)};
  for (const Interval& s : memory->s) right_sides.push_back(exponential_series(s, A, 2 * plan->size));
  Columns columns;
  for (const SlopeSeries& right : right_sides)
    columns.push_back(system.proven(system.solution(right), right, A));

  const Interval share(memories.error, working_bits());
  std::vector<Intervals> of_memories, ahead;
  for (const ExactFunction::Term& term : memories.terms) {
    of_memories.push_back(memory_moments(moments, term.rate, share, plan->nats));
    Intervals& of_columns = ahead.emplace_back();
    for (const BoundedColumn& column : columns)
      of_columns.push_back(memory_functional(column, of_memories.back()));
  }

  const std::optional<RollingSum> sum = solved_sum(*memory, A, columns, ahead);
  if (!sum) return std::nullopt;
  ProvenExpansion pressure = pressure_of(*sum, columns, A);
  const Interval edge_displacement =
      edge_displacement_of(pressure, *memory, kernel_moments(moments, kernel), of_memories);
  return ProvenContact(std::move(pressure), A * sum->offset, edge_displacement);
}

std::optional<ProvenContact> proven_rolling_for_load(const ProvenMemories& memories, const Exact& load,
                                                     const Float& near, const Float& growth, int digits) {
  constexpr int spare_digits = 10;  // of the half length
  LengthSearch search{
      .load = load, .length = near, .exponent = growth, .exponent_error = pow(Float(10), -digits)};
  return search.contact_carrying(digits + spare_digits, [&](const Lengths& half_lengths) {
    return proven_rolling(memories, half_lengths.interval(), digits + spare_digits / 2);
  });
}

}  // namespace nipref::ref
