#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/elastic_nip/internal/line_loads_system.hpp>
#include <nipref/fast/nip/internal/length_search.hpp>
#include <nipref/fast/number/internal/checks.hpp>
#include <nipref/fast/number/internal/feasible_set.hpp>
#include <nipref/fast/number/internal/linear_system.hpp>

namespace nipref::fast {
namespace {

using data::Grip;

class ElasticSheet final : public LineLoadSheet {
 public:
  ElasticSheet(const data::ElasticNip& nip, const LineLoadMethod& method, bool grips)
      : nip_(nip), method_(method), grips_(grips) {}

  [[nodiscard]] double displacement(Direction direction, std::span<const FaceLoad> loads, double y,
                                    Work& work) const override {
    const bool normal = direction == Direction::normal;
    std::vector<double> alpha;
    for (const FaceLoad& load : loads) alpha.push_back((y - load.y) / nip_.half_thickness());
    const LineLoadKernels kernels =
        line_load_kernels(nip_.material, method_, alpha,
                          {.I1 = normal, .coupling = !normal || grips_, .I6 = !normal && grips_}, work);
    double sum = 0;
    for (Eigen::Index j = 0; const FaceLoad& load : loads) {
      sum += load.normal * (normal ? kernels.I1 : kernels.coupling)[j];
      if (grips_) sum += load.shear * (normal ? -kernels.coupling[j] : kernels.I6[j]);
      ++j;
    }
    return nip_.material.normal_compliance() * std::numbers::inv_pi * sum;
  }

