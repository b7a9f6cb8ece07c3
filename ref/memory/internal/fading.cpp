#include <algorithm>
#include <climits>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <tuple>
#include <vector>

#include <nipref/ref/memory/internal/fading.hpp>
#include <nipref/ref/number/internal/cache.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/sheet/internal/residues.hpp>

namespace nipref::ref {
namespace {

/// The parameters of a block of nodes t = j h on the path z = sinh(t + i angle). Blocks are cached; all load positions
/// and rates with the same key share them.
struct ContourKey {
  Symbol kernel;
  double angle;
  double step;       ///< h, of so few significant bits that j h is exact
  mpfr_prec_t bits;  ///< precision of the intervals
  long block;        ///< the block begins with the node j = nodes_in_block block

  auto operator<=>(const ContourKey&) const = default;
};

constexpr long nodes_in_block = 32;

struct ContourNode {
  ComplexInterval z;
  ComplexInterval weight;  ///< G(z) dz/dt, G the kernel's whole symbol
};

using ContourNodes = std::vector<ContourNode>;

constexpr mpfr_prec_t guard_bits = 32;

/// G(z) with E = e^{-z} and D = 1 - E^4 + 4 z E^2 = 2 E^2 S:
///   I1: (1 - E^2)^2/(z D), I3: 4 E^2/D, I4: 2 E (1 - E^2)/(z D), I5: 2 E (1 + E^2)/D
ComplexInterval whole_symbol(Symbol kernel, const ComplexInterval& z) {
  const mpfr_prec_t precision = z.re.precision();
  const ComplexInterval e = exp(-z), square = e * e, one(Interval(1L, precision)), twice = e + e;
  const ComplexInterval fourfold = Interval(4L, precision) * square,
                        over_d = inverse(one - square * square + z * fourfold);
  switch (kernel) {
    case Symbol::I3:
      return fourfold * over_d;
    case Symbol::I4:
      return twice * (one - square) * over_d * inverse(z);
    case Symbol::I5:
      return twice * (one + square) * over_d;
    default:
      return (one - square) * (one - square) * over_d * inverse(z);
  }
}

ContourNodes make_contour_nodes(const ContourKey& key) {
  const mpfr_prec_t more = key.bits + guard_bits;
  const Interval angle(key.angle, more), cosine = cos(angle), sine = sin(angle);
  ContourNodes nodes;
  for (long j = key.block * nodes_in_block; j < (key.block + 1) * nodes_in_block; ++j) {
    const Interval t(static_cast<double>(j) * key.step, more), large = cosh(t), small = sinh(t);
    const ComplexInterval z{small * cosine, large * sine}, slope{large * cosine, small * sine};
    nodes.push_back({rounded(z, key.bits), rounded(whole_symbol(key.kernel, z) * slope, key.bits)});
  }
  return nodes;
}

std::size_t size_in_bytes(const ContourNodes& nodes) {
  constexpr std::size_t numbers = 8;  // both ends of the parts of z and of the weight
  const auto bits = static_cast<std::size_t>(nodes.front().z.re.precision());
  return nodes.size() * (sizeof(ContourNode) + numbers * bits / CHAR_BIT);
}

/// The nodes of a block, computed at the first call and then cached.
std::shared_ptr<const ContourNodes> contour_nodes(const ContourKey& key) {
  static Cache<ContourKey, ContourNodes> kept(make_contour_nodes, size_in_bytes);
  return kept.at(key);
}

/// The t at which Re z = 2 on the highest path, rounded up.
constexpr double beyond_two = 1.75;

/// A lower bound of q(t) = k t + r Re z + A Im z; the integrand is at most a constant times e^{-q(t)}.
double nats_of_integrand(Symbol kernel, double distance, double angle, double t) {
  const double symbol = is_odd(kernel) ? bounds(kernel).decay * std::cos(angle) * std::sinh(t) : t;
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

ComplexInterval times_i(const ComplexInterval& z) { return {-z.im, z.re}; }
ComplexInterval over_i(const ComplexInterval& z) { return {z.im, -z.re}; }

bool is_real(const ComplexInterval& z) { return mpfi_is_zero(z.im.get()) > 0; }

/// U(A, m) of ref/memory/README.md, The memory of a load from infinity.
ComplexInterval along_path(Symbol kernel, const Exact& distance, const ComplexInterval& rate,
                           const MemoryStrip& strip, double nats) {
  const double step = of_few_bits(2 * std::numbers::pi * strip.half_width / (nats + 10), 4);
  const long last = last_node(kernel, distance.approximate(), strip.angle, step, nats);
  const mpfr_prec_t bits = working_precision(nats + 12, distance.approximate());
  const Interval A(distance, bits);
  const ComplexInterval m = rounded(rate, bits);
  // The sum over t >= 0, and the conjugate of the sum over t <= 0, which is equal if m is real. Each has half of t = 0.
  ComplexInterval right{Interval(bits), Interval(bits)}, left = right;
  ContourKey key{kernel, strip.angle, step, bits, 0};
  for (; key.block * nodes_in_block <= last; ++key.block) {
    const auto nodes = contour_nodes(key);
    const long first = key.block * nodes_in_block;
    for (long k = 0; k < std::min(nodes_in_block, last + 1 - first); ++k) {
      const ContourNode& node = (*nodes)[static_cast<std::size_t>(k)];
      const ComplexInterval turn = times_i(node.z), wave = node.weight * exp(A * turn);
      const bool is_first = first + k == 0;
      const auto add = [&](const ComplexInterval& pole, ComplexInterval& sum) {
        const ComplexInterval term = wave * inverse(pole - turn);
        sum = sum + (is_first ? Interval(0.5, bits) * term : term);
      };
      add(m, right);
      if (!is_real(m)) add(conj(m), left);
    }
  }
  const ComplexInterval mirrored = conj(is_real(m) ? right : left);
  const ComplexInterval integral =
      Interval(step / 2, bits) * (is_odd(kernel) ? over_i(right - mirrored) : right + mirrored);
  const Interval left_out = exp(Interval(-nats, 64));
  return {integral.re.widened(left_out), integral.im.widened(left_out)};
}

/// P = pi G(i L) e^{-L A}, for odd kernels times i. By its parity, G is evaluated where Re z >= 0 and e^{-z} is small.
ComplexInterval whole_line(Symbol kernel, const ComplexInterval& rate, const Exact& distance) {
  const mpfr_prec_t bits = rate.re.precision();
  const bool is_mirrored = mpfr_sgn(rate.im.upper()) > 0;
  const ComplexInterval z = is_mirrored ? over_i(rate) : times_i(rate),
                        symbol = Interval::pi(bits) *
                                 (whole_symbol(kernel, z) * exp(-(Interval(distance, bits) * rate)));
  if (!is_odd(kernel)) return symbol;
  return is_mirrored ? over_i(symbol) : times_i(symbol);
}

/// The angle psi of the pole i L, reflected to Re z >= 0.
double angle_of_pole(const ComplexInterval& rate) {
  const std::complex<double> pole(std::fabs(mpfr_get_d(rate.im.lower(), MPFR_RNDN)),
                                  mpfr_get_d(rate.re.lower(), MPFR_RNDN));
  return std::asinh(pole).imag();
}

}  // namespace

bool is_zero(const ComplexInterval& rate) { return is_real(rate) && mpfi_is_zero(rate.re.get()) > 0; }

ComplexInterval rate_interval(const Exact& rate, double nats) {
  const double of_rate = rate.sign() == 0 ? 0 : std::fabs(rate.log2_magnitude()) * std::numbers::ln2;
  const mpfr_prec_t bits = working_precision(std::max(nats, 40.0) + of_rate, 1000);
  return {Interval(rate, bits), Interval(bits)};
}

MemoryStrip strip_beside(double pole) {
  if (pole <= 0 || pole >= 1) return {1.0 / 2, 7.0 / 16};
  return {pole < 0.5 ? 3.0 / 4 : 1.0 / 4, 3.0 / 16};
}

ComplexInterval steady_memory(Symbol kernel, const Exact& alpha, const ComplexInterval& rate, double nats) {
  const bool odd = is_odd(kernel), ahead = alpha.sign() >= 0;
  const Exact distance = alpha.magnitude();
  const mpfr_prec_t bits = std::max(rate.re.precision(), working_precision(nats, 1000));
  const Interval quarter = Interval::pi(bits) / 4;
  const bool by_residues = is_real(rate) && distance.value() >= 1;
  const double pole = ahead ? 0 : angle_of_pole(rate);
  const MemoryStrip strip = strip_beside(pole);
  // Behind the load there is P, except where the pole is above the path: its residue would then cancel P.
  const bool has_whole_line = !ahead && (by_residues || pole < strip.angle);
  const auto along_one_side = [&]() -> ComplexInterval {
    if (by_residues) return {fading_residue_series(kernel, alpha, rate.re, nats), Interval(bits)};
    const ComplexInterval u = along_path(kernel, distance, ahead ? rate : -rate, strip, nats);
    return ahead || odd ? u : -u;
  };
  const ComplexInterval sum = along_one_side();
  if (is_zero(rate)) {
    // The limits of P and of pi/(4 L), without the infinite part.
    const Interval rest = odd ? -(quarter * Interval(distance, bits)) : 2 * quarter;
    return odd || has_whole_line ? ComplexInterval{sum.re + rest, sum.im} : sum;
  }
  const ComplexInterval memory = has_whole_line ? sum + whole_line(kernel, rate, distance) : sum;
  if (!odd) return memory;
  const ComplexInterval at_origin = quarter * inverse(rate);
  return ahead ? memory + at_origin : memory - at_origin;
}

Interval steady_memory(Symbol kernel, const Exact& alpha, const Exact& rate, double nats) {
  return steady_memory(kernel, alpha, rate_interval(rate, nats), nats).re;
}

namespace {

using Waves = std::vector<ComplexInterval>;

/// Bits of the roots beyond those of the waves e^{i z_n x}, where |z_n| x < 2^21.
constexpr mpfr_prec_t spare_bits = 48;

std::size_t size_of_waves(const Waves& waves) {
  return waves.empty() ? 0 : waves.size() * (sizeof(ComplexInterval) + waves.size());
}

/// The key of waves: number of terms, precision and x.
using WaveKey = std::tuple<int, mpfr_prec_t, mpq_class>;

/// The waves e^{i z_n x} at x >= 0 that are not negligible.
Waves make_waves(const WaveKey& key) {
  const auto& [terms, precision, x] = key;
  const mpfr_prec_t more = precision + spare_bits;
  const Interval place(x, more);
  Interval rest(precision);
  Waves waves;
  for (int n = 1; n <= terms && !is_negligible(n, place, precision, rest); ++n) {
    const ComplexInterval z = rounded(sheet_pole(n, more)->z, more);
    waves.push_back(rounded(exp(ComplexInterval{-(place * z.im), place * z.re}), precision));
  }
  return waves;
}

/// The side of the load on which the waves are remembered; no_memory for the kernel itself.
enum WaveSide : long { behind_load = -1, no_memory = 0, ahead_of_load = 1 };

/// The key of factors: kernel, side, number of terms, precision and rate.
using FadeKey = std::tuple<PlainKernel, WaveSide, int, mpfr_prec_t, mpq_class>;

/// The factors of the waves over pi: C/(rate - i z) ahead of the load, C/(rate + i z) behind it, C without memory. With
/// the coefficient c of a root, C = i pi c for an even kernel and C = pi c for an odd one.
Waves make_fades(const FadeKey& key) {
  const auto& [kernel, side, terms, precision, exact_rate] = key;
  const Interval rate(exact_rate, precision);
  Waves fades;
  for (int n = 1; n <= terms; ++n) {
    const auto pole = sheet_pole(n, precision + spare_bits);
    const ComplexInterval c = plain_coefficient(kernel, *pole);
    fades.push_back(is_odd(kernel) ? c : ComplexInterval{-c.im, c.re});
    if (side != no_memory)
      fades.back() = fades.back() * inverse({rate + side * pole->z.im, -(side * pole->z.re)});
  }
  return fades;
}

/// The sum over the waves at x >= 0, without the kernel's constant.
Interval wave_sum(PlainKernel kernel, const Exact& x, WaveSide side, const Exact& rate, int terms,
                  mpfr_prec_t precision) {
  static Cache<WaveKey, Waves> kept_waves(make_waves, size_of_waves, std::size_t{1} << 27);
  static Cache<FadeKey, Waves> kept_fades(make_fades, size_of_waves, std::size_t{1} << 26);
  const auto waves = kept_waves.at({terms, precision, x.value()});
  const auto fades = kept_fades.at({kernel, side, terms, precision, rate.value()});
  Interval sum(precision);
  for (std::size_t n = 0; n < waves->size(); ++n) {
    const ComplexInterval &wave = (*waves)[n], &by = (*fades)[n];
    sum = sum + (by.re * wave.re - by.im * wave.im);
  }
  const auto left = static_cast<int>(waves->size()) + 1;
  Interval rest(precision);
  // The bound holds with memory, too, as |rate -+ i z| >= Re z > 1.
  if (left <= terms && is_negligible(left, Interval(x, precision), precision, rest)) sum = sum.widened(rest);
  return Interval::pi(precision) * sum;
}

mpfr_prec_t precision_of(double nats) { return working_precision(nats, 1) + 64; }

Interval constant_of(PlainKernel kernel, mpfr_prec_t precision) {
  return is_odd(kernel) ? Interval::pi(precision) / 4 : Interval(precision);
}

}  // namespace

Interval plain_kernel_at(PlainKernel kernel, const Exact& alpha, int terms, double nats) {
  check_residue_terms(terms);
  const mpfr_prec_t precision = precision_of(nats);
  const Interval value = wave_sum(kernel, alpha.magnitude(), no_memory, Exact(0.0), terms, precision) +
                         constant_of(kernel, precision);
  return is_odd(kernel) && alpha.sign() < 0 ? -value : value;
}

Interval plain_memory(PlainKernel kernel, const Exact& alpha, const Exact& exact_rate, int terms,
                      double nats) {
  check_residue_terms(terms);
  const mpfr_prec_t precision = precision_of(nats);
  const Interval rate(exact_rate, precision), constant = constant_of(kernel, precision);
  const auto sum = [&](const Exact& x, WaveSide side) {
    return wave_sum(kernel, x, side, exact_rate, terms, precision);
  };
  const Exact x = alpha.magnitude(), at_load(0.0);
  if (alpha.sign() >= 0) return sum(x, ahead_of_load) + constant / rate;
  const Interval faded = exp(-(rate * Interval(x, precision)));
  // The integral ahead of the load is faded * from_load. The one from alpha to the load is from_point - faded * beyond
  // for even kernels, and minus that for odd ones.
  const Interval from_load = sum(at_load, ahead_of_load), beyond = sum(at_load, behind_load);
  const Interval from_point = sum(x, behind_load);
  const Interval waves =
      is_odd(kernel) ? faded * (from_load + beyond) - from_point : faded * (from_load - beyond) + from_point;
  return waves + constant * (2 * faded - 1) / rate;
}

}  // namespace nipref::ref
