#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/memory/moving_load.hpp>
#include <nipref/fast/memory/plain_moving_load.hpp>
#include <nipref/fast/sheet/plain_series.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>

namespace nipref::fast {
namespace {

using data::BadInput;

constexpr int most_elements = 500;
constexpr int most_iterations = 60;

/// Displacements by a moving load, plain sums or exact, with lengths in half-thicknesses and times in
/// b/speed.
class Sheet {
 public:
  Sheet(const data::ViscoelasticNip& nip, int terms) : time_(nip.half_thickness() / nip.speed) {
    if (terms == 0) {
      exact_.emplace(nip.material, nip.speed, nip.half_thickness());
    } else {
      plain_.emplace(nip.material, nip.speed, nip.half_thickness(), terms);
    }
  }

  [[nodiscard]] const PlainMovingLoad* plain() const { return plain_ ? &*plain_ : nullptr; }
  [[nodiscard]] double normal_displacement(double t, double T) const {
    return exact_->normal_displacement(t * time_, T * time_);
  }
  [[nodiscard]] double tangential_displacement(double t, double T, double t0) const {
    return plain_ ? plain_->tangential_displacement(t, T, t0)
                  : exact_->tangential_displacement(t * time_, T * time_, t0 * time_);
  }

 private:
  double time_;
  std::optional<PlainMovingLoad> plain_;
  std::optional<MovingLoad> exact_;
};

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

Eigen::MatrixXd influence(const Sheet& sheet, const Grid& grid) {
  if (sheet.plain() != nullptr) return plain_influence(*sheet.plain(), grid);
  return Eigen::MatrixXd::NullaryExpr(grid.loads + 1, grid.loads, [&](Eigen::Index i, Eigen::Index j) {
    return sheet.normal_displacement(grid.t(static_cast<int>(i)), grid.T(static_cast<int>(j)));
  });
}

ViscoelasticLineLoads solve(const data::ViscoelasticNip& nip, const Sheet& sheet,
                            const ViscoelasticLineLoadMethod& method, double leading_length) {
  const Grid cells = grid(nip, method, leading_length);
  const double half_thickness = nip.half_thickness();
  Eigen::MatrixXd matrix(cells.loads + 1, cells.loads + 1);
  matrix.col(0).setOnes();
  // Loads in units that give displacements over b.
  const double compliance = nip.material.normal_compliance().instantaneous;
  matrix.rightCols(cells.loads) = -influence(sheet, cells) / compliance;
  Eigen::VectorXd gap(cells.loads + 1);
  for (int i = 0; i <= cells.loads; ++i) {
    const double y = 2 * (method.leading_elements - i) * cells.element;
    gap(i) = y * y * half_thickness / (2 * nip.roller_radius);
  }
  const Eigen::VectorXd solved = matrix.partialPivLu().solve(gap);

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

ViscoelasticLineLoads solve_for_load(const data::ViscoelasticNip& nip, const Sheet& sheet,
                                     const ViscoelasticLineLoadMethod& method, double load) {
  // (2.13) converges slowly but surely; from its second step on the secant of ln(load) over ln(length) is
  // better.
  double length = std::sqrt(load * nip.roller_radius * nip.material.normal_compliance().instantaneous);
  double slope = 3;
  double last_log_length = 0, last_excess = 0;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    length = std::min(length, nip.roller_radius);
    ViscoelasticLineLoads result = solve(nip, sheet, method, length);
    result.systems = iteration + 1;
    if (!(result.load > 0)) {
      length *= 0.7;
      continue;
    }
    const double excess = std::log(result.load / load);
    if (std::fabs(excess) < 1e-10) return result;
    if (last_excess != 0)
      slope = std::clamp((excess - last_excess) / (std::log(length) - last_log_length), 1.0, 6.0);
    last_log_length = std::log(length);
    last_excess = excess;
    length *= std::exp(-excess / slope);
  }
  throw BadInput("load", load, "must be one that line loads on a length below the roller's radius can carry");
}

void check_elements(const char* name, int elements, int least) {
  if (!(elements >= least && elements <= most_elements)) {
    throw BadInput(name, elements,
                   "must be from " + std::to_string(least) + " to " + std::to_string(most_elements));
  }
}

void check_load(double load) {
  if (!(std::isfinite(load) && load > 0)) throw BadInput("load", load, "must be finite and > 0");
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
  return solve(nip, Sheet(nip, method.residue_terms), method, leading_length);
}

ViscoelasticLineLoads viscoelastic_line_loads_for_load(const data::ViscoelasticNip& nip,
                                                       const ViscoelasticLineLoadMethod& method,
                                                       double load) {
  nip.check();
  method.check();
  check_load(load);
  return solve_for_load(nip, Sheet(nip, method.residue_terms), method, load);
}

ViscoelasticLineLoads viscoelastic_line_loads_by_search(const data::ViscoelasticNip& nip,
                                                        ViscoelasticLineLoadMethod method, double load) {
  nip.check();
  check_load(load);
  method.trailing_elements = method.leading_elements;
  method.check();
  const Sheet sheet(nip, method.residue_terms);
  for (int systems = 0;; --method.trailing_elements) {
    ViscoelasticLineLoads result = solve_for_load(nip, sheet, method, load);
    result.systems = systems += result.systems;
    if (result.presses_everywhere() || method.trailing_elements == 0) return result;
  }
}

double creep_ratio(const data::ViscoelasticNip& nip, const ViscoelasticLineLoads& loads,
                   const ViscoelasticLineLoadMethod& method) {
  method.check();
  const Sheet sheet(nip, method.residue_terms);
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
