#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <nipref/ref/number/float.hpp>
#include <nipref/ref/number/internal/cache.hpp>
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

/// Evaluates h G(x) at equidistant x from powers of e^{-x}, each of which is the one before times a factor. What that rounds
/// is less than the guard bits: ref/sheet/README.md, Kernels.
class SymbolLine {
 public:
  SymbolLine(const NodeKey& key, mpfr_prec_t precision) : key_(key), x_(zero_of_bits(precision)) {
    mpfr_set_d(raw(step1_), -key.step, MPFR_RNDN);
    mpfr_exp(raw(step1_), raw(step1_), MPFR_RNDN);
    mpfr_set_d(raw(step_u_), -1.5 * key.step, MPFR_RNDN);
    mpfr_exp(raw(step_u_), raw(step_u_), MPFR_RNDN);
  }

  void start(long j) {
    place(j);
    mpfr_neg(raw(e1_), raw(x_), MPFR_RNDN);
    mpfr_exp(raw(e1_), raw(e1_), MPFR_RNDN);
    if (key_.symbol != Symbol::normal) return;
    mpfr_mul_d(raw(u_), raw(x_), -1.5, MPFR_RNDN);
    mpfr_exp(raw(u_), raw(u_), MPFR_RNDN);
  }

  void advance(long j) {
    place(j);
    mpfr_mul(raw(e1_), raw(e1_), raw(step1_), MPFR_RNDN);
    if (key_.symbol == Symbol::normal) mpfr_mul(raw(u_), raw(u_), raw(step_u_), MPFR_RNDN);
  }

  /// h G(x) at the current x > 0.
  const Float& value() {
    mpfr_sqr(raw(b_), raw(e1_), MPFR_RNDN);  // e^{-2x}
    denominator();
    switch (key_.symbol) {
      case Symbol::normal:
        normal();
        break;
      case Symbol::I3:
        mpfr_mul_ui(raw(a_), raw(b_), 4, MPFR_RNDN);
        break;
      case Symbol::I4:
        cosh_like(-1);
        mpfr_div(raw(a_), raw(a_), raw(x_), MPFR_RNDN);
        break;
      case Symbol::I5:
        cosh_like(+1);
        break;
      case Symbol::I7:
        cosh_like(-1);
        break;
      case Symbol::I6_alpha:
        mpfr_mul_ui(raw(a_), raw(b_), 4, MPFR_RNDN);
        mpfr_div(raw(a_), raw(a_), raw(x_), MPFR_RNDN);
        break;
      case Symbol::I6_eta:
        cosh_like(+1);
        mpfr_div(raw(a_), raw(a_), raw(x_), MPFR_RNDN);
        break;
    }
    mpfr_div(raw(a_), raw(a_), raw(q_), MPFR_RNDN);
    mpfr_mul_d(raw(a_), raw(a_), key_.step, MPFR_RNDN);
    return a_;
  }

 private:
  void place(long j) { mpfr_set_d(raw(x_), static_cast<double>(j) * key_.step, MPFR_RNDN); }

  /// q = 1 - e^{-4x} + 4 x e^{-2x} = 2 e^{-2x} S.
  void denominator() {
    mpfr_mul(raw(q_), raw(x_), raw(b_), MPFR_RNDN);
    mpfr_mul_ui(raw(q_), raw(q_), 4, MPFR_RNDN);
    mpfr_sqr(raw(a_), raw(b_), MPFR_RNDN);
    mpfr_ui_sub(raw(a_), 1, raw(a_), MPFR_RNDN);
    mpfr_add(raw(q_), raw(q_), raw(a_), MPFR_RNDN);
  }

  /// a = 2 e^{-x} (1 + sign e^{-2x}), the numerator of 2 cosh x/S or 2 sinh x/S over q.
  void cosh_like(int sign) {
    if (sign > 0) {
      mpfr_add_ui(raw(a_), raw(b_), 1, MPFR_RNDN);
    } else {
      mpfr_ui_sub(raw(a_), 1, raw(b_), MPFR_RNDN);
    }
    mpfr_mul(raw(a_), raw(a_), raw(e1_), MPFR_RNDN);
    mpfr_mul_ui(raw(a_), raw(a_), 2, MPFR_RNDN);
  }

