#include <array>
#include <string>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/sheet/internal/plain_terms.hpp>

namespace nipref::ref {

ComplexInterval plain_coefficient(PlainKernel kernel, const SheetPole& pole) {
  // In the order of PlainKernel.
  constexpr std::array<PoleCoefficient, 7> all{
      {{1, 1, 4}, {1, 0, 2}, {-1, 0, 3}, {1, 0, 1}, {1, -1, 0}, {-1, -1, 1}, {-1, 1, 3}}};
  return twice(all[static_cast<std::size_t>(kernel)], pole);
}

void check_residue_terms(int terms) {
  if (terms >= 1 && terms <= most_residue_terms) return;
  throw data::BadInput("terms", std::to_string(terms),
                       "must be from 1 to " + std::to_string(most_residue_terms));
}

bool is_negligible(int n, const Interval& x, mpfr_prec_t precision, Interval& bound) {
  bound = 1100 * exp(-((2L * n - 1) * (Interval::pi(x.precision()) * x) / 2));
  return mpfr_zero_p(bound.upper()) != 0 || mpfr_get_exp(bound.upper()) < -precision;
}

}  // namespace nipref::ref
