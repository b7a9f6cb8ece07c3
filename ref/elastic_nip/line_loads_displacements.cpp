#include <algorithm>
#include <cmath>
#include <optional>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/elastic_nip/line_loads_displacements.hpp>
#include <nipref/ref/number/internal/float_interval.hpp>
#include <nipref/ref/sheet/internal/kernel_over.hpp>

namespace nipref::ref {
namespace {

constexpr int guard_digits = 10;

/// Line loads and a place.
struct Sums {
  const data::ElasticNip& nip;
  const LineLoadSolution& solution;
  int residue_terms, digits;
  Interval y;

  [[nodiscard]] mpfr_prec_t precision() const { return y.precision(); }
  [[nodiscard]] Interval number(double value) const { return {value, precision()}; }
  [[nodiscard]] Interval poisson() const { return number(nip.material.poisson); }
  [[nodiscard]] Interval theta1() const { return (poisson() + 1L) / number(nip.material.young); }
  [[nodiscard]] Interval theta2() const { return theta1() * (1 - 2 * poisson()); }

  /// Of Y from the k-th load of the side Y > 0 (sign -1) or Y < 0 (1), in half-thicknesses.
  [[nodiscard]] Interval distance(std::size_t k, long sign) const {
    const auto count = static_cast<long>(solution.line_loads.size());
    const Interval width = interval_of(solution.contact_length) / (4 * count);
    const Interval position = (2 * static_cast<long>(k) + 1) * width;
    return 2 * (y + sign * position) / number(nip.sheet_thickness);
  }
  /// sum of load * (kernel at the near load + far_sign * kernel at its image)
  template <class Kernel>
  [[nodiscard]] Interval over(const std::vector<Enclosure>& loads, long far_sign,
                              const Kernel& kernel) const {
    Interval sum(precision());
    for (std::size_t k = 0; k < loads.size(); ++k) {
      const Interval both = kernel(distance(k, -1)) + far_sign * kernel(distance(k, 1));
      sum = sum + interval_of(loads[k]) * both;
    }
    return sum;
  }
  [[nodiscard]] Interval kernel(SheetKernel which, const Interval& alpha) const {
    return kernel_over(which, alpha, residue_terms, digits + guard_digits);
  }
  /// N I(alpha) of an even kernel.
  [[nodiscard]] auto even(SheetKernel which) const {
    return [this, which](const Interval& alpha) { return (theta1() + theta2()) * kernel(which, alpha); };
  }
  /// N I3 - theta2 I2.
  [[nodiscard]] auto step() const {
    return [this](const Interval& alpha) {
      const Interval half_pi = Interval::pi(precision()) / 2;
      const Interval part = theta2() * (mpfr_sgn(alpha.upper()) < 0 ? -half_pi : half_pi);
      return (theta1() + theta2()) * kernel(SheetKernel::I3, alpha) - part;
    };
  }
  [[nodiscard]] Interval normal() const {
    const Interval sum = over(solution.line_loads, 1, even(SheetKernel::I1));
    return (sum - over(solution.shear_loads, -1, step())) / Interval::pi(precision());
  }
  [[nodiscard]] Interval tangential() const {
    const Interval sum = over(solution.line_loads, 1, step());
    return (sum + over(solution.shear_loads, -1, even(SheetKernel::I6))) / Interval::pi(precision());
  }
};

Sums sums_at(const data::ElasticNip& nip, const LineLoadSolution& solution, const LineLoadMethod& method,
             const Interval& y, int digits) {
  nip.check();
  return {nip, solution, method.residue_terms, digits, y};
}

Interval place(const LineLoadSolution& solution, double y) {
  if (!std::isfinite(y)) throw data::BadInput("y", y, "must be finite");
  return {y, interval_of(solution.contact_length).precision()};
}

Enclosure of_element(const std::vector<Enclosure>& loads, const LineLoadSolution& solution, double y,
                     int digits) {
  constexpr double border = 1 + 0x1p-50;
  if (!std::isfinite(y)) throw data::BadInput("y", y, "must be finite");
  const double length = solution.contact_length.to_double();
  if (loads.empty() || std::fabs(y) > length / 2 * border) return exact_zero(digits);
  const auto element =
      static_cast<std::size_t>(std::fabs(y) / length * 2 * static_cast<double>(loads.size()) * border);
  const Interval force = interval_of(loads[std::min(element, loads.size() - 1)]);
  const Interval density = 2 * static_cast<long>(loads.size()) * force / interval_of(solution.contact_length);
  return enclosure_of(density, digits);
}

/// From so many widths of elements to so many, of which one side has `elements`, to both ends.
Enclosure between_widths(const LineLoadSolution& solution, std::size_t elements, const mpq_class& first,
                         const mpq_class& last, int digits) {
  const Interval length = interval_of(solution.contact_length);
  const auto at = [&](const mpq_class& widths) {
    return Interval(Exact(widths), length.precision()) * length / (2 * static_cast<long>(elements));
  };
  return enclosure_of(hull(at(first), at(last)), digits);
}

/// Of the centres of these elements of one side.
Enclosure place_of_largest(const std::vector<Interval>& sizes, const LineLoadSolution& solution, int digits) {
  const auto surest = std::ranges::max_element(
      sizes, [](const Interval& a, const Interval& b) { return mpfr_less_p(a.lower(), b.lower()) != 0; });
  const auto may_be_largest = [&](const Interval& size) {
    return mpfr_greaterequal_p(size.upper(), surest->lower()) != 0;
  };
  const auto first = std::ranges::find_if(sizes, may_be_largest) - sizes.begin();
  const auto last = std::find_if(sizes.rbegin(), sizes.rend(), may_be_largest).base() - sizes.begin();
  return between_widths(solution, sizes.size(), mpq_class(2 * first + 1, 2), mpq_class(2 * last - 1, 2),
                        digits);
}

}  // namespace

Enclosure place_of_largest_pressure(const LineLoadSolution& solution, int digits) {
  std::vector<Interval> sizes;
  for (const Enclosure& load : solution.line_loads) sizes.push_back(interval_of(load));
  return place_of_largest(sizes, solution, digits);
}

Enclosure place_of_largest_shear(const LineLoadSolution& solution, int digits) {
  std::vector<Interval> sizes;
  for (const Enclosure& load : solution.shear_loads) {
    const Interval force = interval_of(load);
    sizes.push_back(mpfr_sgn(force.upper()) < 0 ? -force : force);
  }
  return place_of_largest(sizes, solution, digits);
}

std::vector<Enclosure> shear_borders(const LineLoadSolution& solution, int digits) {
  std::vector<Enclosure> borders;
  const auto& loads = solution.shear_loads;
  if (!loads.empty()) borders.push_back(exact_zero(digits));
  std::optional<std::size_t> last_with_sign;
  int last_sign = 0;
  for (std::size_t k = 0; k < loads.size(); ++k) {
    const Interval force = interval_of(loads[k]);
    const int sign = mpfr_sgn(force.lower()) > 0 ? 1 : mpfr_sgn(force.upper()) < 0 ? -1 : 0;
    if (sign == 0) continue;
    if (last_with_sign && sign != last_sign)
      borders.push_back(between_widths(solution, loads.size(), *last_with_sign + 1, k, digits));
    last_with_sign = k;
    last_sign = sign;
  }
  return borders;
}

std::vector<FaceLoad> face_loads(const LineLoadSolution& solution, int digits) {
  const std::size_t count = solution.line_loads.size();
  std::vector<FaceLoad> all;
  for (std::size_t k = 0; k < count; ++k) {
    const mpq_class widths(2 * static_cast<long>(k) + 1, 2);
    const Estimate y = between_widths(solution, count, widths, widths, digits);
    const Estimate shear = solution.shear_loads.empty() ? exact_zero(digits) : solution.shear_loads[k];
    all.push_back({y, solution.line_loads[k], shear});
    all.push_back({-1 * y, solution.line_loads[k], -1 * shear});
  }
  return all;
}

Enclosure normal_displacement(const data::ElasticNip& nip, const LineLoadSolution& solution,
                              const LineLoadMethod& method, double y, int digits) {
  return enclosure_of(sums_at(nip, solution, method, place(solution, y), digits).normal(), digits);
}

Enclosure tangential_displacement(const data::ElasticNip& nip, const LineLoadSolution& solution,
                                  const LineLoadMethod& method, double y, int digits) {
  if (y == 0) return exact_zero(digits);
  return enclosure_of(sums_at(nip, solution, method, place(solution, y), digits).tangential(), digits);
}

Enclosure creep_ratio(const data::ElasticNip& nip, const LineLoadSolution& solution,
                      const LineLoadMethod& method, int digits) {
  if (solution.gripped_creep) return *solution.gripped_creep;
  const Interval end = interval_of(solution.contact_length) / 2;
  return enclosure_of(sums_at(nip, solution, method, end, digits).tangential() / end, digits);
}

Enclosure element_pressure(const LineLoadSolution& solution, double y, int digits) {
  return of_element(solution.line_loads, solution, y, digits);
}

Enclosure element_shear(const LineLoadSolution& solution, double y, int digits) {
  Enclosure shear = of_element(solution.shear_loads, solution, y, digits);
  if (y < 0) mpfr_neg(raw(shear.value), raw(shear.value), MPFR_RNDN);
  return shear;
}

}  // namespace nipref::ref
