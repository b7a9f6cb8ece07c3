#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/ref/elastic_nip/internal/proven_elastic.hpp>
#include <nipref/ref/nip/internal/chebyshev_system.hpp>
#include <nipref/ref/nip/internal/length_search.hpp>
#include <nipref/ref/nip/internal/proven_contact.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {
namespace {

constexpr int first_digits = 12;  ///< digits to which a length is found before it is checked

/// How many digits each part of a solution is computed to.
struct ContactPrecision {
  int expansion;  ///< digits of the coefficients' radius
  int kernel;     ///< digits after the point
  int working;
};

/// The radius of the coefficients enters displacements times about 1 + A. A contact of given load ends between doubles.
/// At the double next to the end the pressure, like the root of the distance, loses half of a double's digits. Kernel
/// values are summed over the terms twice, and divided by the least eigenvalue.
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
      : system(half_length, size, kernel, false), right(SlopeSeries::line(size)), c(system.solution(right)) {}

  [[nodiscard]] Float load() const { return pi() * system.half_length() * system.half_length() * c[1]; }
  /// d ln W/d ln A = 2 (sum m c_m)^2/c_1: dW/dA is proportional to K^2, where p is K sqrt(distance) near the ends.
  [[nodiscard]] Float growth() const {
    Float sum = 0;
    for (std::size_t m = 1; m < c.size(); m += 2) sum += m * c[m];
    return 2 * sum * sum / c[1];
  }
  [[nodiscard]] Proof proven(const Interval& half_length, const Exact& beta,
                             const std::shared_ptr<SmoothKernel>& kernel,
                             const ContactPrecision& precision) const {
    return {std::make_shared<const ProvenContact>(system.proven(c, right, half_length), beta, kernel,
                                                  precision.kernel * std::numbers::ln10),
            precision.working};
  }
};

/// Finds the half length to about `digits` digits, from one with `known` digits by way of half. Nothing is proven.
void seek(LengthSearch& search, int known, int digits, SmoothKernel& kernel) {
  if (digits > 2 * known) seek(search, known, digits / 2 + 1, kernel);
  search.seek(digits, [&](const Lengths& at) {
    return std::make_optional<SolvedSystem>(at.length, size_for(static_cast<double>(at.length), digits),
                                            kernel);
  });
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
  LengthSearch search{load, Float(guess)};
  seek(search, 1, first_digits, *smooth);
  const auto near = static_cast<double>(search.length);
  const int size = size_for(near, precision.expansion);
  if (!is_allowed(near) || size > most_terms) return std::nullopt;
  seek(search, first_digits - 1, precision.expansion, *smooth);
  const SolvedSystem solved(search.length, size, *smooth);
  // The length lies between `here` and `there`, as W(lA) >= l^2 W(A).
  const Interval here = interval_of(solved.system.half_length());
  const Interval found = solved.proven(here, beta, smooth, precision).contact->load();
  const Interval there = here * sqrt(Interval(load, working_bits()) / found);
  return solved.proven(hull(here, there), beta, smooth, precision);
}

}  // namespace nipref::ref
