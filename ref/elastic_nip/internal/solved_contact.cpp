#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/elastic_nip/internal/solved_contact.hpp>
#include <nipref/ref/number/internal/float_interval.hpp>

namespace nipref::ref {
namespace {

constexpr int most_terms = 2200;
constexpr int most_steps = 30;    ///< of the search for a length
constexpr int first_digits = 12;  ///< of a length before it is checked

/// The terms that give `expansion` digits; BadInput if they are too many, with the digits that are not.
int checked_size(double half_length, int expansion, int digits) {
  const int size = size_for(half_length, expansion);
  if (size <= most_terms) return size;
  int fewer = digits;
  while (fewer > 0 && size_for(half_length, expansion - digits + fewer) > most_terms) --fewer;
  throw data::BadInput(
      "digits", std::to_string(digits),
      fmt::format("must be fewer for a contact of {:.6g} sheet thicknesses: with {} terms, the most that are "
                  "tried, its expansion is good to {}",
                  half_length, most_terms, fewer));
}

/// A radius of the coefficients reaches displacements times (1 + A) or so. A length found for a load ends
/// between doubles: at the one next to the end half of its digits count. Kernel values are summed over the
/// terms twice, and divided by the least eigenvalue.
ContactPrecision precision_for(double half_length, int digits, bool for_load) {
  const int expansion =
      digits + (for_load ? 8 : 2) + static_cast<int>(std::ceil(std::log10(1 + half_length)));
  const double size = size_for(half_length, expansion);
  const int kernel = expansion + 4 + static_cast<int>(std::ceil(3 * std::log10(size)));
  return {expansion, kernel, kernel + 4};
}

/// pi A^2 c_0.
Float load_of(const ChebyshevSystem& system, const Vector& c) {
  return pi() * system.half_length() * system.half_length() * c(0);
}

/// d ln W/d ln A = 2 (sum mu c_m)^2/c_0: dW/dA goes with the square of how p' grows at the ends.
Float growth_of(const Vector& c) {
  Float sum = 0;
  for (Matrix::Index m = 0; m < c.size(); ++m) sum += (2 * m + 1) * c(m);
  return 2 * sum * sum / c(0);
}

/// Newton's step for ln W as a function of ln A, as a factor of A.
Float length_factor(const ChebyshevSystem& system, const Vector& c, const Float& load) {
  return exp(log(load / load_of(system, c)) / growth_of(c));
}

/// The half length that carries a load, to about so many digits, from one good to `known`: half of them
/// first. Nothing is proven.
Float improved_half_length(const Float& load, double near, int known, int digits, SmoothKernel& kernel) {
  Float half_length =
      digits <= 2 * known ? Float(near) : improved_half_length(load, near, known, digits / 2 + 1, kernel);
  const Float enough = pow(Float(10), -digits);
  Float change = 1;
  for (int step = 0; step < most_steps && change * change > enough; ++step) {
    const int size = checked_size(static_cast<double>(half_length), digits, digits);
    const ChebyshevSystem system(half_length, size, kernel);
    const Float factor = length_factor(system, system.solution(), load);
    half_length *= factor;
    change = factor - 1;
  }
  return half_length;
}

}  // namespace

SolvedContact::SolvedContact(int digits, const ContactPrecision& precision, NormalKernel kernel)
    : digits_(digits),
      precision_(precision),
      kernel_(std::make_unique<SmoothKernel>(std::move(kernel), precision.kernel)) {}

void SolvedContact::finish(const ChebyshevSystem& system, const Vector& coefficients,
                           const Interval& half_length) {
  functionals_ = std::make_unique<ContactFunctionals>(prove(system, coefficients, half_length), *kernel_,
                                                      precision_.kernel * std::numbers::ln10);
}

SolvedContact SolvedContact::of_half_length(const Exact& half_length, int digits, NormalKernel kernel) {
  const double near = half_length.approximate();
  SolvedContact contact(digits, precision_for(near, digits, false), std::move(kernel));
  const WorkingDigits working(contact.working_digits());
  const int size = checked_size(near, contact.precision_.expansion, digits);
  const ChebyshevSystem system(to_float(half_length), size, *contact.kernel_);
  contact.finish(system, system.solution(), Interval(half_length, working_bits()));
  return contact;
}

int SolvedContact::terms_of(double half_length, int digits) {
  return checked_size(half_length, precision_for(half_length, digits, false).expansion, digits);
}

SolvedContact SolvedContact::of_load(const Exact& load, double guess,
                                     const std::function<void(double half_length)>& check, int digits,
                                     NormalKernel kernel) {
  SolvedContact contact(digits, precision_for(guess, digits, true), std::move(kernel));
  const WorkingDigits working(contact.working_digits());
  const int expansion = contact.precision_.expansion;
  const Float wanted = to_float(load);
  const Float enough = pow(Float(10), -expansion);
  const auto near =
      static_cast<double>(improved_half_length(wanted, guess, 1, first_digits, *contact.kernel_));
  check(near);
  Float half_length =
      improved_half_length(wanted, near, first_digits - 1, expansion / 2 + 2, *contact.kernel_);
  for (int step = 0;; ++step) {
    const int size = checked_size(static_cast<double>(half_length), expansion, digits);
    const ChebyshevSystem system(half_length, size, *contact.kernel_);
    const Vector coefficients = system.solution();
    const Float factor = length_factor(system, coefficients, wanted);
    if (abs(factor - 1) > enough && step < most_steps) {
      half_length *= factor;
      continue;
    }
    // The length lies between this one and what W(lA) >= l^2 W(A) makes of it.
    const Interval here = interval_of(half_length);
    contact.finish(system, coefficients, here);
    const Interval there = here * sqrt(Interval(load, working_bits()) / contact->load());
    contact.finish(system, coefficients, hull(here, there));
    return contact;
  }
}

}  // namespace nipref::ref