  /// a/q = [(1 - tanh(3x/4)) - (1 - 2 sinh^2 x/S)]/x = [2u/(1+u) - 2 e^{-2x} (1 + 2x - e^{-2x})/q]/x with u =
  /// e^{-3x/2}.
  void normal() {
    mpfr_mul_ui(raw(a_), raw(x_), 2, MPFR_RNDN);
    mpfr_add_ui(raw(a_), raw(a_), 1, MPFR_RNDN);
    mpfr_sub(raw(a_), raw(a_), raw(b_), MPFR_RNDN);
    mpfr_mul(raw(a_), raw(a_), raw(b_), MPFR_RNDN);
    mpfr_add_ui(raw(b_), raw(u_), 1, MPFR_RNDN);
    mpfr_div(raw(b_), raw(u_), raw(b_), MPFR_RNDN);
    mpfr_mul(raw(b_), raw(b_), raw(q_), MPFR_RNDN);
    mpfr_sub(raw(a_), raw(b_), raw(a_), MPFR_RNDN);
    mpfr_mul_ui(raw(a_), raw(a_), 2, MPFR_RNDN);
    mpfr_div(raw(a_), raw(a_), raw(x_), MPFR_RNDN);
  }

  const NodeKey& key_;
  Float x_, e1_ = x_, u_ = x_;
  Float step1_ = x_, step_u_ = x_;
  Float a_ = x_, b_ = x_, q_ = x_;
};

mpfr_prec_t guard_bits(const NodeKey& key) {
  return 20 + 2 * static_cast<mpfr_prec_t>(std::ceil(std::max(0.0, -std::log2(key.step))));
}

/// g_0, see Nodes.
void set_origin(Float& value, const NodeKey& key) {
  const SymbolBounds& symbol = bounds(key.symbol);
  mpfr_set_zero(raw(value), 1);
  if (symbol.parity == Parity::odd) return;
  // Every origin_value is a multiple of 1/12, exactly.
  mpfr_set_d(raw(value), key.step * std::round(12 * symbol.origin_value), MPFR_RNDN);
  mpfr_div_ui(raw(value), raw(value), 24, MPFR_RNDN);
  if (symbol.origin != OriginPole::twofold) return;
  Float residue = zero_of_bits(bits_of(value));
  mpfr_const_pi(raw(residue), MPFR_RNDN);
  mpfr_sqr(raw(residue), raw(residue), MPFR_RNDN);
  mpfr_div_ui(raw(residue), raw(residue), 12, MPFR_RNDN);
  mpfr_div_d(raw(residue), raw(residue), key.step, MPFR_RNDN);
  mpfr_sub(raw(value), raw(value), raw(residue), MPFR_RNDN);
}

/// Appends `value` in units of 2^-F, rounded, as `limbs` limbs of two's complement.
void append(std::vector<mp_limb_t>& limbs, std::size_t count, const Float& value, const NodeKey& key) {
  Float scaled = zero_of_bits(bits_of(value));
  mpfr_mul_2si(raw(scaled), raw(value), key.fraction_bits, MPFR_RNDN);
  mpz_class integer;
  mpfr_get_z(integer.get_mpz_t(), raw(scaled), MPFR_RNDN);
  const std::size_t size = mpz_size(integer.get_mpz_t());
  if (size > count) throw std::logic_error("a node exceeds its proven bound");
  const std::size_t start = limbs.size();
  limbs.resize(start + count, 0);
  std::copy_n(mpz_limbs_read(integer.get_mpz_t()), size, &limbs[start]);
  if (sgn(integer) < 0) mpn_neg(&limbs[start], &limbs[start], static_cast<mp_size_t>(count));
}

NodeBlock make_block(const NodeKey& key, long first, long end) {
  const long magnitude = clenshaw_magnitude(key, first);
  const long bits = std::max(1L, key.fraction_bits + magnitude + 4);  // for 4 b_j, its sign and one spare bit
  NodeBlock block{first, static_cast<std::size_t>((bits + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS), magnitude, {}};
  const mpfr_prec_t precision = static_cast<mpfr_prec_t>(block.limbs) * GMP_NUMB_BITS + guard_bits(key);
  SymbolLine line(key, precision);
  Float origin = zero_of_bits(precision);
  for (long j = first; j < end; ++j) {
    j == first ? line.start(j) : line.advance(j);
    if (j == 0) set_origin(origin, key);
    append(block.values, block.limbs, j == 0 ? origin : line.value(), key);
  }
  return block;
}

std::size_t size_in_bytes(const Nodes& nodes) {
  std::size_t bytes = 0;
  for (const NodeBlock& block : nodes.blocks) bytes += block.values.size() * sizeof(mp_limb_t);
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
  return symbol.amplitude / std::pow(key.step, static_cast<int>(symbol.origin));
}

Nodes make_nodes(const NodeKey& key) {
  Nodes result{key, last_node(key), {}};
  for (long first = 0; first <= result.last; first += block_length) {
    result.blocks.push_back(make_block(key, first, std::min(first + block_length, result.last + 1)));
  }
  return result;
}

std::shared_ptr<const Nodes> nodes(const NodeKey& key) {
  static Cache<NodeKey, Nodes> kept(make_nodes, size_in_bytes);
  return kept.at(key);
}

}  // namespace nipref::ref
