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

/// Half widths from the line through the centres to a load's place, towards the leading side.
long half_elements_to(const RollingLoads& problem, int load) { return 2L * (problem.leading - load) - 1; }

/// A distance and so many half widths of an element, in half-thicknesses, in the middle of a grid.
mpq_class way(const RollingGrid& grid, const mpq_class& distance, long half_elements) {
  return distance + half_elements * grid.half_element;
}

/// A load's distance from a place, now and at the start; the fixed point's distance from the load.
struct LoadWays {
  mpq_class t, alpha, start, eta, eta_start;
  MovingLoadError error;
};

LoadWays ways_of(const RollingLoads& problem, const RollingGrid& grid, const RollingPlace& place, int load) {
  const long to_load = half_elements_to(problem, load), to_start = 2L * load + 1;
  const auto off = [&](long half_elements) { return mpq_class(std::abs(half_elements) * grid.spread); };
  const mpq_class before = problem.approach - place.distance;
  LoadWays ways{way(grid, before, 2L * problem.leading - place.half_elements),
                way(grid, place.distance, place.half_elements - to_load),
                way(grid, problem.approach, to_start),
                way(grid, 0, -to_load),
                way(grid, before, to_start - place.half_elements),
                {{off(place.half_elements - to_load), off(to_start)},
                 {off(to_load), off(to_start - place.half_elements)},
                 problem.material.memory_error}};
  if (ways.t < off(2L * problem.leading - place.half_elements))
    throw BadInput("y",
                   Exact(mpq_class(way(grid, place.distance, place.half_elements) * problem.half_thickness()))
                       .approximate(),
                   "must not be ahead of where the leading end started");
  return ways;
}

/// Whether no error is there, as of a grid of one length and a material with given rates.
bool is_exact(const MovingLoadError& error) {
  return error.load.alpha == 0 && error.load.start == 0 && error.fixed_point.alpha == 0 &&
         error.fixed_point.start == 0 && error.memory == 0;
}

Interval half_thickness_of(const RollingLoads& problem) {
  return {Exact(problem.half_thickness()), working_bits()};
}

}  // namespace

Interval RollingGrid::length(long half_elements) const {
  const mpfr_prec_t bits = working_bits();
  return half_elements * Interval(Exact(half_element), bits).widened(Interval(Exact(spread), bits));
}

Interval normal_at(const RollingLoads& problem, const RollingGrid& grid, const RollingPlace& place,
                   int load) {
  const LoadWays ways = ways_of(problem, grid, place, load);
  const Exact t = problem.time(ways.t), T = problem.time(ways.start), speed(problem.nip.speed),
              half_thickness(problem.half_thickness());
  const ExactMaterial& material = problem.material.material;
  const Interval value = interval_of(moving_load_normal_displacement(t, T, speed, half_thickness, material,
                                                                     problem.digits, problem.residue_terms));
  if (is_exact(ways.error)) return value;
  return value.widened(
      moving_load_normal_change(t, T, speed, half_thickness, material, ways.error, problem.residue_terms));
}

Interval tangential_at(const RollingLoads& problem, const RollingGrid& grid, const RollingPlace& place,
                       int load) {
  const LoadWays ways = ways_of(problem, grid, place, load);
  const Exact t = problem.time(ways.t), T = problem.time(ways.start), t0 = problem.time(ways.eta_start),
              speed(problem.nip.speed), half_thickness(problem.half_thickness());
  const ExactMaterial& material = problem.material.material;
  const Interval value = interval_of(moving_load_tangential_displacement(
      t, T, t0, speed, half_thickness, material, problem.digits, problem.residue_terms));
  if (is_exact(ways.error)) return value;
  return value.widened(moving_load_tangential_change(t, T, t0, speed, half_thickness, material, ways.error,
                                                     problem.residue_terms));
}

std::optional<SolvedLineLoads> solve_loads(const RollingLoads& problem, const RollingGrid& grid) {
  const int n = problem.loads();
  auto system = NearlyKnownSystem::of_size(n + 1, 1);
  const Interval compliance = interval_of(problem.instantaneous());
  const Interval half_thickness = half_thickness_of(problem);
  const Interval curvature = half_thickness / (2 * Interval(problem.nip.roller_radius, working_bits()));
  for (int i = 0; i <= n; ++i) {
    const long half_elements = 2L * (problem.leading - i);
    system.set_right(i, 0, square(grid.length(half_elements)) * curvature);
    system.matrix(i, 0) = 1;
    for (int j = 0; j < n; ++j)
      system.set(i, j + 1, -(normal_at(problem, grid, {0, half_elements}, j) / compliance));
  }
  auto solved = enclosed_solutions(system);
  if (!solved) return std::nullopt;
  // The unknowns are the indentation over b, and loads times the compliance at once over b.
  const std::vector<Interval>& unknowns = solved->unknowns.front();
  std::vector<Interval> loads;
  for (int j = 1; j <= n; ++j)
    loads.push_back(half_thickness / compliance * unknowns[static_cast<std::size_t>(j)]);
  const auto under = [problem, grid](auto influence_at) -> UnderLoad {
    return [=](const SolvedLineLoads& contact, std::size_t load, const LineLoadPlace& place) {
      const RollingPlace at{place.distance / problem.half_thickness(), place.half_elements};
      return contact.normal[load] * influence_at(problem, grid, at, static_cast<int>(load));
    };
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
                         .normal_under = under(normal_at),
                         .tangential_under = under(tangential_at)};
}

}  // namespace nipref::ref
