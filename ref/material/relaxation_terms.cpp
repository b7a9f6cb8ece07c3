#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/material/internal/polynomial.hpp>
#include <nipref/ref/material/relaxation_terms.hpp>

namespace nipref::ref {
namespace {

using Terms = std::vector<OscillatingTerm>;

double middle(const Interval& x) { return mpfi_get_d(x.get()); }

bool meet(const Interval& a, const Interval& b) { return mpfi_has_zero((a - b).get()) > 0; }

/// Whether the second rate may be the conjugate of the first.
bool may_be_pair(const OscillatingTerm& a, const OscillatingTerm& b) {
  return meet(a.rate.re, b.rate.re) && meet(-a.rate.im, b.rate.im);
}

/// theta = gamma_0 + numerator/denominator, a ratio without common factors.
struct Split {
  mpq_class at_once;
  Polynomial numerator, denominator;

  explicit Split(const ExactRatio& theta)
      : at_once(0), numerator(theta.numerator), denominator(theta.denominator) {
    cancel(numerator, denominator);
    const Polynomial whole = numerator / denominator;
    numerator %= denominator;
    if (whole.size() > 1)
      throw data::BadInput("material", "(as given)", "must not give way without bound at once");
    if (!whole.is_zero()) at_once = whole[0];
    if (has_repeated_root(denominator))
      throw data::BadInput("material", "(its rates)",
                           "must not be repeated: t e^(-rate t) is not among the terms of a material");
  }
  [[nodiscard]] int terms() const { return static_cast<int>(denominator.size()) - 1; }
  /// The terms in the order of relaxation_terms.hpp.
  [[nodiscard]] Terms at(mpfr_prec_t bits) const {
    Terms all = partial_fractions(numerator, denominator, bits);
    std::ranges::sort(all, [](const OscillatingTerm& a, const OscillatingTerm& b) {
      const bool together = meet(a.rate.re, b.rate.re);
      return together ? middle(a.rate.im) < middle(b.rate.im) : middle(a.rate.re) < middle(b.rate.re);
    });
    constexpr double apart = 1e-12;
    for (std::size_t i = 1; i < all.size(); ++i) {
      const double first = middle(all[i - 1].rate.re), second = middle(all[i].rate.re);
      if (std::fabs(second - first) <= apart * std::fabs(second) && !may_be_pair(all[i - 1], all[i]))
        throw data::BadInput("material", "(its rates)",
                             "must have real parts that differ by more than 1e-12 of them, but for pairs");
    }
    return all;
  }
};

/// Whether a rate is real. It is real if its disc meets the real axis and no other disc meets the mirror image of its
/// disc, because the mirror image contains the conjugate of the rate, which is a rate, too.
bool is_real(const Split& theta, std::size_t number) {
  for (mpfr_prec_t bits = 128;; bits *= 2) {
    const Terms all = theta.at(bits);
    if (mpfi_has_zero(all[number].rate.im.get()) <= 0) return false;
    bool alone = true;
    for (std::size_t i = 0; i < all.size(); ++i)
      alone = alone && (i == number || !may_be_pair(all[number], all[i]));
    if (alone) return true;
  }
}

void check_number(int number, int first, int last) {
  if (number >= first && number <= last) return;
  throw data::BadInput("term", std::to_string(number),
                       "must be a whole number from " + std::to_string(first) + " to " +
                           std::to_string(last) + ", the number of terms");
}

Enclosure part_of(const Split& theta, int number, ComplexInterval OscillatingTerm::*member, ComplexPart part,
                  int digits) {
  const auto index = static_cast<std::size_t>(number - 1);
  if (part == ComplexPart::im && is_real(theta, index)) return exact_zero(digits);
  return enclose(digits, 0, [&](double nats) {
    const ComplexInterval value =
        theta.at(static_cast<mpfr_prec_t>(128 + nats / std::numbers::ln2))[index].*member;
    return part == ComplexPart::re ? value.re : value.im;
  });
}

}  // namespace

Enclosure relaxation_amplitude(const ExactRatio& theta, int number, ComplexPart part, int digits) {
  const Split split(theta);
  check_number(number, 0, split.terms());
  if (number > 0) return part_of(split, number, &OscillatingTerm::amplitude, part, digits);
  return exactly(part == ComplexPart::im ? mpq_class(0) : split.at_once, digits);
}

Enclosure relaxation_rate(const ExactRatio& theta, int number, ComplexPart part, int digits) {
  const Split split(theta);
  check_number(number, 1, split.terms());
  return part_of(split, number, &OscillatingTerm::rate, part, digits);
}

}  // namespace nipref::ref
