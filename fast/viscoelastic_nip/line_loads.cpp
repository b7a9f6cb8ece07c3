#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/material/functions.hpp>
#include <nipref/fast/memory/moving_load.hpp>
#include <nipref/fast/memory/plain_moving_load.hpp>
#include <nipref/fast/nip/internal/length_search.hpp>
#include <nipref/fast/number/internal/checks.hpp>
#include <nipref/fast/number/internal/linear_system.hpp>
#include <nipref/fast/sheet/plain_series.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>

namespace nipref::fast {
namespace {

using data::BadInput;

constexpr int most_elements = 500;

/// The part of the problem that does not depend on the length: the elements, and the displacements under a moving unit
/// load, by plain sums or exact. Lengths are in half-thicknesses: `way` that the load has moved since it started, alpha
/// from it to the point, eta to the pinned point. The way is much longer than the other two under a short contact.
struct RollingLoads {
  data::ViscoelasticNip nip;
  int leading, trailing;
  double approach;
  double compliance;  ///< instantaneous theta1 + theta2, 1/stress
  std::variant<MovingLoad, PlainMovingLoad> load;
  std::shared_ptr<Work> work = std::make_shared<Work>();

  RollingLoads(const data::ViscoelasticNip& rolling, const data::ViscoelasticLineLoads& method)
      : nip(rolling),
        leading(method.leading_elements),
        trailing(method.trailing_elements.value_or(leading)),
        approach(method.approach_lengths),
        compliance(material_functions(rolling.material).normal_compliance().instantaneous),
        load(moving_load(rolling, method)) {}

  [[nodiscard]] int loads() const { return leading + trailing; }
  [[nodiscard]] double normal_displacement(double way, double alpha) const {
    if (const auto* exact = std::get_if<MovingLoad>(&load))
      return exact->normal_displacement_after(way, alpha);
    return std::get<PlainMovingLoad>(load).normal_displacement(way, way + alpha);
  }
  [[nodiscard]] double tangential_displacement(double way, double alpha, double eta) const {
    if (const auto* exact = std::get_if<MovingLoad>(&load))
      return exact->tangential_displacement_after(way, alpha, eta);
    return std::get<PlainMovingLoad>(load).tangential_displacement(way, way + alpha, way + eta);
  }

 private:
  static std::variant<MovingLoad, PlainMovingLoad> moving_load(const data::ViscoelasticNip& nip,
                                                               const data::ViscoelasticLineLoads& method) {
    if (method.residue_terms == 0) return MovingLoad(nip.material, nip.speed, nip.half_thickness());
    return PlainMovingLoad(nip.material, nip.speed, nip.half_thickness(), method.residue_terms,
                           method.smallest_term);
  }
};

/// The grid of (thesis 7.11), in half-thicknesses.
struct Grid {
  double element;  ///< beta: half the width of an element
  double approach;
  int loads;

