#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/material/internal/material_compliances.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_loads.hpp>
#include <nipref/ref/viscoelastic_nip/line_loads.hpp>

namespace nipref::ref {
namespace {

using data::BadInput;

/// A distance plus a number of half widths of an element, in half-thicknesses, for the middle of a grid.
mpq_class way(const RollingGrid& grid, const mpq_class& distance, long half_elements) {
  return distance + half_elements * grid.half_element;
}

/// The displacement of a place by a unit load, 1/stress; the tangential one from the fixed point. (thesis 6.26, 6.27)
Interval displacement_by(int load, const RollingLoads& problem, const RollingGrid& grid,
                         const LineLoadPlace& place, bool is_normal) {
  const long to_load = 2L * (problem.leading - load) - 1, to_start = 2L * load + 1,
             to_place = place.half_elements, since_start = 2L * problem.leading - to_place;
  const auto off = [&](long half_elements) { return mpq_class(std::abs(half_elements) * grid.spread); };
  const mpq_class distance = place.distance / problem.half_thickness(), before = problem.approach - distance,
                  gone = way(grid, before, since_start);
  if (gone < off(since_start))
    throw BadInput("y", mpq_class(way(grid, distance, to_place) * problem.half_thickness()).get_d(),
                   "must not be ahead of where the leading end started");
  const Exact t = problem.time(gone), T = problem.time(way(grid, problem.approach, to_start)),
              t0 = problem.time(way(grid, before, to_start - to_place));
  const MovingLoadError error{{off(to_place - to_load), off(to_start)},
                              {off(to_load), off(to_start - to_place)},
                              problem.memory_error};
  const MovingLoad& moving = problem.moving_load;
  return is_normal ? interval_of(moving.normal_displacement(t, T, problem.digits))
                         .widened(moving.normal_change(t, T, error))
                   : interval_of(moving.tangential_displacement(t, T, t0, problem.digits))
                         .widened(moving.tangential_change(t, T, t0, error));
}

}  // namespace

Interval RollingGrid::length(long half_elements) const {
  const mpfr_prec_t bits = working_bits();
  return half_elements * Interval(half_element, bits).widened(Interval(spread, bits));
}

std::optional<SolvedLineLoads> solve_loads(const RollingLoads& problem, const RollingGrid& grid) {
  const int n = problem.loads();
  auto system = NearlyKnownSystem::of_size(n + 1, 1);
  const Interval compliance = interval_of(problem.instantaneous());
  const Interval half_thickness(problem.half_thickness(), working_bits());
  const Interval curvature = half_thickness / (2 * Interval(problem.nip.roller_radius, working_bits()));
  for (int i = 0; i <= n; ++i) {
    const long half_elements = 2L * (problem.leading - i);
    system.set_right(i, 0, square(grid.length(half_elements)) * curvature);
    system.matrix(i, 0) = 1;
    for (int j = 0; j < n; ++j)
      system.set(i, j + 1, -(displacement_by(j, problem, grid, {0, half_elements}, true) / compliance));
  }
  auto solved = enclosed_solutions(system);
  if (!solved) return std::nullopt;
  // The unknowns are the indentation over b, and loads times the compliance at once over b.
  const std::vector<Interval>& unknowns = solved->unknowns.front();
  std::vector<Interval> loads;
  for (int j = 1; j <= n; ++j)
    loads.push_back(half_thickness / compliance * unknowns[static_cast<std::size_t>(j)]);
  const auto under = [problem, grid](const SolvedLineLoads& contact, std::size_t load,
                                     const LineLoadPlace& place, bool is_normal) {
    return contact.normal[load] * displacement_by(static_cast<int>(load), problem, grid, place, is_normal);
  };
  return SolvedLineLoads{.roller_radius = problem.nip.roller_radius,
                         .leading_elements = problem.leading,
                         .is_symmetric = false,
                         .contact_length = grid.length(2L * n) * half_thickness,
                         .indentation = unknowns.front() * half_thickness,
                         .normal = std::move(loads),
                         .shear = {},
                         .error = solved->error / solved->largest,
                         .condition = solved->condition,
                         .unknowns = n + 1,
                         .under = under};
}

namespace {

using data::BadInput;

constexpr int most_elements = 100;
constexpr double farthest = 500;  ///< largest distance of the start, half-thicknesses

constexpr ExtraDigits extra_digits{24, 100};

RollingLoads checked(const data::ViscoelasticNip& nip, const data::ViscoelasticLineLoads& method,
                     int digits) {
  nip.check();
  if (digits < 16 || digits > 30)
    throw BadInput("digits", std::to_string(digits), "must be from 16 to 30 with line loads that roll");
  const int trailing = method.trailing_elements.value_or(method.leading_elements);
  for (const auto& [name, elements, least] : {std::tuple("leading_elements", method.leading_elements, 1),
                                              std::tuple("trailing_elements", trailing, 0)}) {
    if (elements < least || elements > most_elements)
      throw BadInput(name, std::to_string(elements),
                     "must be from " + std::to_string(least) + " to " + std::to_string(most_elements) +
                         " in the reference");
  }
  if (!(method.approach_lengths > 0 && method.approach_lengths <= farthest))
    throw BadInput("approach_lengths", method.approach_lengths,
                   "must be > 0 and at most 500 in the reference");
  if (method.residue_terms < 0 || method.residue_terms > 500)
    throw BadInput("residue_terms", std::to_string(method.residue_terms), "must be from 0 to 500");
  if (method.smallest_term != 0)
    throw BadInput("smallest_term", method.smallest_term, "must be 0 in the reference");
  (void)material_compliances(nip.material);  // refuses invalid materials
  const ExactMaterial material = exact_material(nip.material);
  if (method.residue_terms > 0 &&
      std::ranges::any_of(material.normal().terms, [](const auto& term) { return term.rate == 0; }))
    throw BadInput("residue_terms", std::to_string(method.residue_terms),
                   "must be 0: the material is a fluid, and the thesis's sums divide by its rate, 0");
  constexpr mpfr_prec_t bits = 512;  // of rates that are roots, so that their errors are below all others
  const NearMaterial near = with_given_rates(material, bits);
  return {nip,
          MovingLoad(near.material, Exact(nip.speed), Exact(nip.half_thickness()), method.residue_terms),
          near.memory_error,
          method.leading_elements,
          trailing,
          mpq_class(method.approach_lengths),
          digits};
}

LengthSearch search_of(const RollingLoads& problem, double load) {
  const Float leading_length = sqrt(Float(load) * Float(problem.nip.roller_radius) * problem.instantaneous());
  return {Exact(load), leading_length / (2 * problem.leading * to_float(Exact(problem.half_thickness()))),
          to_float(Exact(problem.half_element(mpq_class(problem.nip.roller_radius))))};
}

}  // namespace

LineLoadNip line_loads_for_length(const data::ViscoelasticNip& nip, const data::ViscoelasticLineLoads& method,
                                  double contact_length, int digits) {
  RollingLoads problem = checked(nip, method, digits);
  if (!(contact_length > 0 && contact_length <= nip.roller_radius))
    throw BadInput("contact_length", contact_length, "must be > 0 and at most the roller's radius");
  auto solution = solved_to(digits, extra_digits, [&](int influence_digits) {
    problem.digits = influence_digits;
    return solve_loads(problem, {problem.half_element(mpq_class(contact_length)), 0});
  });
  if (solution) return *std::move(solution);
  throw BadInput("contact_length", contact_length,
                 "must be one whose system is farther from singular than the reference can tell");
}

LineLoadNip line_loads_for_load(const data::ViscoelasticNip& nip, const data::ViscoelasticLineLoads& method,
                                double load, int digits) {
  constexpr int digits_of_search = 16 - extra_digits.first;  // the influences have 16 digits at first
  RollingLoads problem = checked(nip, method, digits);
  if (!(std::isfinite(load) && load > 0)) throw BadInput("load", load, "must be finite and > 0");
  LengthSearch search = search_of(problem, load);
  const auto contact_of = [&](const Lengths& lengths) {
    return solve_loads(problem, {to_exact(lengths.length).value(),
                                 to_exact(Float(lengths.length * lengths.spread)).value()});
  };
  const auto carrying_to = [&](int least_digits) {
    return [&, least_digits](int influence_digits) {
      problem.digits = influence_digits;
      return search.contact_carrying(std::max(least_digits, 0) + (influence_digits - least_digits) / 2,
                                     contact_of);
    };
  };
  // Whether no load pulls, that is, is negative; nothing if the highest precision leaves a sign undecided.
  const auto presses_everywhere = [&] {
    std::optional<bool> presses;
    solved_to(digits_of_search, extra_digits, carrying_to(digits_of_search),
              [&](const SolvedLineLoads& contact) {
                presses = contact.presses_everywhere();
                return presses.has_value();
              });
    return presses;
  };
  while (!method.trailing_elements && problem.trailing > 0) {
    const std::optional<bool> presses = presses_everywhere();
    if (!presses) throw BadInput("load", load, "must be one whose trailing elements can be proven");
    if (*presses) break;
    --problem.trailing;
  }
  if (auto solution = solved_to(digits, extra_digits, carrying_to(digits))) return *std::move(solution);
  throw BadInput("load", load, "must be one whose contact length can be proven");
}

}  // namespace nipref::ref
