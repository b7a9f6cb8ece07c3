#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/number/internal/enclosed_system.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_loads.hpp>

namespace nipref::ref {
namespace {

using data::BadInput;

/// A distance and so many half widths of an element, in half-thicknesses, in the middle of a grid.
mpq_class way(const RollingGrid& grid, const mpq_class& distance, long half_elements) {
  return distance + half_elements * grid.half_element;
}

/// Displacement of a place by the unit load j, 1/stress; the tangential one from the fixed point of thesis 6.27.
/// (thesis 6.26, 6.27)
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

}  // namespace nipref::ref
