#include <algorithm>
#include <cmath>
#include <string>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/nip/internal/domain.hpp>
#include <nipref/fast/nip/internal/length_search.hpp>
#include <nipref/fast/number/internal/linear_system.hpp>
#include <nipref/fast/sheet/plain_series.hpp>
#include <nipref/fast/viscoelastic_nip/internal/sheet.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>

namespace nipref::fast {
namespace {

using data::BadInput;

constexpr int most_elements = 500;

/// What does not depend on the length.
struct RollingLoads {
  const data::ViscoelasticNip& nip;
  int leading, trailing;
  double approach;
  std::shared_ptr<const ViscoelasticSheet> sheet;
  std::shared_ptr<Work> work = std::make_shared<Work>();

  RollingLoads(const data::ViscoelasticNip& rolling, const ViscoelasticLineLoadMethod& method)
      : nip(rolling),
        leading(method.leading_elements),
        trailing(method.trailing_elements.value_or(leading)),
        approach(method.approach),
        sheet(
            std::make_shared<const ViscoelasticSheet>(rolling, method.residue_terms, method.smallest_term)) {}
  [[nodiscard]] int loads() const { return leading + trailing; }
};

/// (7.11), in half-thicknesses.
struct Grid {
  double element;  ///< beta: half the width of an element
  double approach;
  int loads;

  [[nodiscard]] double t(int i) const { return 2 * i * element + approach; }        ///< i = 0 .. loads
  [[nodiscard]] double T(int j) const { return (2 * j + 1) * element + approach; }  ///< j = 0 .. loads - 1
};

/// u at matching point i by load j depends on j - i and on T_j, so that the sums are few.
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

Eigen::MatrixXd influence(const ViscoelasticSheet& sheet, const Grid& grid) {
  if (sheet.plain() != nullptr) return plain_influence(*sheet.plain(), grid);
  return Eigen::MatrixXd::NullaryExpr(grid.loads + 1, grid.loads, [&](Eigen::Index i, Eigen::Index j) {
    return sheet.normal_displacement(grid.t(static_cast<int>(i)), grid.T(static_cast<int>(j)));
  });
}

/// The surface under loads that started when their leading end was `approach` ahead.
class RollingSurface final : public LineLoadSheet {
 public:
  RollingSurface(const RollingLoads& problem, double leading_length)
      : half_thickness_(problem.nip.half_thickness()),
        approach_(problem.approach),
        leading_length_(leading_length),
        sheet_(problem.sheet) {}

  [[nodiscard]] double normal_displacement(std::span<const FaceLoad> loads, double y,
                                           Work& /*work*/) const override {
    return sum(loads, y, [&](double t, double T, double) { return sheet_->normal_displacement(t, T); });
  }
  /// Against the point of the middle plane on the line through the centres.
  [[nodiscard]] double tangential_displacement(std::span<const FaceLoad> loads, double y,
                                               Work& /*work*/) const override {
    return sum(loads, y,
               [&](double t, double T, double t0) { return sheet_->tangential_displacement(t, T, t0); });
  }

 private:
  /// The sum of each load's displacement(t, T, t0) for the point that is at Y at the time t, with lengths in
  /// half-thicknesses and times in half-thickness/speed.
  [[nodiscard]] double sum(std::span<const FaceLoad> loads, double y, const auto& displacement) const {
    const double t = approach_ + (leading_length_ - y) / half_thickness_;
    if (!(t >= 0)) throw BadInput("y", y, "must not be ahead of where the leading end started");
    double sum = 0;
    for (const FaceLoad& load : loads) {
      // What the load is ahead of the centres, the pinned point has been passed by.
      const double T = t + (y - load.y) / half_thickness_, t0 = t - load.y / half_thickness_;
      sum += load.normal * displacement(t, T, t0);
    }
    return sum;
  }

  double half_thickness_, approach_, leading_length_;
  std::shared_ptr<const ViscoelasticSheet> sheet_;
};

LineLoadNip solve(const RollingLoads& problem, double leading_length) {
  const double half_thickness = problem.nip.half_thickness();
  const Grid cells{leading_length / (2 * problem.leading * half_thickness), problem.approach,
                   problem.loads()};
  Eigen::MatrixXd matrix(cells.loads + 1, cells.loads + 1);
  matrix.col(0).setOnes();
  // Loads in units that give displacements over b.
  const double compliance = problem.sheet->compliance();
  matrix.rightCols(cells.loads) = -influence(*problem.sheet, cells) / compliance;
  Eigen::VectorXd gap(cells.loads + 1);
  for (int i = 0; i <= cells.loads; ++i) {
    const double y = 2 * (problem.leading - i) * cells.element;
    gap(i) = y * y * half_thickness / (2 * problem.nip.roller_radius);
  }
  const Eigen::VectorXd solved = linear_solution(matrix, gap);
  ++problem.work->systems;
  problem.work->unknowns = cells.loads + 1;
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
          .sheet = std::make_shared<const RollingSurface>(problem, leading_length),
          .spent = problem.work};
}

LineLoadNip solve_for_load(const RollingLoads& problem, double load) {
  const double half_space = std::sqrt(load * problem.nip.roller_radius * problem.sheet->compliance());
  LengthSearch lengths(load, half_space, {.tolerance = 1e-10, .longest = problem.nip.roller_radius});
  LineLoadNip result = solution_at_end(lengths, [&](double length) { return solve(problem, length); });
  if (lengths.met()) return result;
  throw BadInput("load", load, "must be one that line loads on a length below the roller's radius can carry");
}

void check_elements(const char* name, int elements, int least) {
  if (!(elements >= least && elements <= most_elements)) {
    throw BadInput(name, elements,
                   "must be from " + std::to_string(least) + " to " + std::to_string(most_elements));
  }
}

}  // namespace

void ViscoelasticLineLoadMethod::check() const {
  check_elements("leading_elements", leading_elements, 1);
  check_elements("trailing_elements", trailing_elements.value_or(0), 0);
  if (!(std::isfinite(approach) && approach > 0))
    throw BadInput("approach_lengths", approach, "must be finite and > 0");
  if (!(residue_terms >= 0 && residue_terms <= most_residue_terms)) {
    throw BadInput("residue_terms", residue_terms, "must be from 0 to " + std::to_string(most_residue_terms));
  }
  if (!(smallest_term >= 0 && smallest_term <= 1))
    throw BadInput("smallest_term", smallest_term, "must be from 0 to 1");
}

LineLoadNip line_loads_for_length(const data::ViscoelasticNip& nip, const ViscoelasticLineLoadMethod& method,
                                  double leading_length) {
  nip.check();
  method.check();
  if (!(leading_length > 0 && leading_length <= nip.roller_radius))
    throw BadInput("leading_length", leading_length, "must be > 0 and at most the roller's radius");
  return solve(RollingLoads(nip, method), leading_length);
}

LineLoadNip line_loads_for_load(const data::ViscoelasticNip& nip, const ViscoelasticLineLoadMethod& method,
                                double load) {
  nip.check();
  method.check();
  check_contact_load(load);
  RollingLoads problem(nip, method);
  while (true) {
    LineLoadNip result = solve_for_load(problem, load);
    if (method.trailing_elements || problem.trailing == 0 || result.presses_everywhere()) return result;
    --problem.trailing;
  }
}

}  // namespace nipref::fast
