#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <nipref/ref/number/internal/complex.hpp>
#include <nipref/ref/number/internal/memo.hpp>
#include <nipref/ref/number/real.hpp>
#include <nipref/ref/sheet/internal/nodes.hpp>

namespace nipref::ref {
namespace {

constexpr long block_length = 32;
constexpr double ln2 = 0.6931471805599453;

/// 1 - e^{-r h}, the ratio's distance from 1.
double one_minus_ratio(const NodeKey& key) { return -std::expm1(-bounds(key.symbol).decay * key.step); }

/// Exponent e with |b_j| <= 2^e: sum_{k>=j} (k-j+1) C' h q^k = C' h q^j/(1-q)^2, one bit of slack.
long clenshaw_magnitude(const NodeKey& key, long j) {
  const double decay = bounds(key.symbol).decay;
  const double log2_bound = std::log2(effective_amplitude(key) * key.step) -
                            2 * std::log2(one_minus_ratio(key)) -
                            decay * key.step * static_cast<double>(j) / ln2;
  return static_cast<long>(std::ceil(log2_bound)) + 1;
}

/// Smallest N whose remainder C' h q^{N+1}/(1-q) is at most truncation_units.
long last_node(const NodeKey& key) {
  const double decay = bounds(key.symbol).decay;
  const double nats = static_cast<double>(key.fraction_bits) * ln2 - std::log(truncation_units) +
                      std::log(effective_amplitude(key) * key.step / one_minus_ratio(key));
  return std::max(1L, static_cast<long>(std::ceil(nats / (decay * key.step) * (1 + 1e-12))));
}

/// Evaluates h G(z) along a line, from powers of e^{-z} that are stepped by one real factor a node.
///
/// Rounding, in units of 2^-w with w the working precision: an exponential that starts a block is good to 2,
/// each of at most 31 steps adds 2, so |d(e^{-z})| <= 70 and |d(e^{-2z})| <= 145 relative. Q = 1 - e^{-4z} +
/// 4 z e^{-2z} is then off by at most 1500 absolutely, |Q| >= 1/2 on the shifted lines and Q >= min(1, 4 x)
/// on the real axis, so a quotient by Q is good to 2^12/h relatively, and the difference of two such in
/// `normal`, divided by z, to 2^13/h^2 absolutely. w exceeds the block's precision by more than that: see
/// guard_bits.
class SymbolLine {
 public:
  SymbolLine(const NodeKey& key, mpfr_prec_t precision)
      : key_(key),
        z_(precision),
        e1_(precision),
        u_(precision),
        step1_(precision),
        step_u_(precision),
        a_(precision),
        b_(precision),
        q_(precision) {
    mpfr_set_d(step1_.get(), -key.step, MPFR_RNDN);
    mpfr_exp(step1_.get(), step1_.get(), MPFR_RNDN);
    mpfr_set_d(step_u_.get(), -1.5 * key.step, MPFR_RNDN);
    mpfr_exp(step_u_.get(), step_u_.get(), MPFR_RNDN);
  }

  void start(long j) {
    place(j);
    mpc_neg(e1_.get(), z_.get(), MPC_RNDNN);
    mpc_exp(e1_.get(), e1_.get(), MPC_RNDNN);
    if (key_.symbol != Symbol::normal) return;
    mpc_mul_si(u_.get(), z_.get(), -3, MPC_RNDNN);
    mpc_div_2ui(u_.get(), u_.get(), 1, MPC_RNDNN);
    mpc_exp(u_.get(), u_.get(), MPC_RNDNN);
  }

  void advance(long j) {
    place(j);
    mpc_mul_fr(e1_.get(), e1_.get(), step1_.get(), MPC_RNDNN);
    if (key_.symbol == Symbol::normal) mpc_mul_fr(u_.get(), u_.get(), step_u_.get(), MPC_RNDNN);
  }

