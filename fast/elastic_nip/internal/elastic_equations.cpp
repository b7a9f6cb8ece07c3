#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/fast/elastic_nip/internal/elastic_equations.hpp>
#include <nipref/fast/nip/internal/length_search.hpp>
#include <nipref/fast/number/internal/bisection.hpp>
#include <nipref/fast/sheet/field.hpp>

namespace nipref::fast {
namespace {

constexpr double pi = std::numbers::pi;

using Alphas = CountedKernels::Alphas;
using Eigen::MatrixXd, Eigen::RowVectorXd;

/// The strain from a load elsewhere: N/2 times the stress along the face. At its own place the load adds a local part.
double nonlocal_strain(double alpha) { return sheet_stresses(alpha, 1, data::SheetLoad::normal).along / 2; }

/// The effect of an end fades like e^(-decay e). Without friction the kernel's transform 2 sinh^2 k/(k (sinh 2k + 2k))
/// is 0 at k = pi i. With full friction the determinant of the transforms is 0 if a sheet with clamped faces has a free
/// field: (3 - 4 poisson) sinh 2k = 2k, at k = i decay with 0 <= 2 decay < pi.
double decay_of_ends(bool sticks, double poisson) {
  if (!sticks) return pi;
  const double ratio = 1 / (3 - 4 * poisson);
  return internal::last_that([&](double x) { return std::sin(x) >= ratio * x; }, 0.0, pi) / 2;
}

}  // namespace

ElasticEquations::ElasticEquations(data::Friction friction, double poisson)
    : sticks_(friction == data::Friction::full),
      beta_((1 - 2 * poisson) / (2 * (1 - poisson))),
      decay_(decay_of_ends(sticks_, poisson)) {}

Resolution ElasticEquations::resolution(double nats) const { return {nats, decay_, sticks_ ? 5 : 2, {}}; }

/// A long sheet that sticks is a film whose middle moves along it by a parabola of the depth, as p' shears it. So
/// u = (p - l^2 p'')/M with M = 1/(2 beta (1 - beta)) and l^2 = 1/(3 beta). With p and p' 0 at the ends its load is M A^3
/// times 4/3 - 4 coth(x)/x + 4/x^2, x = A/l, which is (4/3)/(1 + 3/x + 15/x^2) to 17 %.
double ElasticEquations::softening_over(double half_length) const {
  if (!sticks_) return 1;
  const double A = half_length, film = 2 * std::pow(A, 3) /
                                       (3 * (1 - beta_) * (beta_ + std::sqrt(3 * beta_) / A + 5 / (A * A)));
  return film > 0 ? std::min(1.0, load_guess(A) / film) : 1;
}

RowVectorXd ElasticEquations::coupling(Alphas alpha, CountedKernels& kernels) const {
  RowVectorXd values = kernels.I3(alpha);
  std::ranges::transform(values, alpha, values.begin(), [this](double i3, double at) {
    return (i3 - beta_ * std::copysign(pi / 2, at)) / pi;
  });
  return values;
}

Tractions::Kernel ElasticEquations::along_kernel(CountedKernels& kernels) const {
  return {2,
          Tractions::Kernel::FarAway::linear,
          {},
          [&kernels, this](Alphas alpha, MatrixXd& on_p, MatrixXd& on_q) {
            on_p = coupling(alpha, kernels);
            on_p.conservativeResize(2, Eigen::NoChange);
            std::ranges::transform(alpha, on_p.row(1).begin(), nonlocal_strain);
            on_q = on_p;
          }};
}

Tractions::SplitKernel ElasticEquations::matching(CountedKernels& kernels) const {
  if (!sticks_) return frictionless_kernel(kernels);
  const auto both = [](const RowVectorXd& i1, const RowVectorXd& i3, const RowVectorXd& i6, MatrixXd& on_p,
                       MatrixXd& on_q) {
    on_p.resize(2, i1.size());
    on_q.resize(2, i1.size());
    on_p << i1 / pi, i3;
    on_q << -i3, i6 / pi;
  };
  const auto whole = [=, &kernels, this](Alphas alpha, MatrixXd& on_p, MatrixXd& on_q) {
    both(kernels.I1(alpha), coupling(alpha, kernels), kernels.I6(alpha), on_p, on_q);
  };
  const auto regular = [=, &kernels](Alphas alpha, Alphas logarithm, MatrixXd& on_p, MatrixXd& on_q) {
    both(kernels.regular_I1(alpha, logarithm), kernels.I3(alpha) / pi, kernels.regular_I6(alpha, logarithm),
         on_p, on_q);
  };
  return {{2, Tractions::Kernel::FarAway::linear, {}, whole},
          Eigen::Matrix2d::Identity(),
          Eigen::Matrix2d{{0, beta_ / 2}, {-beta_ / 2, 0}},
          regular};
}

Solution ElasticEquations::solve(double half_length, const std::vector<Panel>& panels, double tolerance,
                                 CountedKernels& kernels) const {
  Tractions tractions(half_length, panels, sticks_, {0.5, sticks_ ? -std::atanh(beta_) / pi : 0});
  const int each = sticks_ ? 2 : 1;
  auto [points, of_tractions, sizes] = tractions.matching_rows(matching(kernels), tolerance);
  Equations equations(std::move(of_tractions), std::move(sizes), each, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double e = points[i];
    const auto row = static_cast<Eigen::Index>(i) * each;
    equations.on_unknowns(row, edge_displacement) = -1;
    equations.right(row) = e * (2 * half_length - e);
    if (sticks_) equations.on_unknowns(row + 1, creep) = -(half_length - e);
  }
  return {std::move(tractions), equations};
}

std::vector<AccuracyTarget> ElasticEquations::accuracy_targets(const Solution& solution) const {
  const double half_length = solution.half_length();
  std::vector<AccuracyTarget> targets{{solution.of_unknown(edge_displacement), half_length * half_length}};
  if (sticks_) targets.push_back({solution.of_unknown(creep), half_length});
  return targets;
}

Functional ElasticEquations::roller_displacement(const Solution& solution, double y) const {
  Functional displacement = solution.of_unknown(edge_displacement);
  displacement.constant = (solution.half_length() - y) * (solution.half_length() + y);
  return displacement;
}

Functional ElasticEquations::end_displacement(const Solution& solution, bool /*trailing*/) const {
  return solution.of_unknown(edge_displacement);
}

/// The rows of a kernel's functionals at a place, or at its mirror image if it is on the trailing half.
static MatrixXd acting(const Solution& solution, const Tractions::Kernel& kernel, const ContactPlace& place) {
  return solution.tractions().rows(place.from_nearer_end_of(solution).e, false, kernel, quadrature_tolerance);
}

double ElasticEquations::cancelling_sides(const Solution& solution) const {
  return (0.2505 + std::fabs(beta_) / 2) * solution.carried_load();
}

Functional ElasticEquations::normal_displacement(const Solution& solution, const ContactPlace& place,
                                                 CountedKernels& kernels) const {
  Functional displacement = solution.of_tractions(acting(solution, matching(kernels).whole, place).row(0));
  // I1 is negative only farther than 1.28 from the load, by 0.02 and an integral of 0.022 at most. The pressure is below
  // 2 A + 2 A^2, its sum for a half-space and for springs, and the parts that cancel are far below A^2, an upper bound.
  displacement.cancelled = std::pow(solution.half_length(), 2) + (sticks_ ? cancelling_sides(solution) : 0);
  return displacement;
}

AlongSurface ElasticEquations::along_surface(const Solution& solution, const ContactPlace& place,
                                             CountedKernels& kernels) const {
  const MatrixXd rows = acting(solution, sticks_ ? matching(kernels).whole : along_kernel(kernels), place);
  // The displacement is odd.
  const double sign = place.from_nearer_end_of(solution).trailing ? -1 : 1;
  Functional displacement = solution.of_tractions(sign * rows.row(sticks_ ? 1 : 0));
  displacement.cancelled = cancelling_sides(solution);
  if (sticks_) return {displacement, {}};
  Functional strain = solution.of_tractions(rows.row(1));
  // The largest pressure, an upper bound: the integral of |nonlocal_strain| is 0.502.
  strain.cancelled = solution.traction(solution.half_length()).real();
  strain.on_tractions -= beta_ * traction(solution, TractionComponent::pressure, place).on_tractions;
  return {displacement, strain};
}

Functional ElasticEquations::creep_ratio(const Solution& solution, CountedKernels& kernels) const {
  if (sticks_) return solution.of_unknown(creep);
  return 1 / solution.half_length() * along_surface(solution, {false, 0}, kernels).displacement;
}

}  // namespace nipref::fast
