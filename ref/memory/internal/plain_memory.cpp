#include <tuple>
#include <vector>

#include <nipref/ref/memory/internal/plain_memory.hpp>
#include <nipref/ref/number/internal/cache.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/sheet/internal/residues.hpp>

namespace nipref::ref {
namespace {

using Waves = std::vector<ComplexInterval>;

/// Of the roots, |z_n| x < 2^21.
constexpr mpfr_prec_t spare_bits = 48;

std::size_t size_of_waves(const Waves& waves) {
  return waves.empty() ? 0 : waves.size() * (sizeof(ComplexInterval) + waves.size());
}

/// Number of terms, precision and x.
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

/// The kernel, the side (1 ahead of the load, -1 behind it; 0: no memory), number of terms, precision and rate.
using FadeKey = std::tuple<PlainKernel, long, int, mpfr_prec_t, mpq_class>;

/// C/(rate - i z), behind the load C/(rate + i z), without memory C, over pi: C is i pi c of an even kernel, pi c of an odd one.
Waves make_fades(const FadeKey& key) {
  const auto& [kernel, side, terms, precision, exact_rate] = key;
  const Interval rate(exact_rate, precision);
  Waves fades;
  for (int n = 1; n <= terms; ++n) {
    const auto pole = sheet_pole(n, precision + spare_bits);
    const ComplexInterval c = plain_coefficient(kernel, *pole);
    fades.push_back(is_odd(kernel) ? c : ComplexInterval{-c.im, c.re});
    if (side != 0) fades.back() = fades.back() * inverse({rate + side * pole->z.im, -(side * pole->z.re)});
  }
  return fades;
}

/// The sum at x >= 0, without the kernel's constant.
Interval wave_sum(PlainKernel kernel, const Exact& x, long side, const Exact& rate, int terms,
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
  // |rate -+ i z| >= Re z > 1
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
  const Interval value =
      wave_sum(kernel, alpha.magnitude(), 0, Exact(0.0), terms, precision) + constant_of(kernel, precision);
  return is_odd(kernel) && alpha.sign() < 0 ? -value : value;
}

Interval plain_memory(PlainKernel kernel, const Exact& alpha, const Exact& exact_rate, int terms,
                      double nats) {
  check_residue_terms(terms);
  const mpfr_prec_t precision = precision_of(nats);
  const Interval rate(exact_rate, precision), constant = constant_of(kernel, precision);
  const auto sum = [&](const Exact& x, long side) {
    return wave_sum(kernel, x, side, exact_rate, terms, precision);
  };
  const Exact x = alpha.magnitude(), at_load(0.0);
  if (alpha.sign() >= 0) return sum(x, 1) + constant / rate;
  const Interval faded = exp(-(rate * Interval(x, precision)));
  const Interval passed = sum(at_load, 1), coming = sum(at_load, -1);
  const Interval behind = sum(x, -1);
  const Interval waves =
      is_odd(kernel) ? faded * (passed + coming) - behind : faded * (passed - coming) + behind;
  return waves + constant * (2 * faded - 1) / rate;
}

}  // namespace nipref::ref