  /// h G(z) at the present z, z != 0.
  mpc_srcptr value() {
    mpc_sqr(b_.get(), e1_.get(), MPC_RNDNN);  // e^{-2z}
    denominator();
    switch (key_.symbol) {
      case Symbol::normal:
        normal();
        break;
      case Symbol::I3:
        mpc_mul_ui(a_.get(), b_.get(), 4, MPC_RNDNN);
        break;
      case Symbol::I4:
        cosh_like(-1);
        mpc_div(a_.get(), a_.get(), z_.get(), MPC_RNDNN);
        break;
      case Symbol::I5:
        cosh_like(+1);
        break;
      case Symbol::I7:
        cosh_like(-1);
        break;
      case Symbol::I6_alpha:
        mpc_mul_ui(a_.get(), b_.get(), 4, MPC_RNDNN);
        mpc_div(a_.get(), a_.get(), z_.get(), MPC_RNDNN);
        break;
      case Symbol::I6_eta:
        cosh_like(+1);
        mpc_div(a_.get(), a_.get(), z_.get(), MPC_RNDNN);
        break;
    }
    mpc_div(a_.get(), a_.get(), q_.get(), MPC_RNDNN);
    mpfr_mul_d(mpc_realref(a_.get()), mpc_realref(a_.get()), key_.step, MPFR_RNDN);
    mpfr_mul_d(mpc_imagref(a_.get()), mpc_imagref(a_.get()), key_.step, MPFR_RNDN);
    return a_.get();
  }

 private:
  void place(long j) {
    mpc_set_d_d(z_.get(), static_cast<double>(j) * key_.step, height(key_.line), MPC_RNDNN);
  }

  /// q = 1 - e^{-4z} + 4 z e^{-2z} = 2 e^{-2z} S.
  void denominator() {
    mpc_mul(q_.get(), z_.get(), b_.get(), MPC_RNDNN);
    mpc_mul_ui(q_.get(), q_.get(), 4, MPC_RNDNN);
    mpc_sqr(a_.get(), b_.get(), MPC_RNDNN);
    mpc_ui_sub(a_.get(), 1, a_.get(), MPC_RNDNN);
    mpc_add(q_.get(), q_.get(), a_.get(), MPC_RNDNN);
  }

  /// a = 2 e^{-z} (1 + sign e^{-2z}), the numerator of 2 cosh z/S or 2 sinh z/S over q.
  void cosh_like(int sign) {
    if (sign > 0) {
      mpc_add_ui(a_.get(), b_.get(), 1, MPC_RNDNN);
    } else {
      mpc_ui_sub(a_.get(), 1, b_.get(), MPC_RNDNN);
    }
    mpc_mul(a_.get(), a_.get(), e1_.get(), MPC_RNDNN);
    mpc_mul_ui(a_.get(), a_.get(), 2, MPC_RNDNN);
  }

  /// a/q = [(1 - tanh(3z/4)) - (1 - 2 sinh^2 z/S)]/z = [2u/(1+u) - 2 e^{-2z} (1 + 2z - e^{-2z})/q]/z with u =
  /// e^{-3z/2}.
  void normal() {
    mpc_mul_ui(a_.get(), z_.get(), 2, MPC_RNDNN);
    mpc_add_ui(a_.get(), a_.get(), 1, MPC_RNDNN);
    mpc_sub(a_.get(), a_.get(), b_.get(), MPC_RNDNN);
    mpc_mul(a_.get(), a_.get(), b_.get(), MPC_RNDNN);
    mpc_add_ui(b_.get(), u_.get(), 1, MPC_RNDNN);
    mpc_div(b_.get(), u_.get(), b_.get(), MPC_RNDNN);
    mpc_mul(b_.get(), b_.get(), q_.get(), MPC_RNDNN);
    mpc_sub(a_.get(), b_.get(), a_.get(), MPC_RNDNN);
    mpc_mul_ui(a_.get(), a_.get(), 2, MPC_RNDNN);
    mpc_div(a_.get(), a_.get(), z_.get(), MPC_RNDNN);
  }

