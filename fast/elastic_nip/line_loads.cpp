#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/elastic_nip/internal/elastic_sheet.hpp>
#include <nipref/fast/nip/internal/counted_kernels.hpp>
#include <nipref/fast/nip/internal/length_search.hpp>
#include <nipref/fast/number/internal/checks.hpp>
#include <nipref/fast/number/internal/feasible_set.hpp>
#include <nipref/fast/number/internal/linear_system.hpp>
#include <nipref/fast/sheet/kernels.hpp>
#include <nipref/fast/sheet/plain_series.hpp>

namespace nipref::fast {
namespace {

using data::LineLoadFriction;

constexpr int most_elements = 10000;
constexpr double widest_half_element = 300;  // in half-thicknesses; e^(-2.106 * 300) = 1e-274

/// Which kernels are needed.
struct WantedKernels {
  bool I1 = false;
  bool coupling = false;
  bool I6 = false;
};

/// The values of the kernels, empty if not wanted, N = theta1 + theta2. Under a normal load u is N/pi I1 and v is N/pi
/// times the coupling I3 - (theta2/N) I2. Under a shear load u is -N/pi times the coupling and v is N/pi I6. Functions
/// of eta, equal for all alpha, are left out: in a symmetric nip they cancel between the loads at +-Y.
struct LineLoadKernels {
  Eigen::RowVectorXd I1, coupling, I6;
};

/// The kernels at each alpha, finite and nonzero, as `method` computes them; counted into `work`.
LineLoadKernels line_load_kernels(const data::ElasticMaterial& material, const LineLoadMethod& method,
                                  std::span<const double> alpha, WantedKernels wanted, Work& work) {
  LineLoadKernels kernels;
  if (method.residue_terms == 0) {
    CountedKernels of_library(method.accuracy, work);
    if (wanted.I1) kernels.I1 = of_library.I1(alpha);
    if (wanted.coupling) kernels.coupling = of_library.I3(alpha);
    if (wanted.I6) kernels.I6 = of_library.I6(alpha);
  } else {
    const auto room = [&](bool is_wanted, std::size_t kernel, Eigen::RowVectorXd& values) {
      const std::size_t count = is_wanted ? alpha.size() : 0;
      values.resize(static_cast<Eigen::Index>(count));
      work.kernel_evaluations[kernel - 1] += count;
      work.terms += count * static_cast<std::uint64_t>(method.residue_terms);
      return std::span(values.data(), count);
    };
    plain_series(alpha, method.residue_terms,
                 {room(wanted.I1, 1, kernels.I1), room(wanted.coupling, 3, kernels.coupling),
                  room(wanted.I6, 6, kernels.I6)});
  }
  const double part = material.theta2() / material.normal_compliance();
  for (Eigen::Index i = 0; i < kernels.coupling.size(); ++i)
    kernels.coupling[i] -= part * I2(alpha[static_cast<std::size_t>(i)]);
  return kernels;
}

/// Distances a, 3a .. (4m - 1) a in half-thicknesses.
std::vector<double> odd_multiples(const data::ElasticNip& nip, const LineLoadMethod& method,
                                  double contact_length) {
  nip.check();
  method.check();
  const double half_element = contact_length / (4 * method.elements_per_side) / nip.half_thickness();
  if (!(contact_length > 0 && half_element <= widest_half_element)) {
    throw data::BadInput("contact_length", contact_length,
                         "must be > 0 and half an element at most 300 half-thicknesses");
  }
  std::vector<double> distances(2 * static_cast<std::size_t>(method.elements_per_side));
  for (std::size_t q = 0; q < distances.size(); ++q) {
    distances[q] = static_cast<double>(2 * q + 1) * half_element;
  }
  return distances;
}

/// A kernel's value at an odd multiple of half an element.
double even(const Eigen::RowVectorXd& kernel, int multiple) { return kernel[std::abs(multiple) / 2]; }
double odd(const Eigen::RowVectorXd& kernel, int multiple) {
  return multiple < 0 ? -even(kernel, multiple) : even(kernel, multiple);
}

/// The matching equations of one half of the nip; all numbers are lengths or dimensionless. The unknowns are d0 and the
/// normal loads P_1 .. P_m times N/pi, with friction also the shear loads Q_1 .. Q_m times N/pi. Matching points lie at
/// 2 i a, loads at +-(2k - 1) a, so that all distances are odd multiples of half an element a. Rows: u at i = 0 .. m,
/// with friction v at i = 1 .. m; v at the middle of the nip is 0 by symmetry. (thesis 5.8, 5.11)
Eigen::MatrixXd matching_matrix(const data::ElasticNip& nip, const LineLoadMethod& method,
                                double contact_length, bool sticks, Work& work) {
  const LineLoadKernels kernels =
      line_load_kernels(nip.material, method, odd_multiples(nip, method, contact_length),
                        {.I1 = true, .coupling = sticks, .I6 = sticks}, work);
  const int m = method.elements_per_side, unknowns = (sticks ? 2 : 1) * m + 1;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(unknowns, unknowns);
  matrix.col(0).head(m + 1).setOnes();
  for (int k = 1; k <= m; ++k) {
    for (int i = 0; i <= m; ++i) {
      const int near = 2 * (i - k) + 1, far = 2 * (i + k) - 1;
      matrix(i, k) = -(even(kernels.I1, near) + even(kernels.I1, far));
      if (!sticks) continue;
      matrix(i, m + k) = odd(kernels.coupling, near) - odd(kernels.coupling, far);
      if (i == 0) continue;
      matrix(m + i, k) = odd(kernels.coupling, near) + odd(kernels.coupling, far);
      matrix(m + i, m + k) = even(kernels.I6, near) - even(kernels.I6, far);
    }
  }
  return matrix;
}

/// The gap Y^2/(2R) on the rows of u; with friction a second column, Y on the rows of v, for a creep of 1.
Eigen::MatrixXd right_hand_sides(const data::ElasticNip& nip, int m, double contact_length, bool sticks) {
  Eigen::MatrixXd sides = Eigen::MatrixXd::Zero((sticks ? 2 : 1) * m + 1, sticks ? 2 : 1);
  for (int i = 0; i <= m; ++i) {
    const double y = i * contact_length / (2 * m);
    sides(i, 0) = y * y / (2 * nip.roller_radius);
    if (sticks && i > 0) sides(m + i, 1) = y;
  }
  return sides;
}

/// The creep ratios that meet the thesis's conditions with shear loads that push outwards (sign 1) or inwards (-1).
/// `unknowns`: a column at the creep 0 and a column of derivatives with respect to the creep.
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

/// The loads of both sides, from those of one side times N/pi.
std::vector<FaceLoad> both_sides(const data::ElasticNip& nip, int m, double width,
                                 const Eigen::VectorXd& unknowns) {
  const double unit = std::numbers::pi / nip.material.normal_compliance();
  const bool sticks = unknowns.size() > m + 1;
  std::vector<FaceLoad> loads;
  for (int j = 0; j < 2 * m; ++j) {
    const int k = j < m ? m - j : j - m + 1;
    const double shear = sticks ? unit * unknowns(m + k) : 0;
    loads.push_back({(m - j - 0.5) * width, unit * unknowns(k), j < m ? shear : 0 - shear});
  }
  return loads;
}

/// Sets loads to 0 that break the thesis's conditions of signs. At a creep that meets these, only rounding breaks them,
/// because one of the loads is 0 at an end of the creep's range.
void drop_wrong_signs(Eigen::VectorXd& unknowns, int m) {
  auto normal = unknowns.segment(1, m), shear = unknowns.tail(m);
  normal = normal.cwiseMax(0);
  const double sign = std::copysign(1, shear.sum());
  shear = sign * (sign * shear).cwiseMax(0);
}

/// The solved nip; nothing if the thesis's creep is wanted and there is none.
std::optional<LineLoadNip> solved(const data::ElasticNip& nip, const LineLoadMethod& method,
                                  double contact_length, const LineLoadFriction& friction,
                                  const std::shared_ptr<Work>& work) {
  const bool sticks = friction.kind != LineLoadFriction::Kind::none;
  const int m = method.elements_per_side;
  // The matrix comes first, because it throws BadInput outside the domain.
  const Eigen::MatrixXd matrix = matching_matrix(nip, method, contact_length, sticks, *work);
  const Eigen::MatrixXd unknowns =
      Elimination(matrix).solve_columns(right_hand_sides(nip, m, contact_length, sticks));
  work->count_system(static_cast<int>(unknowns.rows()));
  Eigen::VectorXd at_creep = unknowns.col(0);
  std::optional<double> creep;
  std::vector<CreepRange> ranges;
  if (sticks) {
    ranges = creep_ranges(unknowns, m);
    const auto chosen = thesis_creep(ranges);
    const bool by_thesis = friction.kind == LineLoadFriction::Kind::thesis_creep;
    if (by_thesis && !chosen) return std::nullopt;
    creep = by_thesis ? chosen->chosen : friction.creep;
    at_creep += *creep * unknowns.col(1);
    if (by_thesis) drop_wrong_signs(at_creep, m);
  }
  return LineLoadNip{.roller_radius = nip.roller_radius,
                     .leading_elements = m,
                     .leading_length = contact_length / 2,
                     .indentation = at_creep(0),
                     .loads = both_sides(nip, m, contact_length / (2 * m), at_creep),
                     .is_symmetric = true,
                     .sheet = elastic_sheet(nip, method, sticks),
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

void LineLoadMethod::check() const {
  internal::check_range("elements_per_side", elements_per_side, 1, most_elements);
  internal::check_range("residue_terms", residue_terms, 0, most_residue_terms);
}

LineLoadSheet elastic_sheet(const data::ElasticNip& nip, const LineLoadMethod& method, bool sticks) {
  return [=](FaceDirection direction, std::span<const FaceLoad> loads, double y, Work& work) {
    const bool normal = direction == FaceDirection::normal;
    std::vector<double> alpha;
    for (const FaceLoad& load : loads) alpha.push_back((y - load.y) / nip.half_thickness());
    const LineLoadKernels kernels =
        line_load_kernels(nip.material, method, alpha,
                          {.I1 = normal, .coupling = !normal || sticks, .I6 = !normal && sticks}, work);
    double sum = 0;
    for (Eigen::Index j = 0; const FaceLoad& load : loads) {
      sum += load.normal * (normal ? kernels.I1 : kernels.coupling)[j];
      if (sticks) sum += load.shear * (normal ? -kernels.coupling[j] : kernels.I6[j]);
      ++j;
    }
    return nip.material.normal_compliance() * std::numbers::inv_pi * sum;
  };
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
                                  double contact_length, const LineLoadFriction& friction) {
  internal::check_finite("creep", friction.creep);
  auto result = solved(nip, method, contact_length, friction, std::make_shared<Work>());
  if (!result) refuse_without_creep("contact_length", contact_length);
  return *std::move(result);
}

LineLoadNip line_loads_for_load(const data::ElasticNip& nip, const LineLoadMethod& method, double load,
                                const LineLoadFriction& friction, const LoadSearch& search) {
  internal::check_positive("load", load);
  internal::check_finite("creep", friction.creep);
  if (!(search.tolerance >= 1e-14 && search.tolerance <= 0.1))
    throw data::BadInput("tolerance", search.tolerance, "must satisfy 1e-14 <= tolerance <= 0.1");
  const auto work = std::make_shared<Work>();
  double trial = nip.sheet_thickness;
  const bool sticks = friction.kind != LineLoadFriction::Kind::none;
  if (sticks) {
    const LineLoadNip frictionless = line_loads_for_load(nip, method, load, {}, {.tolerance = 1e-2});
    *work += frictionless.work();
    trial = frictionless.contact_length();
  }
  LengthSearch lengths(
      load, trial,
      {.tolerance = search.tolerance, .fixed_exponent = search.iteration == LoadSearch::Iteration::thesis});
  LineLoadNip result = solution_at_end(lengths, [&](double length) {
    auto tried = solved(nip, method, length, friction, work);
    if (!tried) refuse_without_creep("load", load);
    if (sticks && !(tried->load() > 0)) refuse_load(load);
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
