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

/// (7.11), in half-thicknesses.
struct Grid {
  double element;  ///< beta: half the width of an element
  double approach;
  int leading;
  int loads;

  [[nodiscard]] double t(int i) const { return 2 * i * element + approach; }        ///< i = 0 .. loads
  [[nodiscard]] double T(int j) const { return (2 * j + 1) * element + approach; }  ///< j = 0 .. loads - 1
  /// Of a load from the line through the centres, towards the leading side.
  [[nodiscard]] double position(int j) const { return (2 * leading - 1 - 2 * j) * element; }
};

Grid grid(const data::ViscoelasticNip& nip, const ViscoelasticLineLoadMethod& method, double leading_length) {
  return {leading_length / (2 * method.leading_elements * nip.half_thickness()), method.approach,
          method.leading_elements, method.leading_elements + method.trailing_elements};
}

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

ViscoelasticLineLoads solve(const data::ViscoelasticNip& nip, const ViscoelasticSheet& sheet,
                            const ViscoelasticLineLoadMethod& method, double leading_length) {
  const Grid cells = grid(nip, method, leading_length);
  const double half_thickness = nip.half_thickness();
  Eigen::MatrixXd matrix(cells.loads + 1, cells.loads + 1);
  matrix.col(0).setOnes();
  // Loads in units that give displacements over b.
  const double compliance = sheet.compliance();
  matrix.rightCols(cells.loads) = -influence(sheet, cells) / compliance;
  Eigen::VectorXd gap(cells.loads + 1);
  for (int i = 0; i <= cells.loads; ++i) {
    const double y = 2 * (method.leading_elements - i) * cells.element;
    gap(i) = y * y * half_thickness / (2 * nip.roller_radius);
  }
  const Eigen::VectorXd solved = linear_solution(matrix, gap);

  ViscoelasticLineLoads result{};
  result.systems = 1;
  result.leading_length = leading_length;
  result.trailing_length = 2 * method.trailing_elements * cells.element * half_thickness;
  result.indentation = solved(0) * half_thickness;
  const auto parabola = [&](double y) { return y * y / (2 * nip.roller_radius); };
  result.leading_displacement = result.indentation - parabola(result.leading_length);
  result.trailing_displacement = result.indentation - parabola(result.trailing_length);
  double moment = 0;
  for (int j = 0; j < cells.loads; ++j) {
    const double load = solved(j + 1) * half_thickness / compliance;
    result.loads.push_back(load);
    result.load += load;
    moment += load * cells.position(j) * half_thickness;
  }
  result.peak_pressure = std::ranges::max(result.loads) / (2 * cells.element * half_thickness);
  result.rolling_resistance = moment / (result.load * nip.roller_radius);
  return result;
}

ViscoelasticLineLoads solve_for_load(const data::ViscoelasticNip& nip, const ViscoelasticSheet& sheet,
                                     const ViscoelasticLineLoadMethod& method, double load) {
  const double half_space = std::sqrt(load * nip.roller_radius * sheet.compliance());
  LengthSearch lengths(load, half_space, {.tolerance = 1e-10, .longest = nip.roller_radius});
  int systems = 0;
  ViscoelasticLineLoads result = solution_at_end(lengths, [&](double length) {
    ++systems;
    return solve(nip, sheet, method, length);
  });
  if (!lengths.met()) {
    throw BadInput("load", load,
                   "must be one that line loads on a length below the roller's radius can carry");
  }
  result.systems = systems;
  return result;
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
  check_elements("trailing_elements", trailing_elements, 0);
  if (!(std::isfinite(approach) && approach > 0))
    throw BadInput("approach_lengths", approach, "must be finite and > 0");
  if (!(residue_terms >= 0 && residue_terms <= most_residue_terms)) {
    throw BadInput("residue_terms", residue_terms, "must be from 0 to " + std::to_string(most_residue_terms));
  }
  if (!(smallest_term >= 0 && smallest_term <= 1))
    throw BadInput("smallest_term", smallest_term, "must be from 0 to 1");
}

bool ViscoelasticLineLoads::presses_everywhere() const {
  return std::ranges::all_of(loads, [](double force) { return force >= 0; });
}

ViscoelasticLineLoads viscoelastic_line_loads_for_length(const data::ViscoelasticNip& nip,
                                                         const ViscoelasticLineLoadMethod& method,
                                                         double leading_length) {
  nip.check();
  method.check();
  if (!(leading_length > 0 && leading_length <= nip.roller_radius))
    throw BadInput("leading_length", leading_length, "must be > 0 and at most the roller's radius");
  return solve(nip, ViscoelasticSheet(nip, method.residue_terms, method.smallest_term), method,
               leading_length);
}

ViscoelasticLineLoads viscoelastic_line_loads_for_load(const data::ViscoelasticNip& nip,
                                                       const ViscoelasticLineLoadMethod& method,
                                                       double load) {
  nip.check();
  method.check();
  check_contact_load(load);
  return solve_for_load(nip, ViscoelasticSheet(nip, method.residue_terms, method.smallest_term), method,
                        load);
}

ViscoelasticLineLoads viscoelastic_line_loads_by_search(const data::ViscoelasticNip& nip,
                                                        ViscoelasticLineLoadMethod method, double load) {
  nip.check();
  check_contact_load(load);
  method.trailing_elements = method.leading_elements;
  method.check();
  const ViscoelasticSheet sheet(nip, method.residue_terms, method.smallest_term);
  for (int systems = 0;; --method.trailing_elements) {
    ViscoelasticLineLoads result = solve_for_load(nip, sheet, method, load);
    result.systems = systems += result.systems;
    if (result.presses_everywhere() || method.trailing_elements == 0) return result;
  }
}

double creep_ratio(const data::ViscoelasticNip& nip, const ViscoelasticLineLoads& loads,
                   const ViscoelasticLineLoadMethod& method) {
  method.check();
  const ViscoelasticSheet sheet(nip, method.residue_terms, method.smallest_term);
  const Grid cells = grid(nip, method, loads.leading_length);
  const auto tangential = [&](int i) {
    double sum = 0;
    // The pinned point is where the rollers' centres are when the matching point is at i.
    for (int j = 0; j < cells.loads; ++j)
      sum += loads.loads[static_cast<std::size_t>(j)] *
             sheet.tangential_displacement(cells.t(i), cells.T(j), cells.t(i) - cells.position(j));
    return sum;
  };
  return (tangential(0) - tangential(cells.loads)) / loads.contact_length();
}

}  // namespace nipref::fast
