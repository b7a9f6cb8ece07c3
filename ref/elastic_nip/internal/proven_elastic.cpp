#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/ref/elastic_nip/internal/proven_elastic.hpp>
#include <nipref/ref/elastic_nip/internal/proven_expansion.hpp>
#include <nipref/ref/number/internal/float_interval.hpp>

namespace nipref::ref {
namespace {

constexpr int most_steps = 30;    ///< of the search for a length
constexpr int first_digits = 12;  ///< of a length before it is checked

/// How many digits each part of a solution is computed to.
struct ContactPrecision {
  int expansion;  ///< the coefficients' radius
  int kernel;     ///< after the point
  int working;
};

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
    const int size = size_for(static_cast<double>(half_length), digits);
    const ChebyshevSystem system(half_length, size, kernel);
    const Float factor = length_factor(system, system.solution(), load);
    half_length *= factor;
    change = factor - 1;
  }
  return half_length;
}

ProvenContact contact_of(const ChebyshevSystem& system, const Vector& coefficients,
                         const Interval& half_length, const std::shared_ptr<SmoothKernel>& kernel,
                         const ContactPrecision& precision) {
  return {prove(system, coefficients, half_length), kernel, precision.kernel * std::numbers::ln10};
}

}  // namespace

int proven_elastic_terms(double half_length, int digits) {
  return size_for(half_length, precision_for(half_length, digits, false).expansion);
}

std::optional<Proof> proven_elastic(const Exact& half_length, int digits, const NormalKernel& kernel,
                                    int most_terms) {
  const double near = half_length.approximate();
  const int size = proven_elastic_terms(near, digits);
  if (size > most_terms) return std::nullopt;
  const ContactPrecision precision = precision_for(near, digits, false);
  const WorkingDigits working(precision.working);
  const auto smooth = std::make_shared<SmoothKernel>(kernel, precision.kernel);
  const ChebyshevSystem system(to_float(half_length), size, *smooth);
  return Proof{
      contact_of(system, system.solution(), Interval(half_length, working_bits()), smooth, precision),
      precision.working};
}

std::optional<Proof> proven_elastic_for_load(const Exact& load, double guess,
                                             const std::function<bool(double half_length)>& is_allowed,
                                             int digits, const NormalKernel& kernel, int most_terms) {
  const ContactPrecision precision = precision_for(guess, digits, true);
  const WorkingDigits working(precision.working);
  const auto smooth = std::make_shared<SmoothKernel>(kernel, precision.kernel);
  const Float wanted = to_float(load), enough = pow(Float(10), -precision.expansion);
  const auto near = static_cast<double>(improved_half_length(wanted, guess, 1, first_digits, *smooth));
  if (!is_allowed(near) || size_for(near, precision.expansion) > most_terms) return std::nullopt;
  Float half_length =
      improved_half_length(wanted, near, first_digits - 1, precision.expansion / 2 + 2, *smooth);
  for (int step = 0;; ++step) {
    const int size = size_for(static_cast<double>(half_length), precision.expansion);
    const ChebyshevSystem system(half_length, size, *smooth);
    const Vector coefficients = system.solution();
    const Float factor = length_factor(system, coefficients, wanted);
    if (abs(factor - 1) > enough && step < most_steps) {
      half_length *= factor;
      continue;
    }
    // The length lies between this one and what W(lA) >= l^2 W(A) makes of it.
    const Interval here = interval_of(half_length);
    const Interval found = contact_of(system, coefficients, here, smooth, precision).load();
    const Interval there = here * sqrt(Interval(load, working_bits()) / found);
    return Proof{contact_of(system, coefficients, hull(here, there), smooth, precision), precision.working};
  }
}

}  // namespace nipref::ref
