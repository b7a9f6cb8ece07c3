#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/number/internal/enclosed_system.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_loads.hpp>

namespace nipref::ref {

using data::BadInput;

namespace {

constexpr int kernel_guard_digits = 8;

}  // namespace

Interval normal_at(const RollingLoads& problem, const mpq_class& t, const mpq_class& T) {
  return interval_of(moving_load_normal_displacement(
      problem.time(t), problem.time(T), Exact(problem.nip.speed), Exact(problem.half_thickness()),
      problem.material, problem.digits + kernel_guard_digits, problem.residue_terms));
}

Interval tangential_at(const RollingLoads& problem, const mpq_class& t, const mpq_class& T,
                       const mpq_class& t0) {
  return interval_of(moving_load_tangential_displacement(
      problem.time(t), problem.time(T), problem.time(t0), Exact(problem.nip.speed),
      Exact(problem.half_thickness()), problem.material, problem.digits + kernel_guard_digits,
      problem.residue_terms));
}

LoadsOnLength solve_loads(const RollingLoads& problem, const Float& leading_length) {
  const mpq_class half_thickness = problem.half_thickness();
  const RollingGrid grid{to_exact(leading_length).value() / (2 * problem.leading * half_thickness),
                         problem.approach, problem.leading};
  const int n = problem.loads();
  NearlyKnownSystem system{Matrix(n + 1, n + 1), Matrix(n + 1, 1), 0, {}};
  const Interval compliance = interval_of(problem.instantaneous());
  for (int i = 0; i <= n; ++i) {
    const Float y = to_float(Exact(mpq_class(2 * (problem.leading - i) * grid.element)));
    system.right(i) = y * y * to_float(Exact(half_thickness)) / (2 * Float(problem.nip.roller_radius));
    system.matrix(i, 0) = 1;
    for (int j = 0; j < n; ++j) {
      const Interval influence = -(normal_at(problem, grid.t(i), grid.T(j)) / compliance);
      system.matrix(i, j + 1) = middle_of(influence);
      system.error =
          std::max<Float>(system.error, upper_end(distance_from(system.matrix(i, j + 1), influence)));
    }
  }
  system.right_error = Vector(1);
  system.right_error(0) = 8 * std::numeric_limits<Float>::epsilon() * abs(system.right(0));
  auto solved = enclosed_solutions(system);
  if (!solved)
    throw BadInput("contact_length", static_cast<double>(leading_length),
                   "must be one whose system is farther from singular than the reference can tell");
  std::vector<Interval> unknowns = std::move(solved->unknowns.front());
  LoadsOnLength result{leading_length, grid, unknowns.front(), {unknowns.begin() + 1, unknowns.end()}};
  return result;
}

Interval half_thickness_of(const RollingLoads& problem) {
  return {Exact(problem.half_thickness()), working_bits()};
}

/// Force per unit width of what counts as LoadsOnLength::loads do.
Interval force_unit(const RollingLoads& problem) {
  return half_thickness_of(problem) / interval_of(problem.instantaneous());
}

Interval load_of(const RollingLoads& problem, const LoadsOnLength& contact) {
  Interval sum(working_bits());
  for (const Interval& load : contact.loads) sum = sum + load;
  return force_unit(problem) * sum;
}

bool presses_everywhere(const LoadsOnLength& contact) {
  return std::ranges::all_of(contact.loads, [](const Interval& load) { return middle_of(load) >= Float(0); });
}

/// By secants of ln W over ln L1 from `length` until W is within 10^-digits of the load.
FoundLength search_length(const RollingLoads& problem, Float length, double load, int digits) {
  constexpr int most_steps = 40;
  constexpr double usual_exponent = 3, least_exponent = 1, longest_step = 1;
  const Float tolerance = pow(Float(10), -digits), longest = problem.nip.roller_radius;
  std::optional<LoadsOnLength> before;
  Float exponent = usual_exponent, last_log = 0, last_excess = 0, last_found = 0;
  for (int step = 0; step < most_steps; ++step) {
    LoadsOnLength tried = solve_loads(problem, length);
    const Interval carried = load_of(problem, tried);
    const Float found = middle_of(carried);
    if (!(found > Float(0))) {
      length = length / 3;
      continue;
    }
    const Float excess = log(found / Float(load)), log_length = log(length);
    if (before && log_length != last_log) {
      if (abs(excess) <= tolerance) {
        const Float off = abs(found - Float(load)) + upper_end(distance_from(found, carried));
        const Float missing = 2 * off / abs(found - last_found);
        return {std::move(tried), *std::move(before), missing, step + 1};
      }
      exponent = std::max<Float>((excess - last_excess) / (log_length - last_log), least_exponent);
    }
    last_log = log_length;
    last_excess = excess;
    last_found = found;
    before = std::move(tried);
    // Never the same length twice: the last step tells how results go with the length.
    Float change = std::clamp<Float>(-excess / exponent, -longest_step, longest_step);
    if (abs(change) < tolerance) change = 10 * tolerance;
    length = std::min<Float>(exp(log_length + change), longest);
  }
  throw BadInput("load", load, "must be one that line loads on a length below the roller's radius can carry");
}

}  // namespace nipref::ref
