#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/elastic_nip/line_loads.hpp>
#include <nipref/ref/nip/internal/solved_line_loads.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>
#include <nipref/ref/number/interval.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/sheet/kernels.hpp>
#include <nipref/ref/sheet/plain_series.hpp>

namespace nipref::ref {
namespace {

using data::BadInput;
using data::LineLoadFriction;

/// Extra digits of the kernels. A system that needs more of them counts as singular.
constexpr ExtraDigits extra_kernel_digits{12, 400};

struct Problem {
  const data::ElasticNip& nip;
  LineLoadMethod method;
  LineLoadFriction friction;
  std::span<const double> given_I1 = {};  ///< values of I1 at odd multiples, if they are given

  [[nodiscard]] bool sticks() const { return friction.kind != LineLoadFriction::Kind::none; }
  [[nodiscard]] int elements() const { return method.elements_per_side; }
};

/// theta2/N I2 at a positive distance.
Interval theta2_part(const data::ElasticNip& nip) {
  const Interval share(ThetaShares(Exact(nip.material.poisson)).theta2, working_bits());
  return share / 2 * Interval::pi(working_bits());
}

/// N/pi: displacements are this factor times the sum of loads times kernels.
Interval compliance_over_pi(const data::ElasticNip& nip) {
  const Exact young(nip.material.young), poisson(nip.material.poisson);
  return Interval(normal_compliance(young, poisson), working_bits()) / Interval::pi(working_bits());
}

Enclosure kernel_at(PlainKernel kernel, const Exact& alpha, int digits) {
  if (kernel == PlainKernel::I1) return I1(alpha, digits);
  return kernel == PlainKernel::I3 ? I3(alpha, digits) : I6(alpha, Exact(0.0), digits);
}

/// Contains the values of I1, I3 or I6_alpha_part on an interval of arguments. Its width is about 10^-digits plus the
/// effect of the argument's width, |alpha dI/dalpha| < 2 (1 + |alpha|). residue_terms is 0, or the number of terms of
/// plain_series(), which then replaces the kernel.
Interval kernel_over(PlainKernel kernel, const Interval& alpha, int residue_terms, int digits) {
  if (sign_of(alpha) == 0)
    throw BadInput("y", mpfi_get_d(alpha.get()), "must not be the place of a line load");
  if (residue_terms > 0) return plain_series(kernel, alpha, residue_terms);
  const Interval size = abs(alpha), slope = 2 * (size + 1L) / size;
  const Float middle = middle_of(alpha);
  const Enclosure value = kernel_at(kernel, to_exact(middle), digits);
  return interval_of(value.value, alpha.precision())
      .widened(interval_of(value.error))
      .widened(slope * distance_from(middle, alpha));
}

/// The values of a kernel at 1, 3 .. 4m - 1 times the half width of an element over the half-thickness.
std::vector<Interval> evaluate(const Problem& problem, const Lengths& lengths, PlainKernel kernel,
                               int digits) {
  const Interval half_element = lengths.interval() / (4L * problem.elements()),
                 unit = 2 * half_element / Interval(problem.nip.sheet_thickness, working_bits());
  std::vector<Interval> values;
  for (const double value : problem.given_I1) values.emplace_back(value, working_bits());
  for (int q = 0; q < 2 * problem.elements() && problem.given_I1.empty(); ++q)
    values.push_back(kernel_over(kernel, (2L * q + 1) * unit, problem.method.residue_terms, digits));
  return values;
}

/// The value of a kernel at the magnitude of an odd multiple.
const Interval& at(const std::vector<Interval>& values, int odd_multiple) {
  return values[static_cast<std::size_t>(std::abs(odd_multiple) / 2)];
}

/// Unknowns: d0 and the normal loads of a side. Rows: the normal displacements at i = 0 .. m. With friction also the
/// shear loads, and the rows v = creep Y at i = 1 .. m. The right-hand sides are the roller's shape and a creep of 1.
NearlyKnownSystem system_of(const Problem& problem, const Lengths& lengths, int digits) {
  const int m = problem.elements();
  const auto of = [&](PlainKernel kernel) { return evaluate(problem, lengths, kernel, digits); };
  using Values = std::vector<Interval>;
  const Values normal = of(PlainKernel::I1),
               tangential = problem.sticks() ? of(PlainKernel::I6_alpha_part) : Values(),
               coupling = problem.sticks() ? of(PlainKernel::I3) : Values();
  const Interval part = theta2_part(problem.nip);
  const auto coupling_at = [&](int multiple) {
    const Interval value = at(coupling, multiple) - part;
    return multiple > 0 ? value : -value;
  };
  auto system =
      problem.sticks() ? NearlyKnownSystem::of_size(2 * m + 1, 2) : NearlyKnownSystem::of_size(m + 1, 1);
  const Interval diameter = 2 * Interval(problem.nip.roller_radius, working_bits());
  for (int i = 0; i <= m; ++i) {
    // The collocation point, 2 i a.
    const Interval place = i * lengths.interval() / (2L * m);
    system.set_right(i, 0, square(place) / diameter);
    system.matrix(i, 0) = 1;
    if (problem.sticks() && i > 0) system.set_right(m + i, 1, place);
    for (int k = 1; k <= m; ++k) {
      const int near = 2 * (i - k) + 1, far = 2 * (i + k) - 1;
      system.set(i, k, -(at(normal, near) + at(normal, far)));
      if (!problem.sticks()) continue;
      system.set(i, m + k, coupling_at(near) - coupling_at(far));
      if (i == 0) continue;
      system.set(m + i, k, coupling_at(near) + coupling_at(far));
      system.set(m + i, m + k, at(tangential, near) - at(tangential, far));
    }
  }
  return system;
}

/// A unit normal load causes u = N/pi I1 and v = N/pi (I3 - theta2/N I2), a shear load u = -N/pi (I3 - theta2/N I2) and
/// v = N/pi I6.
UnderLoad displacement_by(const data::ElasticNip& nip, int residue_terms, int digits) {
  return [=](const SolvedLineLoads& loads, std::size_t load, const LineLoadPlace& place, bool is_normal) {
    const mpfr_prec_t bits = working_bits();
    const Interval alpha = 2 * loads.distance(load, place) / Interval(nip.sheet_thickness, bits);
    const auto kernel = [&](PlainKernel which) { return kernel_over(which, alpha, residue_terms, digits); };
    const auto coupling = [&] {
      const Interval part = theta2_part(nip);
      return kernel(PlainKernel::I3) - (sign_of(alpha) < 0 ? -part : part);
    };
    Interval sum = loads.normal[load] * (is_normal ? kernel(PlainKernel::I1) : coupling());
    if (!loads.shear.empty())
      sum = sum + loads.shear[load] * (is_normal ? -coupling() : kernel(PlainKernel::I6_alpha_part));
    return compliance_over_pi(nip) * sum;
  };
}

/// The loads of both sides, from N/pi times the loads of one side.
std::vector<Interval> both_sides(const Interval& unit, std::span<const Interval> side, long sign) {
  std::vector<Interval> loads;
  for (std::size_t k = side.size(); k-- > 0;) loads.push_back(unit * side[k]);
  for (const Interval& load : side) loads.push_back(sign * (unit * load));
  return loads;
}

SolvedLineLoads contact_of(const Problem& problem, const Lengths& lengths, const EnclosedSolutions& solved,
                           const std::vector<Interval>& unknowns, int digits) {
  const auto m = static_cast<std::size_t>(problem.elements());
  const Interval unit = 1 / compliance_over_pi(problem.nip);
  const std::span loads = std::span(unknowns).subspan(1);
  return {.roller_radius = problem.nip.roller_radius,
          .leading_elements = problem.elements(),
          .is_symmetric = true,
          .contact_length = lengths.interval(),
          .indentation = unknowns.front(),
          .normal = both_sides(unit, loads.first(m), 1),
          .shear = both_sides(unit, loads.subspan(m), -1),
          .error = solved.error / solved.largest,
          .condition = solved.condition,
          .unknowns = static_cast<int>(unknowns.size()),
          .under = displacement_by(problem.nip, problem.method.residue_terms, digits)};
}

/// Nothing if the precision does not suffice to prove a bound, or which creep is the thesis's.
std::optional<SolvedLineLoads> solve(const Problem& problem, const Lengths& lengths, int digits) {
  auto solved = enclosed_solutions(system_of(problem, lengths, digits));
  if (!solved) return std::nullopt;
  if (!problem.sticks()) return contact_of(problem, lengths, *solved, solved->unknowns.front(), digits);
  const std::vector<Interval>&at_zero = solved->unknowns.front(), &per_creep = solved->unknowns.back();
  const std::vector<Interval> loads_at_zero(at_zero.begin() + 1, at_zero.end()),
      loads_per_creep(per_creep.begin() + 1, per_creep.end());
  std::optional<Interval> creep;
  if (problem.friction.kind == LineLoadFriction::Kind::given_creep)
    creep = Interval(problem.friction.creep, working_bits());
  else if (const auto chosen = thesis_creep(loads_at_zero, loads_per_creep))
    creep = chosen->chosen;
  if (!creep) return std::nullopt;
  std::vector<Interval> unknowns;
  solved->error = solved->largest = 0;
  for (std::size_t i = 0; i < at_zero.size(); ++i) {
    unknowns.push_back(at_zero[i] + *creep * per_creep[i]);
    const Float middle = middle_of(unknowns[i]);
    solved->largest = std::max<Float>(solved->largest, abs(middle));
    solved->error = std::max<Float>(solved->error, upper_end(distance_from(middle, unknowns[i])));
  }
  SolvedLineLoads contact = contact_of(problem, lengths, *solved, unknowns, digits);
  contact.gripped_creep = creep;
  contact.at_zero = loads_at_zero;
  contact.per_creep = loads_per_creep;
  return contact;
}

void check_digits_and_elements(const Problem& problem, int digits) {
  problem.nip.check();
  const auto [elements, terms] = problem.method;
  if (elements < 1 || elements > 200)
    throw BadInput("elements_per_side", std::to_string(elements), "must be from 1 to 200 in the reference");
  if (terms < 0 || terms > most_residue_terms)
    throw BadInput("residue_terms", std::to_string(terms),
                   "must be from 0 to " + std::to_string(most_residue_terms));
  if (digits < 16 || digits > 300) throw BadInput("digits", std::to_string(digits), "must be from 16 to 300");
  if (!std::isfinite(problem.friction.creep))
    throw BadInput("creep", problem.friction.creep, "must be finite");
}

/// In sheet thicknesses: no two places are farther apart than the reference's kernels reach, 1000 half-thicknesses.
constexpr double longest_length = 500;

void check(const Problem& problem, double contact_length, int digits) {
  check_digits_and_elements(problem, digits);
  if (!(contact_length > 0 && contact_length / problem.nip.sheet_thickness <= longest_length)) {
    throw BadInput("contact_length", contact_length,
                   "must be > 0 and at most 500 sheet thicknesses in the reference");
  }
}

std::optional<LineLoadNip> solution_of_length(const Problem& problem, double contact_length, int digits) {
  return solved_to(digits, extra_kernel_digits,
                   [&](int kernel_digits) { return solve(problem, {Float(contact_length)}, kernel_digits); });
}

}  // namespace

LineLoadNip line_loads_for_length(const data::ElasticNip& nip, const LineLoadMethod& method,
                                  double contact_length, int digits, const data::LineLoadFriction& friction) {
  const Problem problem{nip, method, friction};
  check(problem, contact_length, digits);
  if (auto solution = solution_of_length(problem, contact_length, digits)) return *std::move(solution);
  throw BadInput("contact_length", contact_length,
                 friction.kind == LineLoadFriction::Kind::thesis_creep
                     ? "must be one for which some creep meets the thesis's conditions: or give a creep"
                     : "must be one whose system is farther from singular than the reference can tell");
}

LineLoadNip line_loads_for_load(const data::ElasticNip& nip, const LineLoadMethod& method, double load,
                                int digits, const data::LineLoadFriction& friction) {
  constexpr int starting_digits = 16, starting_tolerance = 3;  // without friction
  const Problem problem{nip, method, friction}, frictionless{nip, method, {}};
  check_digits_and_elements(problem, digits);
  if (!(std::isfinite(load) && load > 0)) throw BadInput("load", load, "must be finite and > 0");
  LengthSearch search{Exact(load), Float(nip.sheet_thickness), longest_length * Float(nip.sheet_thickness)};
  const auto by = [](const Problem& given, int kernel_digits) {
    return [&given, kernel_digits](const Lengths& lengths) { return solve(given, lengths, kernel_digits); };
  };
  bool has_start = false;
  auto solution =
      solved_to(digits, extra_kernel_digits, [&](int kernel_digits) -> std::optional<SolvedLineLoads> {
        if (!has_start) has_start = search.seek(starting_tolerance, by(frictionless, starting_digits));
        if (!has_start) return std::nullopt;
        return search.contact_carrying((digits + kernel_digits) / 2, by(problem, kernel_digits));
      });
  if (solution) return *std::move(solution);
  throw BadInput("load", load, "no contact length was found that carries it");
}

LineLoadNip line_loads_from_kernel_values(const data::ElasticNip& nip, std::span<const double> kernel,
                                          double contact_length, int digits) {
  const Problem problem{nip, static_cast<int>(kernel.size() / 2), {}, kernel};
  check(problem, contact_length, digits);
  if (kernel.size() % 2 != 0)
    throw BadInput("kernel", std::to_string(kernel.size()) + " values", "must have 2m values");
  for (const double value : kernel)
    if (!std::isfinite(value)) throw BadInput("kernel", value, "must be finite");
  if (auto solution = solution_of_length(problem, contact_length, digits)) return *std::move(solution);
  throw BadInput("kernel", kernel.front(), "must be values that make no singular system (this is the first)");
}

}  // namespace nipref::ref
