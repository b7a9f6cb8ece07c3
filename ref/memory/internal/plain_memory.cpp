#include <memory>
#include <tuple>
#include <vector>

#include <nipref/ref/memory/internal/plain_memory.hpp>
#include <nipref/ref/number/internal/cache.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/sheet/internal/plain_terms.hpp>

namespace nipref::ref {
namespace {

using Waves = std::vector<ComplexInterval>;

/// Of the roots, |z_n| x < 2^21.
constexpr mpfr_prec_t spare_bits = 48;

std::size_t size_of_waves(const Waves& waves) {
  return waves.empty() ? 0 : waves.size() * (sizeof(ComplexInterval) + waves.size());
}

/// The key of the waves e^{i z_n x} at x >= 0 that are not negligible.
struct WaveKey {
  mpq_class x;
  int terms;
  mpfr_prec_t precision;

  friend bool operator<(const WaveKey& a, const WaveKey& b) {
    return std::tie(a.terms, a.precision, a.x) < std::tie(b.terms, b.precision, b.x);
  }
};

Waves make_waves(const WaveKey& key) {
  const mpfr_prec_t more = key.precision + spare_bits;
  const Interval place(Exact(key.x), more);
  Interval rest(key.precision);
  Waves waves;
  for (int n = 1; n <= key.terms && !is_negligible(n, place, key.precision, rest); ++n) {
    const ComplexInterval z = rounded(sheet_pole(n, more)->z, more);
    waves.push_back(rounded(exp(ComplexInterval{-(place * z.imag), place * z.real}), key.precision));
  }
  return waves;
}

std::shared_ptr<const Waves> waves_at(const Exact& x, int terms, mpfr_prec_t precision) {
  static Cache<WaveKey, Waves> kept(make_waves, size_of_waves, std::size_t{1} << 27);
  return kept.at({x.value(), terms, precision});
}

struct FadeKey {
  PlainKernel kernel;
  int side;  ///< 1 ahead of the load, -1 behind it; 0: no memory
  mpq_class rate;
  int terms;
  mpfr_prec_t precision;

  friend bool operator<(const FadeKey& a, const FadeKey& b) {
    return std::tie(a.kernel, a.side, a.terms, a.precision, a.rate) <
           std::tie(b.kernel, b.side, b.terms, b.precision, b.rate);
  }
};

/// C/(rate - i z), behind the load C/(rate + i z), without memory C, over pi: C is i pi c of an even kernel, pi c of an odd one.
Waves make_fades(const FadeKey& key) {
  const Interval rate(Exact(key.rate), key.precision);
  Waves fades;
  for (int n = 1; n <= key.terms; ++n) {
    const auto pole = sheet_pole(n, key.precision + spare_bits);
    const ComplexInterval c = plain_coefficient(key.kernel, *pole);
    fades.push_back(is_odd(key.kernel) ? c : ComplexInterval{-c.imag, c.real});
    const auto side = static_cast<long>(key.side);
    if (side != 0)
      fades.back() = fades.back() * inverse({rate + side * pole->z.imag, -(side * pole->z.real)});
  }
  return fades;
}

/// The sum at x >= 0, without the kernel's constant.
Interval wave_sum(PlainKernel kernel, const Exact& x, int side, const Exact& rate, int terms,
                  mpfr_prec_t precision) {
  static Cache<FadeKey, Waves> kept(make_fades, size_of_waves, std::size_t{1} << 26);
  const auto waves = waves_at(x, terms, precision);
  const auto fades = kept.at({kernel, side, rate.value(), terms, precision});
  Interval sum(precision);
  for (std::size_t n = 0; n < waves->size(); ++n) {
    const ComplexInterval &wave = (*waves)[n], &by = (*fades)[n];
    sum = sum + (by.real * wave.real - by.imag * wave.imag);
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
  const auto sum = [&](const Exact& x, int side) {
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