  [[nodiscard]] double t(int i) const { return 2 * i * element + approach; }        ///< i = 0 .. loads
  [[nodiscard]] double T(int j) const { return (2 * j + 1) * element + approach; }  ///< j = 0 .. loads - 1
};

/// u at matching point i under load j depends on j - i and on T_j, so that few sums are needed.
Eigen::MatrixXd plain_influence(const PlainMovingLoad& sheet, const Grid& grid) {
  std::vector<PlainMovingLoad::Sums> at_distance, at_T;
  for (int k = 0; k <= grid.loads; ++k) at_distance.push_back(sheet.normal_sums((2 * k + 1) * grid.element));
  for (int j = 0; j < grid.loads; ++j) at_T.push_back(sheet.normal_sums(grid.T(j)));
  Eigen::MatrixXd matrix(grid.loads + 1, grid.loads);
  for (int i = 0; i <= grid.loads; ++i) {
    for (int j = 0; j < grid.loads; ++j) {
      const int k = j >= i ? j - i : i - j - 1;
      matrix(i, j) = sheet.normal_displacement(grid.t(i), grid.T(j), at_distance[static_cast<std::size_t>(k)],
                                               at_T[static_cast<std::size_t>(j)]);
    }
  }
  return matrix;
}

Eigen::MatrixXd influence(const RollingLoads& problem, const Grid& grid) {
  if (const auto* plain = std::get_if<PlainMovingLoad>(&problem.load)) return plain_influence(*plain, grid);
  return Eigen::MatrixXd::NullaryExpr(grid.loads + 1, grid.loads, [&](Eigen::Index i, Eigen::Index j) {
    return problem.normal_displacement(grid.t(static_cast<int>(i)),
                                       static_cast<double>(2 * (j - i) + 1) * grid.element);
  });
}

/// The surface under loads that started when their leading end was `approach` ahead. Displacements along Y are relative
/// to the point of the middle plane on the line through the centres. They are those of the material point that is at Y
/// after the way.
LineLoadSheet rolling_sheet(const std::shared_ptr<const RollingLoads>& problem, double leading_length) {
  return [=](FaceDirection direction, std::span<const FaceLoad> loads, double y, Work& /*work*/) {
    const double half_thickness = problem->nip.half_thickness();
    const double way = problem->approach + (leading_length - y) / half_thickness;
    if (!(way >= 0)) throw BadInput("y", y, "must not be ahead of where the leading end started");
    double sum = 0;
    for (const FaceLoad& load : loads) {
      // The pinned point is at the line through the centres now.
      const double alpha = (y - load.y) / half_thickness, eta = -load.y / half_thickness;
      sum += load.normal * (direction == FaceDirection::normal
                                ? problem->normal_displacement(way, alpha)
                                : problem->tangential_displacement(way, alpha, eta));
    }
    return sum;
  };
}

LineLoadNip solve(const std::shared_ptr<const RollingLoads>& of, double leading_length) {
  const RollingLoads& problem = *of;
  const double half_thickness = problem.nip.half_thickness();
  const Grid cells{leading_length / (2 * problem.leading * half_thickness), problem.approach,
                   problem.loads()};
  Eigen::MatrixXd matrix(cells.loads + 1, cells.loads + 1);
  matrix.col(0).setOnes();
  // Loads in units that give displacements over b.
  const double compliance = problem.compliance;
  matrix.rightCols(cells.loads) = -influence(problem, cells) / compliance;
  Eigen::VectorXd gap(cells.loads + 1);
  for (int i = 0; i <= cells.loads; ++i) {
    const double y = 2 * (problem.leading - i) * cells.element;
    gap(i) = y * y * half_thickness / (2 * problem.nip.roller_radius);
  }
  const Eigen::VectorXd solved = Elimination(matrix).solve(gap);
  problem.work->count_system(cells.loads + 1);
  const double width = leading_length / problem.leading;
  std::vector<FaceLoad> loads;
  for (int j = 0; j < cells.loads; ++j)
    loads.push_back({(problem.leading - j - 0.5) * width, solved(j + 1) * half_thickness / compliance, 0});
  return {.roller_radius = problem.nip.roller_radius,
          .leading_elements = problem.leading,
          .leading_length = leading_length,
          .indentation = solved(0) * half_thickness,
          .loads = std::move(loads),
          .is_symmetric = false,
          .sheet = rolling_sheet(of, leading_length),
          .spent = problem.work};
}

LineLoadNip solve_for_load(const std::shared_ptr<const RollingLoads>& problem, double load) {
  const double radius = problem->nip.roller_radius;
  LengthSearch lengths(load, std::sqrt(load * radius * problem->compliance),
                       {.tolerance = 1e-10, .longest = radius});
  LineLoadNip result = solution_at_end(lengths, [&](double length) { return solve(problem, length); });
  if (lengths.met()) return result;
  throw BadInput("load", load, "must be one that line loads on a length below the roller's radius can carry");
}

void check(const data::ViscoelasticLineLoads& method) {
  internal::check_range("leading_elements", method.leading_elements, 1, most_elements);
  internal::check_range("trailing_elements", method.trailing_elements.value_or(0), 0, most_elements);
  internal::check_positive("approach_lengths", method.approach_lengths);
  internal::check_range("residue_terms", method.residue_terms, 0, most_residue_terms);
  if (!(method.smallest_term >= 0 && method.smallest_term <= 1))
    throw BadInput("smallest_term", method.smallest_term, "must be from 0 to 1");
}

}  // namespace

LineLoadNip line_loads_for_length(const data::ViscoelasticNip& nip, const data::ViscoelasticLineLoads& method,
                                  double leading_length) {
  nip.check();
  check(method);
  if (!(leading_length > 0 && leading_length <= nip.roller_radius))
    throw BadInput("leading_length", leading_length, "must be > 0 and at most the roller's radius");
  return solve(std::make_shared<const RollingLoads>(nip, method), leading_length);
}

LineLoadNip line_loads_for_load(const data::ViscoelasticNip& nip, const data::ViscoelasticLineLoads& method,
                                double load) {
  nip.check();
  check(method);
  internal::check_positive("load", load);
  RollingLoads problem(nip, method);
  while (true) {
    LineLoadNip result = solve_for_load(std::make_shared<const RollingLoads>(problem), load);
    if (method.trailing_elements || problem.trailing == 0 || result.presses_everywhere()) return result;
    --problem.trailing;
  }
}

}  // namespace nipref::fast
