#include <memory>
#include <tuple>
#include <vector>

#include <nipref/ref/memory/internal/plain_memory.hpp>
#include <nipref/ref/number/internal/cache.hpp>
#include <nipref/ref/number/internal/complex.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/sheet/internal/plain_terms.hpp>

namespace nipref::ref {
namespace {

using Waves = std::vector<ComplexInterval>;

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

/// A wave to the precision: z_n has 30 bits more, |z_n| x < 2^21, and no wave exceeds 1.
ComplexInterval wave(const PlainTerm& term, const Exact& x, mpfr_prec_t precision) {
  constexpr mpfr_prec_t spare_bits = 40, lost_bits = 8;
  Float middle = zero_of_bits(precision + spare_bits), way = zero_of_bits(precision + spare_bits);
  Complex value(precision + spare_bits);
  mpfr_set_q(raw(way), x.value().get_mpq_t(), MPFR_RNDN);
  mpfi_mid(raw(middle), term.z.imag.get());
  mpfr_mul(mpc_realref(value.get()), raw(middle), raw(way), MPFR_RNDN);
  mpfr_neg(mpc_realref(value.get()), mpc_realref(value.get()), MPFR_RNDN);
  mpfi_mid(raw(middle), term.z.real.get());
  mpfr_mul(mpc_imagref(value.get()), raw(middle), raw(way), MPFR_RNDN);
  mpc_exp(value.get(), value.get(), MPC_RNDNN);
  Interval error(1L, 64);
  mpfi_mul_2si(error.get(), error.get(), lost_bits - precision);
  const auto around = [&](mpfr_srcptr part) {
    Interval result(precision);
    mpfi_set_fr(result.get(), part);
    return result.widened(error);
  };
  return {around(mpc_realref(value.get())), around(mpc_imagref(value.get()))};
}

Waves make_waves(const WaveKey& key) {
  const Exact x(key.x);
  const Interval place(x, key.precision);
  Interval rest(key.precision);
  Waves waves;
  for (int n = 1; n <= key.terms && !is_negligible(n, place, key.precision, rest); ++n)
    waves.push_back(wave(*plain_term(n, key.precision + 48), x, key.precision));
  return waves;
}

std::shared_ptr<const Waves> waves_at(const Exact& x, int terms, mpfr_prec_t precision) {
  static Cache<WaveKey, Waves> kept(make_waves, size_of_waves, std::size_t{1} << 27);
  return kept.at({x.value(), terms, precision});
}

/// The factor of the waves: 1, 1/(rate - i z) or 1/(rate + i z).
enum class Fade { none, ahead, behind };

struct FadeKey {
  PlainKernel kernel;
  Fade fade;
  mpq_class rate;
  int terms;
  mpfr_prec_t precision;

  friend bool operator<(const FadeKey& a, const FadeKey& b) {
    return std::tie(a.kernel, a.fade, a.terms, a.precision, a.rate) <
           std::tie(b.kernel, b.fade, b.terms, b.precision, b.rate);
  }
};

/// C, C/(rate - i z) or C/(rate + i z), over pi: C is i pi c of an even kernel, pi c of an odd one.
Waves make_fades(const FadeKey& key) {
  const Interval rate(Exact(key.rate), key.precision);
  Waves fades;
  for (int n = 1; n <= key.terms; ++n) {
    const auto term = plain_term(n, key.precision + 48);
    const ComplexInterval& c = term->coefficient(key.kernel);
    const ComplexInterval over_pi = is_odd(key.kernel) ? c : ComplexInterval{-c.imag, c.real};
    if (key.fade == Fade::none) {
      fades.push_back(over_pi);
    } else if (key.fade == Fade::ahead) {
      fades.push_back(over_pi * reciprocal({rate + term->z.imag, -term->z.real}));
    } else {
      fades.push_back(over_pi * reciprocal({rate - term->z.imag, term->z.real}));
    }
  }
  return fades;
}

/// The sum at x >= 0, without the kernel's constant.
Interval wave_sum(PlainKernel kernel, const Exact& x, Fade fade, const Exact& rate, int terms,
                  mpfr_prec_t precision) {
  static Cache<FadeKey, Waves> kept(make_fades, size_of_waves, std::size_t{1} << 26);
  const auto waves = waves_at(x, terms, precision);
  const auto fades = kept.at({kernel, fade, rate.value(), terms, precision});
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
  const Interval value = wave_sum(kernel, alpha.magnitude(), Fade::none, Exact(0.0), terms, precision) +
                         constant_of(kernel, precision);
  return is_odd(kernel) && alpha.sign() < 0 ? -value : value;
}

Interval plain_memory(PlainKernel kernel, const Exact& alpha, const Exact& exact_rate, int terms,
                      double nats) {
  check_residue_terms(terms);
  const mpfr_prec_t precision = precision_of(nats);
  const Interval rate(exact_rate, precision), constant = constant_of(kernel, precision);
  const auto sum = [&](const Exact& x, Fade fade) {
    return wave_sum(kernel, x, fade, exact_rate, terms, precision);
  };
  const Exact x = alpha.magnitude(), at_load(0.0);
  if (alpha.sign() >= 0) return sum(x, Fade::ahead) + constant / rate;
  const Interval faded = exp(-(rate * Interval(x, precision)));
  const Interval passed = sum(at_load, Fade::ahead), coming = sum(at_load, Fade::behind);
  const Interval behind = sum(x, Fade::behind);
  const Interval waves =
      is_odd(kernel) ? faded * (passed + coming) - behind : faded * (passed - coming) + behind;
  return waves + constant * (2 * faded - 1) / rate;
}

}  // namespace nipref::ref