 private:
  data::ElasticNip nip_;
  LineLoadMethod method_;
  bool grips_;
};

/// The gap Y^2/(2R) on the rows of u; with friction also, for a creep of 1 on an undeformed roller, Y on those of v.
Eigen::MatrixXd right_hand_sides(const data::ElasticNip& nip, int m, double contact_length, bool grips) {
  Eigen::MatrixXd sides = Eigen::MatrixXd::Zero((grips ? 2 : 1) * m + 1, grips ? 2 : 1);
  for (int i = 0; i <= m; ++i) {
    const double y = i * contact_length / (2 * m);
    sides(i, 0) = y * y / (2 * nip.roller_radius);
    if (grips && i > 0) sides(m + i, 1) = y;
  }
  return sides;
}

/// Creep ratios that meet the thesis's conditions, the shear loads pushing outwards (sign 1) or inwards (-1).
/// `unknowns`: at a creep of 0, and per creep.
FeasibleSet feasible(const Eigen::MatrixXd& unknowns, int m, double sign) {
  const auto unknown = [&](int index) { return Quadratic{unknowns(index, 0), unknowns(index, 1)}; };
  FeasibleSet creeps;
  for (int k = 1; k <= m; ++k) {
    creeps.require_not_negative(unknown(k));
    creeps.require_not_negative(sign * unknown(m + k));
  }
  for (int k = 1; k < m; ++k) {
    creeps.require_not_negative(sign * (unknown(m + k + 1) * unknown(k) - unknown(m + k) * unknown(k + 1)));
  }
  return creeps;
}

std::vector<CreepRange> creep_ranges(const Eigen::MatrixXd& unknowns, int m) {
  std::vector<CreepRange> both;
  for (const double sign : {-1.0, 1.0}) {
    const FeasibleSet creeps = feasible(unknowns, m, sign);
    for (const auto& [lower, upper] : creeps.parts()) both.push_back({lower, upper});
  }
  std::ranges::sort(both, {}, &CreepRange::lower);
  return both;
}

/// The loads of both sides, from those of one times N/pi.
std::vector<FaceLoad> both_sides(const data::ElasticNip& nip, int m, double width,
                                 const Eigen::VectorXd& unknowns) {
  const double unit = std::numbers::pi / nip.material.normal_compliance();
  const bool grips = unknowns.size() > m + 1;
  std::vector<FaceLoad> loads;
  for (int j = 0; j < 2 * m; ++j) {
    const int k = j < m ? m - j : j - m + 1;
    const double shear = grips ? unit * unknowns(m + k) : 0;
    loads.push_back({(m - j - 0.5) * width, unit * unknowns(k), j < m ? shear : 0 - shear});
  }
  return loads;
}

/// Nothing if the thesis's creep is wanted and there is none.
std::optional<LineLoadNip> solved(const data::ElasticNip& nip, const LineLoadMethod& method,
                                  double contact_length, const Grip& grip,
                                  const std::shared_ptr<Work>& work) {
  const bool grips = grip.kind != Grip::Creep::none;
  const int m = method.elements_per_side;
  // First, as it refuses what is out of its domain.
  const Eigen::MatrixXd matrix = matching_matrix(nip, method, contact_length, grips, *work);
  const Eigen::MatrixXd unknowns =
      Elimination(matrix).solve_columns(right_hand_sides(nip, m, contact_length, grips));
  ++work->systems;
  work->unknowns = std::max(work->unknowns, static_cast<int>(unknowns.rows()));
  Eigen::VectorXd at_creep = unknowns.col(0);
  std::optional<double> creep;
  std::vector<CreepRange> ranges;
  if (grips) {
    ranges = creep_ranges(unknowns, m);
    const auto chosen = thesis_creep(ranges);
    if (grip.kind == Grip::Creep::thesis && !chosen) return std::nullopt;
    creep = grip.kind == Grip::Creep::given ? grip.creep : chosen->chosen;
    at_creep += *creep * unknowns.col(1);
  }
  return LineLoadNip{.roller_radius = nip.roller_radius,
                     .leading_elements = m,
                     .leading_length = contact_length / 2,
                     .indentation = at_creep(0),
                     .loads = both_sides(nip, m, contact_length / (2 * m), at_creep),
                     .is_symmetric = true,
                     .sheet = elastic_sheet(nip, method, grips),
                     .spent = work,
                     .gripped_creep = creep,
                     .creep_ranges = std::move(ranges)};
}

[[noreturn]] void refuse_without_creep(const char* argument, double value) {
  throw data::BadInput(
      argument, value,
      "no creep meets the thesis's conditions here: a creep ratio must be given, or other elements");
}

[[noreturn]] void refuse_load(double load) {
  throw data::BadInput("load", load, "no contact length was found that carries it");
}

}  // namespace

std::shared_ptr<const LineLoadSheet> elastic_sheet(const data::ElasticNip& nip, const LineLoadMethod& method,
                                                   bool grips) {
  return std::make_shared<const ElasticSheet>(nip, method, grips);
}

std::optional<ThesisCreep> thesis_creep(std::span<const CreepRange> ranges) {
  std::optional<ThesisCreep> least;
  for (const CreepRange& range : ranges) {
    const double nearest = std::clamp(0.0, range.lower, range.upper);
    if (!least || std::fabs(nearest) < std::fabs(least->chosen)) least = {range, nearest};
  }
  return least;
}

LineLoadNip line_loads_for_length(const data::ElasticNip& nip, const LineLoadMethod& method,
                                  double contact_length, const Grip& grip) {
  internal::check_finite("creep", grip.creep);
  auto result = solved(nip, method, contact_length, grip, std::make_shared<Work>());
  if (!result) refuse_without_creep("contact_length", contact_length);
  return *std::move(result);
}

LineLoadNip line_loads_for_load(const data::ElasticNip& nip, const LineLoadMethod& method, double load,
                                const Grip& grip, const LoadSearch& search) {
  internal::check_positive("load", load);
  internal::check_finite("creep", grip.creep);
  if (!(search.tolerance >= 1e-14 && search.tolerance <= 0.1))
    throw data::BadInput("tolerance", search.tolerance, "must satisfy 1e-14 <= tolerance <= 0.1");
  const auto work = std::make_shared<Work>();
  double trial = nip.sheet_thickness;
  const bool grips = grip.kind != Grip::Creep::none;
  if (grips) {
    const LineLoadNip frictionless = line_loads_for_load(nip, method, load, {}, {.tolerance = 1e-2});
    *work += frictionless.work();
    trial = frictionless.contact_length();
  }
  LengthSearch lengths(
      load, trial,
      {.tolerance = search.tolerance, .fixed_exponent = search.iteration == LoadSearch::Iteration::thesis});
  LineLoadNip result = solution_at_end(lengths, [&](double length) {
    auto tried = solved(nip, method, length, grip, work);
    if (!tried) refuse_without_creep("load", load);
    if (grips && !(tried->load() > 0)) refuse_load(load);
    return *std::move(tried);
  });
  if (!lengths.met()) refuse_load(load);
  return result;
}

double condition_number(const data::ElasticNip& nip, const LineLoadMethod& method, double contact_length,
                        data::Friction friction) {
  Work work;
  return condition_number(
      matching_matrix(nip, method, contact_length, friction == data::Friction::full, work));
}

double oscillation(std::span<const double> loads) {
  double bends = 0;
  double sizes = 0;
  for (std::size_t k = 0; k < loads.size(); ++k) {
    sizes += std::abs(loads[k]);
    if (k >= 2) bends += std::abs(loads[k] - 2 * loads[k - 1] + loads[k - 2]);
  }
  return sizes > 0 ? bends / sizes : 0;
}

}  // namespace nipref::fast
