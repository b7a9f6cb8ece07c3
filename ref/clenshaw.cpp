#include "ref/clenshaw.hpp"

#include <algorithm>
#include <stdexcept>

namespace nipref::ref {
namespace {

using Limbs = std::vector<mp_limb_t>;

bool is_negative(const mp_limb_t* x, std::size_t limbs) { return (x[limbs - 1] >> (GMP_NUMB_BITS - 1)) != 0; }

/// kappa as a binary fraction of `limbs` limbs, cut; 1 becomes the largest number below.
Limbs fraction(const Real& kappa, std::size_t limbs) {
  Limbs result(limbs, GMP_NUMB_MAX);
  if (mpfr_cmp_ui(kappa.get(), 1) >= 0) return result;
  Real scaled(kappa.precision());
  mpfr_mul_2ui(scaled.get(), kappa.get(), limbs * GMP_NUMB_BITS, MPFR_RNDD);
  mpz_class integer;
  mpfr_get_z(integer.get_mpz_t(), scaled.get(), MPFR_RNDD);
  std::fill(result.begin(), result.end(), 0);
  std::copy_n(mpz_limbs_read(integer.get_mpz_t()), mpz_size(integer.get_mpz_t()), result.begin());
  return result;
}

/// The recurrence's state: b_{j+1} and b_{j+2} in two's complement, longer by a limb whenever the nodes are.
class Recurrence {
 public:
  Recurrence(const Real& kappa, std::size_t most_limbs)
      : kappa_(fraction(kappa, most_limbs)), b1_(most_limbs), b2_(most_limbs), product_(2 * most_limbs) {}

  /// Extends b_{j+1}, b_{j+2} by their signs. Both are 0 at the start.
  void lengthen(std::size_t limbs) {
    for (Limbs* b : {&b1_, &b2_}) {
      const bool negative = limbs_ > 0 && is_negative(b->data(), limbs_);
      std::fill(b->begin() + static_cast<std::ptrdiff_t>(limbs_), b->begin() + static_cast<std::ptrdiff_t>(limbs),
                negative ? GMP_NUMB_MAX : 0);
    }
    limbs_ = limbs;
  }

  /// b2 becomes node + 2 b1 - b2 - 4 kappa b1, then b1 and b2 change places. Sums wrap around; the result fits.
  void step(const mp_limb_t* node) {
    const auto n = static_cast<mp_size_t>(limbs_);
    const mp_limb_t* high = scaled_b1();
    mpn_sub_n(b2_.data(), node, b2_.data(), n);
    mpn_lshift(product_.data(), b1_.data(), n, 1);
    mpn_add_n(b2_.data(), b2_.data(), product_.data(), n);
    mpn_lshift(product_.data(), high, n, 2);
    mpn_sub_n(b2_.data(), b2_.data(), product_.data(), n);
    b1_.swap(b2_);
  }

  [[nodiscard]] Real b1(long fraction_bits) const { return number(b1_, fraction_bits); }
  [[nodiscard]] Real b2(long fraction_bits) const { return number(b2_, fraction_bits); }

  /// Throws if b_{j+1}, in units of 2^-F, has more than `bits` bits.
  void check_size(long bits) const {
    if (static_cast<long>(mpz_sizeinbase(integer(b1_).get_mpz_t(), 2)) > std::max(bits, 1L)) {
      throw std::logic_error("Clenshaw sum exceeds its proven bound");
    }
  }

 private:
  /// floor(kappa b1): the upper half of the product of kappa with b1 read as unsigned, less kappa if b1 is negative.
  const mp_limb_t* scaled_b1() {
    const auto n = static_cast<mp_size_t>(limbs_);
    const mp_limb_t* kappa = kappa_.data() + (kappa_.size() - limbs_);
    mpn_mul_n(product_.data(), kappa, b1_.data(), n);
    mp_limb_t* high = product_.data() + limbs_;
    if (is_negative(b1_.data(), limbs_)) mpn_sub_n(high, high, kappa, n);
    return high;
  }

