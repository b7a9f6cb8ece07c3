#include "ref/clenshaw.hpp"

#include <stdexcept>

namespace nipref::ref {
namespace {

/// b_1 and b_2 of the recurrence, from which the sums follow.
struct Tail {
  Real b1;
  Real b2;
};

void check_magnitude(const Real& b, long magnitude) {
  if (!mpfr_zero_p(b.get()) && mpfr_get_exp(b.get()) > magnitude) {
    throw std::logic_error("Clenshaw sum exceeds its proven bound");
  }
}

Tail recur(const Nodes& nodes, const Real& cosine, std::vector<Real> NodeBlock::*part) {
  Real b1(64);
  Real b2(64);
  Real next(64);
  Real twice_cosine(64);
  for (auto block = nodes.blocks.rbegin(); block != nodes.blocks.rend(); ++block) {
    if (block->precision != twice_cosine.precision() || mpfr_zero_p(twice_cosine.get())) {
      mpfr_prec_round(b1.get(), block->precision, MPFR_RNDN);
      mpfr_prec_round(b2.get(), block->precision, MPFR_RNDN);
      mpfr_set_prec(next.get(), block->precision);
      mpfr_set_prec(twice_cosine.get(), block->precision);
      mpfr_mul_2ui(twice_cosine.get(), cosine.get(), 1, MPFR_RNDN);
    }
    const std::vector<Real>& values = (*block).*part;
    const std::size_t stop = block->first == 0 ? 1 : 0;
    for (std::size_t k = values.size(); k-- > stop;) {
      mpfr_mul(next.get(), twice_cosine.get(), b1.get(), MPFR_RNDN);
      mpfr_sub(next.get(), next.get(), b2.get(), MPFR_RNDN);
      mpfr_add(next.get(), next.get(), values[k].get(), MPFR_RNDN);
      mpfr_swap(b2.get(), b1.get());
      mpfr_swap(b1.get(), next.get());
    }
    check_magnitude(b1, block->magnitude);
  }
  return {std::move(b1), std::move(b2)};
}

Real sine_part(const Tail& tail, const Angle& angle) {
  Real result(angle.sine.precision());
  mpfr_mul(result.get(), tail.b1.get(), angle.sine.get(), MPFR_RNDN);
  return result;
}

}  // namespace

Angle::Angle(const mpq_class& theta, mpfr_prec_t precision) : cosine(precision), sine(precision) {
  mpfr_t rounded;
  mpfr_init2(rounded, precision);
  mpfr_set_q(rounded, theta.get_mpq_t(), MPFR_RNDN);
  mpfr_sin_cos(sine.get(), cosine.get(), rounded, MPFR_RNDN);
  mpfr_clear(rounded);
}

mpfr_prec_t angle_precision(const Nodes& nodes) { return nodes.blocks.front().precision + 16; }

Real wave_sum(const Nodes& nodes, const Angle& angle) {
  const Tail tail = recur(nodes, angle.cosine, &NodeBlock::real);
  Real sum(angle.cosine.precision());
  mpfr_mul(sum.get(), tail.b1.get(), angle.cosine.get(), MPFR_RNDN);
  mpfr_sub(sum.get(), sum.get(), tail.b2.get(), MPFR_RNDN);
  mpfr_add(sum.get(), sum.get(), nodes.blocks.front().real.front().get(), MPFR_RNDN);
  if (nodes.key.line != Line::real_axis) {
    const Real imaginary = sine_part(recur(nodes, angle.cosine, &NodeBlock::imag), angle);
    mpfr_sub(sum.get(), sum.get(), imaginary.get(), MPFR_RNDN);
  }
  return sum;
}

Real sine_sum(const Nodes& nodes, const Angle& angle) {
  return sine_part(recur(nodes, angle.cosine, &NodeBlock::real), angle);
}

}  // namespace nipref::ref
