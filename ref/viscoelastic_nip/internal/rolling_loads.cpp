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
mpq_class way(const RollingGrid& grid, const mpq_class& distance, long elements) {
  return distance + elements * grid.element;
}

/// A load's distance from a place, now and at the start; the fixed point's distance from the load.
struct LoadWays {
  mpq_class t, alpha, start, eta, eta_start;
  MovingLoadError error;
};

LoadWays ways_of(const RollingLoads& problem, const RollingGrid& grid, const RollingPlace& place, int load) {
  const long to_load = elements_to(problem, load), to_start = 2L * load + 1;
  const auto off = [&](long elements) { return mpq_class(std::abs(elements) * grid.spread); };
  const mpq_class before = problem.approach - place.distance;
  LoadWays ways{way(grid, before, 2L * problem.leading - place.elements),
                way(grid, place.distance, place.elements - to_load),
                way(grid, problem.approach, to_start),
                way(grid, 0, -to_load),
                way(grid, before, to_start - place.elements),
                {{off(place.elements - to_load), off(to_start)},
                 {off(to_load), off(to_start - place.elements)},
                 problem.material.memory_error}};
  if (ways.t < off(2L * problem.leading - place.elements))
    throw BadInput(
        "y",
        Exact(mpq_class(way(grid, place.distance, place.elements) * problem.half_thickness())).approximate(),
        "must not be ahead of where the leading end started");
  return ways;
}

/// Whether no error is there, as of a grid of one length and a material with given rates.
bool is_exact(const MovingLoadError& error) {
  return error.load.alpha == 0 && error.load.start == 0 && error.fixed_point.alpha == 0 &&
         error.fixed_point.start == 0 && error.memory == 0;
}

Interval sum_of_loads(const LoadsOnLength& contact) {
  Interval sum(working_bits());
  for (const Interval& load : contact.loads) sum = sum + load;
  return sum;
}

}  // namespace

Interval RollingGrid::elements(long count) const {
  const mpfr_prec_t bits = working_bits();
  return count * Interval(Exact(element), bits).widened(Interval(Exact(spread), bits));
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

std::optional<LoadsOnLength> solve_loads(const RollingLoads& problem, const RollingGrid& grid) {
  const int n = problem.loads();
  NearlyKnownSystem system{Matrix(n + 1, n + 1), Matrix(n + 1, 1), 0, Vector(1)};
  const Interval compliance = interval_of(problem.instantaneous());
  const Interval curvature =
      half_thickness_of(problem) / (2 * Interval(problem.nip.roller_radius, working_bits()));
  const auto keep = [](Float& entry, Float& error, const Interval& value) {
    entry = middle_of(value);
    error = std::max<Float>(error, upper_end(distance_from(entry, value)));
  };
  system.right_error(0) = 0;
  for (int i = 0; i <= n; ++i) {
    const long elements = 2L * (problem.leading - i);
    keep(system.right(i), system.right_error(0), square(grid.elements(elements)) * curvature);
    system.matrix(i, 0) = 1;
    for (int j = 0; j < n; ++j)
      keep(system.matrix(i, j + 1), system.error, -(normal_at(problem, grid, {0, elements}, j) / compliance));
  }
  auto solved = enclosed_solutions(system);
  if (!solved) return std::nullopt;
  const std::vector<Interval>& unknowns = solved->unknowns.front();
  return LoadsOnLength{
      grid, unknowns.front(), {unknowns.begin() + 1, unknowns.end()}, solved->error / solved->largest};
}

Interval half_thickness_of(const RollingLoads& problem) {
  return {Exact(problem.half_thickness()), working_bits()};
}

/// Force per unit width of what counts as LoadsOnLength::loads do.
Interval force_unit(const RollingLoads& problem) {
  return half_thickness_of(problem) / interval_of(problem.instantaneous());
}

Interval load_of(const RollingLoads& problem, const LoadsOnLength& contact) {
  return force_unit(problem) * sum_of_loads(contact);
}

std::optional<bool> presses_everywhere(const LoadsOnLength& contact) {
  const auto& loads = contact.loads;
  if (std::ranges::any_of(loads, [](const Interval& load) { return mpfr_sgn(load.upper()) < 0; }))
    return false;
  if (std::ranges::all_of(loads, [](const Interval& load) { return mpfr_sgn(load.lower()) >= 0; }))
    return true;
  return std::nullopt;
}

std::optional<LoadsOnLength> enclose_length(const RollingLoads& problem, LengthGuess& guess, double load,
                                            int digits, int& systems) {
  constexpr int most_steps = 40, spare_digits = 2;
  constexpr double least_exponent = 1, longest_step = 1;
  const Float tolerance = pow(Float(10), -(digits + spare_digits));
  const Float longest = to_float(Exact(problem.element(mpq_class(problem.nip.roller_radius))));
  const Interval wanted(load, working_bits());
  const auto solved = [&](const mpq_class& element, const mpq_class& spread) {
    ++systems;
    return solve_loads(problem, {element, spread});
  };
  // The sign of W - load, 0 where the bounds do not tell.
  const auto sign_at = [&](const mpq_class& element) {
    const std::optional<LoadsOnLength> contact = solved(element, 0);
    if (!contact) return 0;
    const Interval excess = load_of(problem, *contact) - wanted;
    return mpfr_sgn(excess.lower()) > 0 ? 1 : mpfr_sgn(excess.upper()) < 0 ? -1 : 0;
  };
  std::optional<std::pair<Float, Float>> last;  // ln L and ln W - ln load
  for (int step = 0; step < most_steps; ++step) {
    const mpq_class middle = to_exact(guess.element).value();
    const std::optional<LoadsOnLength> tried = solved(middle, 0);
    if (!tried) return std::nullopt;
    const Float found = middle_of(load_of(problem, *tried));
    if (!(found > Float(0))) {
      guess.element = guess.element / 3;
      continue;
    }
    const Float excess = log(found / Float(load)), log_length = log(guess.element);
    if (abs(excess) <= tolerance) {
      const mpq_class spread = to_exact(guess.element * pow(Float(10), -digits)).value();
      if (sign_at(middle - spread) * sign_at(middle + spread) >= 0) return std::nullopt;
      return solved(middle, spread);
    }
    if (last && log_length != last->first)
      guess.exponent = std::max<Float>((excess - last->second) / (log_length - last->first), least_exponent);
    last = {log_length, excess};
    const Float change = std::clamp<Float>(-excess / guess.exponent, -longest_step, longest_step);
    guess.element = std::min<Float>(exp(log_length + change), longest);
  }
  throw BadInput("load", load, "must be one that line loads on a length below the roller's radius can carry");
}

}  // namespace nipref::ref
