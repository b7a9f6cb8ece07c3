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

/// 1 - q = 1 - e^{-r h}.
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

/// Evaluates h G(x) at equidistant x > 0 from powers of e^{-x}. Each power is the one before times a factor. The
/// rounding errors are within the guard bits: ref/sheet/README.md, Kernels.
class SymbolLine {
 public:
  explicit SymbolLine(const NodeKey& key)
      : key_(key), step1_(exp(Float(-key.step))), step_u_(exp(Float(-1.5 * key.step))) {}

  void start(long j) {
    place(j);
    e1_ = exp(-x_);
    if (key_.symbol == Symbol::I1) u_ = exp(Float(-1.5) * x_);
  }

  void advance(long j) {
    place(j);
    e1_ *= step1_;
    if (key_.symbol == Symbol::I1) u_ *= step_u_;
  }

  [[nodiscard]] Float value() const {
    const Float b = e1_ * e1_;
    const Float q = 1 - b * b + 4 * x_ * b;  // 2 e^{-2x} S
    return numerator(b, q) / q * key_.step;
  }

 private:
  void place(long j) { x_ = static_cast<double>(j) * key_.step; }

  /// G q. For I1 it is [(1 - tanh(3x/4)) - (1 - 2 sinh^2 x/S)] q/x = [2u q/(1 + u) - 2b (1 + 2x - b)]/x, u = e^{-3x/2}.
  [[nodiscard]] Float numerator(const Float& b, const Float& q) const {
    switch (key_.symbol) {
      case Symbol::I3:
        return 4 * b;
      case Symbol::I4:
        return 2 * (e1_ * (1 - b)) / x_;
      case Symbol::I5:
        return 2 * (e1_ * (1 + b));
      case Symbol::I7:
        return 2 * (e1_ * (1 - b));
      case Symbol::I6_alpha_part:
        return 4 * b / x_;
      case Symbol::I6_eta_part:
        return 2 * (e1_ * (1 + b)) / x_;
      default:
        return 2 * (u_ / (1 + u_) * q - b * (1 + 2 * x_ - b)) / x_;
    }
  }

  const NodeKey& key_;
  Float step1_, step_u_, x_, e1_, u_;
};

mpfr_prec_t guard_bits(const NodeKey& key) {
  return 20 + 2 * static_cast<mpfr_prec_t>(std::ceil(std::max(0.0, -std::log2(key.step))));
}

/// g_0, see Nodes.
Float origin_of(const NodeKey& key) {
  const SymbolBounds& symbol = bounds(key.symbol);
  if (symbol.is_odd) return 0;
  // The exact value of every origin_value is a multiple of 1/12.
  const Float half = Float(key.step * std::round(12 * symbol.origin_value)) / 24;
  return symbol.pole == 2 ? Float(half - pi() * pi() / 12 / key.step) : half;
}

/// Appends `value`, rounded to units of 2^-F, as `count` limbs of two's complement.
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
  const WorkingDigits working(digits_of(precision));
  SymbolLine line(key);
  for (long j = first; j < end; ++j) {
    j == first ? line.start(j) : line.advance(j);
    append(block.values, block.limbs, j == 0 ? origin_of(key) : line.value(), key);
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
  return symbol.amplitude / std::pow(key.step, symbol.pole);
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
