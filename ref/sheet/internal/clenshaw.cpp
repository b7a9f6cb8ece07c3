#include <algorithm>
#include <stdexcept>

#include <nipref/ref/sheet/internal/clenshaw.hpp>

namespace nipref::ref {
namespace {

/// The recurrence's state in units of 2^-F, B = 4 b_{j+1} and d = b_{j+1} - b_{j+2}.
struct Recurrence {
  mpz_class fourfold, difference;
};

/// Throws if 4 b_{j+1} has more than `bits` bits.
void check_size(const mpz_class& fourfold, long bits) {
  if (static_cast<long>(mpz_sizeinbase(fourfold.get_mpz_t(), 2)) > std::max(bits, 1L))
    throw std::logic_error("Clenshaw sum exceeds its proven bound");
}

/// From the last node down to j = 1: d += node - kappa B, B += 4 d, kappa to as many bits as B has in a block.
Recurrence recur(const Nodes& nodes, const Angle& angle) {
  Recurrence now;
  mpz_class kappa, product;
  Float scaled = zero_of_bits(bits_of(angle.half_sine_square));
  for (auto block = nodes.blocks.rbegin(); block != nodes.blocks.rend(); ++block) {
    mpfr_mul_2ui(raw(scaled), raw(angle.half_sine_square), block->bits(), MPFR_RNDD);
    mpfr_get_z(kappa.get_mpz_t(), raw(scaled), MPFR_RNDD);
    const std::size_t stop = block->first == 0 ? 1 : 0;
    for (std::size_t k = block->values.size(); k-- > stop;) {
      mpz_mul(product.get_mpz_t(), kappa.get_mpz_t(), now.fourfold.get_mpz_t());
      mpz_fdiv_q_2exp(product.get_mpz_t(), product.get_mpz_t(), block->bits());
      now.difference += block->values[k];
      now.difference -= product;
      mpz_addmul_ui(now.fourfold.get_mpz_t(), now.difference.get_mpz_t(), 4);
    }
    check_size(now.fourfold, nodes.key.fraction_bits + block->magnitude + 2);
  }
  return now;
}

/// So many units.
Float number(const mpz_class& units, const Nodes& nodes) {
  Float result = zero_of_bits(static_cast<mpfr_prec_t>(nodes.blocks.front().bits()));
  mpfr_set_z_2exp(raw(result), units.get_mpz_t(), -nodes.key.fraction_bits, MPFR_RNDN);
  return result;
}

}  // namespace

Angle::Angle(const mpq_class& theta, mpfr_prec_t precision)
    : sine(zero_of_bits(precision)), half_sine_square(sine) {
  Float half = zero_of_bits(precision);
  Float cosine = zero_of_bits(precision);
  mpfr_set_q(raw(half), theta.get_mpq_t(), MPFR_RNDN);
  mpfr_div_2ui(raw(half), raw(half), 1, MPFR_RNDN);
  mpfr_sin_cos(raw(half), raw(cosine), raw(half), MPFR_RNDN);
  mpfr_sqr(raw(half_sine_square), raw(half), MPFR_RNDN);
  mpfr_mul(raw(sine), raw(half), raw(cosine), MPFR_RNDN);
  mpfr_mul_2ui(raw(sine), raw(sine), 1, MPFR_RNDN);
}

mpfr_prec_t angle_precision(const Nodes& nodes) {
  return static_cast<mpfr_prec_t>(nodes.blocks.front().bits()) + 16;
}

Float cosine_sum(const Nodes& nodes, const Angle& angle) {
  const Recurrence last = recur(nodes, angle);
  // g_0 + cos(theta) b_1 - b_2 = g_0 + (b_1 - b_2) - kappa (4 b_1)/2
  Float sum = zero_of_bits(bits_of(angle.sine));
  mpfr_mul(raw(sum), raw(angle.half_sine_square), raw(number(last.fourfold, nodes)), MPFR_RNDN);
  mpfr_div_2ui(raw(sum), raw(sum), 1, MPFR_RNDN);
  mpfr_sub(raw(sum), raw(number(last.difference, nodes)), raw(sum), MPFR_RNDN);
  mpfr_add(raw(sum), raw(sum), raw(number(nodes.blocks.front().values.front(), nodes)), MPFR_RNDN);
  return sum;
}

// sin(theta) b_1
Float sine_sum(const Nodes& nodes, const Angle& angle) {
  Float result = zero_of_bits(bits_of(angle.sine));
  mpfr_mul(raw(result), raw(number(recur(nodes, angle).fourfold, nodes)), raw(angle.sine), MPFR_RNDN);
  mpfr_div_2ui(raw(result), raw(result), 2, MPFR_RNDN);
  return result;
}

}  // namespace nipref::ref
