#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/ref/elastic_nip/internal/proven_elastic.hpp>
#include <nipref/ref/nip/internal/chebyshev_system.hpp>
#include <nipref/ref/nip/internal/contact_bounds.hpp>
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

/// A contact that is solved, but not proven.
struct SolvedSystem {
  ChebyshevSystem system;
  SlopeSeries right;
  std::vector<Float> c;

  SolvedSystem(const Float& half_length, int size, SmoothKernel& kernel)
      : system(std::move(ChebyshevSystem::of_half_length(half_length, size, kernel, false).front())),
        right(SlopeSeries::line(size)),
        c(system.solution(right)) {}

  /// Newton's step for ln W as a function of ln A, as a factor of A: W = pi A^2 c_1 and d ln W/d ln A = 2 (sum m c_m)^2/c_1,
  /// as dW/dA goes with the square of how p' grows at the ends.
  [[nodiscard]] Float length_factor(const Float& load) const {
    Float sum = 0;
    for (std::size_t m = 1; m < c.size(); m += 2) sum += m * c[m];
    const Float growth = 2 * sum * sum / c[1];
    return exp(log(load / (pi() * system.half_length() * system.half_length() * c[1])) / growth);
  }
  [[nodiscard]] Proof proven(const Interval& half_length, const Exact& beta,
                             const std::shared_ptr<SmoothKernel>& kernel,
                             const ContactPrecision& precision) const {
    return {std::make_shared<const ProvenContact>(system.proven(c, right, half_length), beta, kernel,
                                                  precision.kernel * std::numbers::ln10),
            precision.working};
  }
};

/// The half length that carries a load, to about so many digits, from one good to `known`: half of them
/// first. Nothing is proven.
Float improved_half_length(const Float& load, double near, int known, int digits, SmoothKernel& kernel) {
  Float half_length =
      digits <= 2 * known ? Float(near) : improved_half_length(load, near, known, digits / 2 + 1, kernel);
  const Float enough = pow(Float(10), -digits);
  Float change = 1;
  for (int step = 0; step < most_steps && change * change > enough; ++step) {
    const int size = size_for(static_cast<double>(half_length), digits);
    const Float factor = SolvedSystem(half_length, size, kernel).length_factor(load);
    half_length *= factor;
    change = factor - 1;
  }
  return half_length;
}

}  // namespace

int proven_elastic_terms(double half_length, int digits) {
  return size_for(half_length, precision_for(half_length, digits, false).expansion);
}

std::optional<Proof> proven_elastic(const Exact& half_length, const Exact& beta, int digits,
                                    const NormalKernel& kernel, int most_terms) {
  const double near = half_length.approximate();
  const int size = proven_elastic_terms(near, digits);
  if (size > most_terms) return std::nullopt;
  const ContactPrecision precision = precision_for(near, digits, false);
  const WorkingDigits working(precision.working);
  const auto smooth = std::make_shared<SmoothKernel>(kernel, precision.kernel);
  const SolvedSystem solved(to_float(half_length), size, *smooth);
  return solved.proven(Interval(half_length, working_bits()), beta, smooth, precision);
}

std::optional<Proof> proven_elastic_for_load(const Exact& load, double guess,
                                             const std::function<bool(double half_length)>& is_allowed,
                                             const Exact& beta, int digits, const NormalKernel& kernel,
                                             int most_terms) {
  const ContactPrecision precision = precision_for(guess, digits, true);
  const WorkingDigits working(precision.working);
  const auto smooth = std::make_shared<SmoothKernel>(kernel, precision.kernel);
  const Float wanted = to_float(load);
  const auto near = static_cast<double>(improved_half_length(wanted, guess, 1, first_digits, *smooth));
  const int size = size_for(near, precision.expansion);
  if (!is_allowed(near) || size > most_terms) return std::nullopt;
  const SolvedSystem solved(
      improved_half_length(wanted, near, first_digits - 1, precision.expansion, *smooth), size, *smooth);
  // The length lies between this one and what W(lA) >= l^2 W(A) makes of it.
  const Interval here = interval_of(solved.system.half_length());
  const Interval found = solved.proven(here, beta, smooth, precision).contact->load();
  const Interval there = here * sqrt(Interval(load, working_bits()) / found);
  return solved.proven(hull(here, there), beta, smooth, precision);
}

}  // namespace nipref::ref