  [[nodiscard]] mpz_class integer(const Limbs& b) const {
    Limbs magnitude(b.begin(), b.begin() + static_cast<std::ptrdiff_t>(limbs_));
    const bool negative = is_negative(b.data(), limbs_);
    if (negative) mpn_neg(magnitude.data(), magnitude.data(), static_cast<mp_size_t>(limbs_));
    mpz_class result;
    mpz_import(result.get_mpz_t(), limbs_, -1, sizeof(mp_limb_t), 0, 0, magnitude.data());
    return negative ? mpz_class(-result) : result;
  }

  [[nodiscard]] Real number(const Limbs& b, long fraction_bits) const {
    Real result(static_cast<mpfr_prec_t>(limbs_) * GMP_NUMB_BITS);
    mpfr_set_z_2exp(result.get(), integer(b).get_mpz_t(), -fraction_bits, MPFR_RNDN);
    return result;
  }

  Limbs kappa_;
  Limbs b1_;
  Limbs b2_;
  Limbs product_;
  std::size_t limbs_ = 0;
};

/// Runs the recurrence from the last node down to j = 1.
Recurrence recur(const Nodes& nodes, const Angle& angle, Limbs NodeBlock::*part) {
  Recurrence recurrence(angle.half_sine_square, nodes.blocks.front().limbs);
  for (auto block = nodes.blocks.rbegin(); block != nodes.blocks.rend(); ++block) {
    recurrence.lengthen(block->limbs);
    const mp_limb_t* values = ((*block).*part).data();
    const std::size_t stop = block->first == 0 ? 1 : 0;
    for (std::size_t k = block->size(); k-- > stop;) recurrence.step(values + k * block->limbs);
    recurrence.check_size(nodes.key.fraction_bits + block->magnitude);
  }
  return recurrence;
}

Real sine_part(const Recurrence& recurrence, const Nodes& nodes, const Angle& angle) {
  Real result(angle.sine.precision());
  mpfr_mul(result.get(), recurrence.b1(nodes.key.fraction_bits).get(), angle.sine.get(), MPFR_RNDN);
  return result;
}

Real first_node(const Nodes& nodes) {
  const NodeBlock& block = nodes.blocks.front();
  Recurrence holder(Real(64), block.limbs);
  holder.lengthen(block.limbs);
  holder.step(block.real.data());
  return holder.b1(nodes.key.fraction_bits);
}

}  // namespace

Angle::Angle(const mpq_class& theta, mpfr_prec_t precision) : sine(precision), half_sine_square(precision) {
  Real rounded(precision);
  mpfr_set_q(rounded.get(), theta.get_mpq_t(), MPFR_RNDN);
  mpfr_sin(sine.get(), rounded.get(), MPFR_RNDN);
  mpfr_div_2ui(rounded.get(), rounded.get(), 1, MPFR_RNDN);
  mpfr_sin(half_sine_square.get(), rounded.get(), MPFR_RNDN);
  mpfr_sqr(half_sine_square.get(), half_sine_square.get(), MPFR_RNDN);
}

mpfr_prec_t angle_precision(const Nodes& nodes) {
  return static_cast<mpfr_prec_t>(nodes.blocks.front().limbs) * GMP_NUMB_BITS + 16;
}

Real wave_sum(const Nodes& nodes, const Angle& angle) {
  const long bits = nodes.key.fraction_bits;
  const Recurrence real = recur(nodes, angle, &NodeBlock::real);
  // g_0 + cos(theta) b_1 - b_2
  Real sum(angle.sine.precision());
  mpfr_ui_sub(sum.get(), 1, angle.half_sine_square.get(), MPFR_RNDN);
  mpfr_sub(sum.get(), sum.get(), angle.half_sine_square.get(), MPFR_RNDN);
  mpfr_mul(sum.get(), sum.get(), real.b1(bits).get(), MPFR_RNDN);
  mpfr_sub(sum.get(), sum.get(), real.b2(bits).get(), MPFR_RNDN);
  mpfr_add(sum.get(), sum.get(), first_node(nodes).get(), MPFR_RNDN);
  if (nodes.key.line != Line::real_axis) {
    const Real imaginary = sine_part(recur(nodes, angle, &NodeBlock::imag), nodes, angle);
    mpfr_sub(sum.get(), sum.get(), imaginary.get(), MPFR_RNDN);
  }
  return sum;
}

Real sine_sum(const Nodes& nodes, const Angle& angle) {
  return sine_part(recur(nodes, angle, &NodeBlock::real), nodes, angle);
}

}  // namespace nipref::ref
