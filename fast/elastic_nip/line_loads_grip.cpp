#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/elastic_nip/internal/line_loads_system.hpp>
#include <nipref/fast/elastic_nip/line_loads_grip.hpp>
#include <nipref/fast/number/internal/feasible_set.hpp>
#include <nipref/fast/number/internal/linear_system.hpp>

namespace nipref::fast {
namespace {

/// The unknowns as functions of the creep: at_zero + creep * per_creep.
struct AffineSolution {
  Eigen::VectorXd at_zero;
  Eigen::VectorXd per_creep;

  [[nodiscard]] Eigen::VectorXd at(double creep) const { return at_zero + creep * per_creep; }
  [[nodiscard]] Affine unknown(int index) const { return {at_zero(index), per_creep(index)}; }
};

/// Right-hand sides of creep 0 and of creep 1 on an undeformed cylinder.
Eigen::MatrixXd right_hand_sides(const data::ElasticNip& nip, int m, double contact_length) {
  Eigen::MatrixXd sides = Eigen::MatrixXd::Zero(2 * m + 1, 2);
  sides.col(0).head(m + 1) = gap_at_matching_points(nip, m, contact_length);
  for (int i = 1; i <= m; ++i) sides(m + i, 1) = i * contact_length / (2 * m);
  return sides;
}

AffineSolution solve(const data::ElasticNip& nip, const LineLoadMethod& method, double contact_length,
                     Work* work) {
  const std::vector<double> distances = odd_multiples(nip, method, contact_length);
  const int m = method.elements_per_side;
  Work spent;
  const KernelValues kernels =
      line_load_kernels(method, distances, {.I1 = true, .I3 = true, .I6 = true}, spent);
  const Eigen::MatrixXd unknowns =
      linear_solution(grip_matrix(kernels, nip.material.poisson), right_hand_sides(nip, m, contact_length));
  count_system(2 * m + 1, spent);
  if (work != nullptr) *work += spent;
  return {unknowns.col(0), unknowns.col(1)};
}

LineLoadSolution with_creep(const data::ElasticNip& nip, int m, double contact_length,
                            const AffineSolution& unknowns, double creep) {
  LineLoadSolution solution = solution_of(nip, m, contact_length, unknowns.at(creep));
  solution.gripped_creep = creep;
  return solution;
}

/// Creep ratios at which the shear loads push outwards (sign 1) or inwards (-1).
FeasibleSet feasible(const AffineSolution& unknowns, int m, double sign, const CreepConditions& conditions) {
  FeasibleSet creeps;
  for (int k = 1; k <= m; ++k) {
    creeps.require_not_negative(unknowns.unknown(k));
    creeps.require_not_negative(sign * unknowns.unknown(m + k));
  }
  if (!conditions.monotone_ratio) return creeps;
  for (int k = 1; k < m; ++k) {
    creeps.require_not_negative(sign * (unknowns.unknown(m + k + 1) * unknowns.unknown(k) -
                                        unknowns.unknown(m + k) * unknowns.unknown(k + 1)));
  }
  return creeps;
}

std::vector<CreepRange> ranges(const AffineSolution& unknowns, int m, const CreepConditions& conditions) {
  std::vector<CreepRange> both;
  for (const double sign : {-1.0, 1.0}) {
    const FeasibleSet creeps = feasible(unknowns, m, sign, conditions);
    for (const auto& [lower, upper] : creeps.parts()) both.push_back({lower, upper});
  }
  std::ranges::sort(both, {}, &CreepRange::lower);
  return both;
}

double size(double creep) { return std::abs(creep); }

/// The creep of least size in the ranges.
std::optional<ThesisCreep> least(const std::vector<CreepRange>& ranges) {
  std::optional<ThesisCreep> chosen;
  for (const CreepRange& range : ranges) {
    const double nearest = std::clamp(0.0, range.lower, range.upper);
    if (!chosen || size(nearest) < size(chosen->chosen)) chosen = {range, nearest};
  }
  return chosen;
}

void check_creep(double creep) {
  if (!std::isfinite(creep)) throw data::BadInput("creep", creep, "must be finite");
}

[[noreturn]] void refuse(double load, double creep) {
  throw data::BadInput("load", load,
                       fmt::format("no contact length was found that carries it at the creep {:g}", creep));
}

/// Good enough to start from.
double length_without_friction(const data::ElasticNip& nip, const LineLoadMethod& method, double load,
                               Work* work) {
  return line_loads_for_load(nip, method, load, {.tolerance = 1e-2}, work).contact_length;
}

}  // namespace

LineLoadSolution gripped_line_loads_for_length(const data::ElasticNip& nip, const LineLoadMethod& method,
                                               double contact_length, double creep, Work* work) {
  check_creep(creep);
  return with_creep(nip, method.elements_per_side, contact_length, solve(nip, method, contact_length, work),
                    creep);
}

LineLoadSolution gripped_line_loads_for_load(const data::ElasticNip& nip, const LineLoadMethod& method,
                                             double load, double creep, const LoadSearch& search,
                                             Work* work) {
  LengthSearch lengths = length_search(load, length_without_friction(nip, method, load, work), search);
  LineLoadSolution solution = solution_at_end(lengths, [&](double length) {
    LineLoadSolution tried = gripped_line_loads_for_length(nip, method, length, creep, work);
    if (!(tried.load > 0)) refuse(load, creep);
    return tried;
  });
  if (!lengths.met()) refuse(load, creep);
  return solution;
}

std::vector<CreepRange> creep_ranges(const data::ElasticNip& nip, const LineLoadMethod& method,
                                     double contact_length, const CreepConditions& conditions, Work* work) {
  return ranges(solve(nip, method, contact_length, work), method.elements_per_side, conditions);
}

std::optional<ThesisCreep> thesis_creep(const data::ElasticNip& nip, const LineLoadMethod& method,
                                        double contact_length, Work* work) {
  return least(creep_ranges(nip, method, contact_length, {}, work));
}

std::optional<LineLoadSolution> thesis_line_loads_for_length(const data::ElasticNip& nip,
                                                             const LineLoadMethod& method,
                                                             double contact_length, Work* work) {
  const AffineSolution unknowns = solve(nip, method, contact_length, work);
  const std::optional<ThesisCreep> creep = least(ranges(unknowns, method.elements_per_side, {}));
  if (!creep) return std::nullopt;
  return with_creep(nip, method.elements_per_side, contact_length, unknowns, creep->chosen);
}

std::optional<LineLoadSolution> thesis_line_loads_for_load(const data::ElasticNip& nip,
                                                           const LineLoadMethod& method, double load,
                                                           const LoadSearch& search, Work* work) {
  LengthSearch lengths = length_search(load, length_without_friction(nip, method, load, work), search);
  while (true) {
    auto solution = thesis_line_loads_for_length(nip, method, lengths.length(), work);
    if (!solution || !(solution->load > 0)) return std::nullopt;
    if (!lengths.settled(solution->load)) continue;
    if (!lengths.met()) refuse(load, solution->gripped_creep.value());
    return solution;
  }
}

}  // namespace nipref::fast