  const NodeKey& key_;
  Complex z_, e1_, u_;
  Real step1_, step_u_;
  Complex a_, b_, q_;
};

mpfr_prec_t guard_bits(const NodeKey& key) {
  return 20 + 2 * static_cast<mpfr_prec_t>(std::ceil(std::max(0.0, -std::log2(key.step))));
}

/// g_0 on the real axis, see Nodes.
void set_origin(Real& value, const NodeKey& key) {
  const SymbolBounds& symbol = bounds(key.symbol);
  mpfr_set_zero(value.get(), 1);
  if (symbol.parity == Parity::odd) return;
  // Every origin_value is a multiple of 1/12, exactly.
  mpfr_set_d(value.get(), key.step * std::round(12 * symbol.origin_value), MPFR_RNDN);
  mpfr_div_ui(value.get(), value.get(), 24, MPFR_RNDN);
  if (symbol.origin != OriginPole::twofold) return;
  Real residue(value.precision());
  mpfr_const_pi(residue.get(), MPFR_RNDN);
  mpfr_sqr(residue.get(), residue.get(), MPFR_RNDN);
  mpfr_div_ui(residue.get(), residue.get(), 12, MPFR_RNDN);
  mpfr_div_d(residue.get(), residue.get(), key.step, MPFR_RNDN);
  mpfr_sub(value.get(), value.get(), residue.get(), MPFR_RNDN);
}

/// Appends `value` in units of 2^-F, rounded, as `limbs` limbs of two's complement.
void append(std::vector<mp_limb_t>& limbs, std::size_t count, mpfr_srcptr value, const NodeKey& key) {
  Real scaled(mpfr_get_prec(value));
  mpfr_mul_2si(scaled.get(), value, key.fraction_bits, MPFR_RNDN);
  mpz_class integer;
  mpfr_get_z(integer.get_mpz_t(), scaled.get(), MPFR_RNDN);
  const std::size_t size = mpz_size(integer.get_mpz_t());
  if (size > count) throw std::logic_error("a node exceeds its proven bound");
  const std::size_t start = limbs.size();
  limbs.resize(start + count, 0);
  std::copy_n(mpz_limbs_read(integer.get_mpz_t()), size, &limbs[start]);
  if (sgn(integer) < 0) mpn_neg(&limbs[start], &limbs[start], static_cast<mp_size_t>(count));
}

NodeBlock make_block(const NodeKey& key, long first, long end) {
  const bool shifted = key.line != Line::real_axis;
  const long magnitude = clenshaw_magnitude(key, first);
  const long bits = std::max(
      1L, key.fraction_bits + magnitude + 4);  // b_j is held fourfold, with a sign and a bit to spare
  NodeBlock block{
      first, static_cast<std::size_t>((bits + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS), magnitude, {}, {}};
  const mpfr_prec_t precision = static_cast<mpfr_prec_t>(block.limbs) * GMP_NUMB_BITS + guard_bits(key);
  SymbolLine line(key, precision);
  Real real(precision);
  for (long j = first; j < end; ++j) {
    j == first ? line.start(j) : line.advance(j);
    if (j == 0 && !shifted) {
      set_origin(real, key);
      append(block.real, block.limbs, real.get(), key);
      continue;
    }
    const mpc_srcptr value = line.value();
    mpfr_div_2ui(real.get(), mpc_realref(value), j == 0 ? 1 : 0, MPFR_RNDN);
    append(block.real, block.limbs, real.get(), key);
    if (shifted) append(block.imag, block.limbs, mpc_imagref(value), key);
  }
  return block;
}

std::size_t size_in_bytes(const Nodes& nodes) {
  std::size_t bytes = 0;
  for (const NodeBlock& block : nodes.blocks)
    bytes += (block.real.size() + block.imag.size()) * sizeof(mp_limb_t);
  return bytes;
}

}  // namespace

mpz_class signed_integer(const mp_limb_t* x, std::size_t limbs) {
  std::vector<mp_limb_t> magnitude(x, x + limbs);
  const bool negative = (x[limbs - 1] >> (GMP_NUMB_BITS - 1)) != 0;
  if (negative) mpn_neg(magnitude.data(), magnitude.data(), static_cast<mp_size_t>(limbs));
  mpz_class result;
  mpz_import(result.get_mpz_t(), limbs, -1, sizeof(mp_limb_t), 0, 0, magnitude.data());
  return negative ? mpz_class(-result) : result;
}

double effective_amplitude(const NodeKey& key) {
  const SymbolBounds& symbol = bounds(key.symbol);
  const double amplitude = symbol.amplitude[static_cast<std::size_t>(key.line)];
  const int order = key.line == Line::real_axis ? static_cast<int>(symbol.origin) : 0;
  return amplitude / std::pow(key.step, order);
}

Nodes make_nodes(const NodeKey& key) {
  Nodes result{key, last_node(key), {}};
  for (long first = 0; first <= result.last; first += block_length) {
    result.blocks.push_back(make_block(key, first, std::min(first + block_length, result.last + 1)));
  }
  return result;
}

std::shared_ptr<const Nodes> nodes(const NodeKey& key) {
  static Memo<NodeKey, Nodes> kept(make_nodes, size_in_bytes);
  return kept.at(key);
}

}  // namespace nipref::ref
