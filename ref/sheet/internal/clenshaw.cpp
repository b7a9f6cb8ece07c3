#include <algorithm>
#include <stdexcept>

#include <nipref/ref/sheet/internal/clenshaw.hpp>

namespace nipref::ref {
namespace {

using Limbs = std::vector<mp_limb_t>;

bool is_negative(const mp_limb_t* x, std::size_t limbs) { return (x[limbs - 1] >> (GMP_NUMB_BITS - 1)) != 0; }

/// kappa as a binary fraction of `limbs` limbs, rounded down; 1 becomes the largest such fraction.
Limbs fraction(const Float& kappa, std::size_t limbs) {
  Limbs result(limbs, GMP_NUMB_MAX);
  if (mpfr_cmp_ui(raw(kappa), 1) >= 0) return result;
  Float scaled = zero_of_bits(bits_of(kappa));
  mpfr_mul_2ui(raw(scaled), raw(kappa), limbs * GMP_NUMB_BITS, MPFR_RNDD);
  mpz_class integer;
  mpfr_get_z(integer.get_mpz_t(), raw(scaled), MPFR_RNDD);
  std::fill(result.begin(), result.end(), 0);
  std::copy_n(mpz_limbs_read(integer.get_mpz_t()), mpz_size(integer.get_mpz_t()), result.begin());
  return result;
}

/// An integer in units of 2^-fraction_bits, exactly.
Float scaled(const mpz_class& integer, long fraction_bits) {
  Float result = zero_of_bits(static_cast<mpfr_prec_t>(mpz_sizeinbase(integer.get_mpz_t(), 2)) + 1);
  mpfr_set_z_2exp(raw(result), integer.get_mpz_t(), -fraction_bits, MPFR_RNDN);
  return result;
}

/// The state of the recurrence: B = 4 b_{j+1} and d = b_{j+1} - b_{j+2} in two's complement, as long as the nodes.
class Recurrence {
 public:
  Recurrence(const Float& kappa, std::size_t most_limbs)
      : kappa_(fraction(kappa, most_limbs)),
        fourfold_(most_limbs),
        difference_(most_limbs),
        product_(2 * most_limbs) {}

  /// Extends both numbers, which are 0 at the start, to `limbs` limbs by copies of their sign bits.
  void lengthen(std::size_t limbs) {
    for (Limbs* x : {&fourfold_, &difference_}) {
      const bool negative = limbs_ > 0 && is_negative(x->data(), limbs_);
      std::fill(x->begin() + static_cast<std::ptrdiff_t>(limbs_),
                x->begin() + static_cast<std::ptrdiff_t>(limbs), negative ? GMP_NUMB_MAX : 0);
    }
    limbs_ = limbs;
  }

  /// d += node - kappa B, B += 4 d. Sums may wrap around, but the results are within the range.
  void step(const mp_limb_t* node) {
    const auto n = static_cast<mp_size_t>(limbs_);
    const mp_limb_t* scaled = scaled_fourfold();
    mpn_add_n(difference_.data(), difference_.data(), node, n);
    mpn_sub_n(difference_.data(), difference_.data(), scaled, n);
    mpn_addmul_1(fourfold_.data(), difference_.data(), n, 4);
  }

  /// 4 b_{j+1} and b_{j+1} - b_{j+2}.
  [[nodiscard]] Float fourfold(long fraction_bits) const { return scaled(integer(fourfold_), fraction_bits); }
  [[nodiscard]] Float difference(long fraction_bits) const {
    return scaled(integer(difference_), fraction_bits);
  }

  /// Throws if 4 b_{j+1}, in units of 2^-F, has more than `bits` bits.
  void check_size(long bits) const {
    if (static_cast<long>(mpz_sizeinbase(integer(fourfold_).get_mpz_t(), 2)) > std::max(bits, 1L)) {
      throw std::logic_error("Clenshaw sum exceeds its proven bound");
    }
  }

 private:
  /// floor(kappa B): the upper half of the product of kappa with B read as unsigned, less kappa if B is
  /// negative.
  const mp_limb_t* scaled_fourfold() {
    const auto n = static_cast<mp_size_t>(limbs_);
    const mp_limb_t* kappa = kappa_.data() + (kappa_.size() - limbs_);
    mpn_mul_n(product_.data(), kappa, fourfold_.data(), n);
    mp_limb_t* high = product_.data() + limbs_;
    if (is_negative(fourfold_.data(), limbs_)) mpn_sub_n(high, high, kappa, n);
    return high;
  }

  [[nodiscard]] mpz_class integer(const Limbs& x) const { return signed_integer(x.data(), limbs_); }

  Limbs kappa_;
  Limbs fourfold_;
  Limbs difference_;
  Limbs product_;
  std::size_t limbs_ = 0;
};

/// Runs the recurrence from the last node down to j = 1.
Recurrence recur(const Nodes& nodes, const Angle& angle) {
  Recurrence recurrence(angle.half_sine_square, nodes.blocks.front().limbs);
  for (auto block = nodes.blocks.rbegin(); block != nodes.blocks.rend(); ++block) {
    recurrence.lengthen(block->limbs);
    const mp_limb_t* values = block->values.data();
    const std::size_t stop = block->first == 0 ? 1 : 0;
    for (std::size_t k = block->size(); k-- > stop;) recurrence.step(values + k * block->limbs);
    recurrence.check_size(nodes.key.fraction_bits + block->magnitude + 2);
  }
  return recurrence;
}

}  // namespace

Angle::Angle(const mpq_class& theta, mpfr_prec_t precision) {
  const WorkingDigits working(digits_of(precision));
  const Float half = to_float(theta) / 2, sine_of_half = sin(half);
  half_sine_square = sine_of_half * sine_of_half;
  sine = 2 * sine_of_half * cos(half);
}

mpfr_prec_t angle_precision(const Nodes& nodes) {
  return static_cast<mpfr_prec_t>(nodes.blocks.front().limbs) * GMP_NUMB_BITS + 16;
}

Float cosine_sum(const Nodes& nodes, const Angle& angle) {
  const long bits = nodes.key.fraction_bits;
  const Recurrence recurrence = recur(nodes, angle);
  const NodeBlock& block = nodes.blocks.front();
  const Float first = scaled(signed_integer(block.values.data(), block.limbs), bits),
              fourfold = recurrence.fourfold(bits), difference = recurrence.difference(bits);
  // g_0 + cos(theta) b_1 - b_2 = g_0 + (b_1 - b_2) - kappa (4 b_1)/2
  const WorkingDigits working(digits_of(bits_of(angle.sine)));
  return first + (difference - angle.half_sine_square * fourfold / 2);
}

// sin(theta) b_1
Float sine_sum(const Nodes& nodes, const Angle& angle) {
  const Float fourfold = recur(nodes, angle).fourfold(nodes.key.fraction_bits);
  const WorkingDigits working(digits_of(bits_of(angle.sine)));
  return fourfold * angle.sine / 4;
}

}  // namespace nipref::ref
