#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/fast/elastic_nip/internal/elastic_equations.hpp>
#include <nipref/fast/nip/internal/frictionless_kernel.hpp>
#include <nipref/fast/nip/internal/length_search.hpp>
#include <nipref/fast/number/internal/bisection.hpp>
#include <nipref/fast/sheet/field.hpp>

namespace nipref::fast {
namespace {

constexpr double pi = std::numbers::pi;

using Alphas = std::span<const double>;

double coupling(double i3, double alpha, double beta) {
  return (i3 - beta * std::copysign(pi / 2, alpha)) / pi;
}

/// N/2 times the stress along the face, of which the load itself makes a part at its own place only.
double nonlocal_strain(double alpha) { return sheet_stresses(alpha, 1, data::SheetLoad::normal).along / 2; }

/// What an end causes fades like e^(-decay e). Without friction the kernel's transform 2 sinh^2 k/(k (sinh 2k + 2k)) is 0
/// at k = pi i. With full friction the determinant of the transforms is 0 where a sheet with clamped faces has a free
/// field: (3 - 4 poisson) sinh 2k = 2k, at k = i decay with 0 <= 2 decay < pi.
double decay_of_ends(bool grips, double poisson) {
  if (!grips) return pi;
  const double ratio = 1 / (3 - 4 * poisson);
  return internal::last_that([&](double x) { return std::sin(x) >= ratio * x; }, 0.0, pi) / 2;
}

}  // namespace

ElasticEquations::ElasticEquations(data::Friction friction, double poisson)
    : grips_(friction == data::Friction::full),
      beta_((1 - 2 * poisson) / (2 * (1 - poisson))),
      decay_(decay_of_ends(grips_, poisson)) {}

Resolution ElasticEquations::resolution(double nats) const { return {nats, decay_, grips_ ? 5 : 2, {}}; }

Tractions::Kernel ElasticEquations::normal_kernel(CountedKernels& kernels) const {
  if (!grips_) return frictionless_kernel(kernels).whole;
  return {1, false, {}, [&kernels, this](Alphas alpha, Eigen::MatrixXd& on_p, Eigen::MatrixXd& on_q) {
            const std::vector<double> i1 = kernels.I1(alpha), i3 = kernels.I3(alpha);
            on_p.resize(1, static_cast<Eigen::Index>(alpha.size()));
            on_q.resize(1, on_p.cols());
            for (std::size_t i = 0; i < alpha.size(); ++i) {
              on_p(static_cast<Eigen::Index>(i)) = i1[i] / pi;
              on_q(static_cast<Eigen::Index>(i)) = -coupling(i3[i], alpha[i], beta_);
            }
          }};
}

Tractions::Kernel ElasticEquations::along_kernel(CountedKernels& kernels) const {
  return {grips_ ? 1 : 2,
          false,
          {},
          [&kernels, this](Alphas alpha, Eigen::MatrixXd& on_p, Eigen::MatrixXd& on_q) {
            const std::vector<double> i3 = kernels.I3(alpha),
                                      i6 = grips_ ? kernels.I6(alpha) : std::vector<double>();
            on_p.resize(grips_ ? 1 : 2, static_cast<Eigen::Index>(alpha.size()));
            on_q.resizeLike(on_p);
            for (std::size_t i = 0; i < alpha.size(); ++i) {
              const auto column = static_cast<Eigen::Index>(i);
              on_p(0, column) = coupling(i3[i], alpha[i], beta_);
              if (grips_)
                on_q(0, column) = i6[i] / pi;
              else
                on_p(1, column) = nonlocal_strain(alpha[i]);
            }
          }};
}

Tractions::Kernel ElasticEquations::strain_kernel() {
  return {1, true, {}, [](Alphas alpha, Eigen::MatrixXd& on_p, Eigen::MatrixXd& on_q) {
            on_p.resize(1, static_cast<Eigen::Index>(alpha.size()));
            std::ranges::transform(alpha, on_p.data(), nonlocal_strain);
            on_q.resizeLike(on_p);
          }};
}

/// Both displacements at once.
Tractions::Kernel ElasticEquations::both(CountedKernels& kernels) const {
  return {2, false, {}, [&kernels, this](Alphas alpha, Eigen::MatrixXd& on_p, Eigen::MatrixXd& on_q) {
            const std::vector<double> i1 = kernels.I1(alpha), i3 = kernels.I3(alpha), i6 = kernels.I6(alpha);
            on_p.resize(2, static_cast<Eigen::Index>(alpha.size()));
            on_q.resize(2, on_p.cols());
            for (std::size_t i = 0; i < alpha.size(); ++i) {
              const auto column = static_cast<Eigen::Index>(i);
              on_p(1, column) = coupling(i3[i], alpha[i], beta_);
              on_q(0, column) = -on_p(1, column);
              on_p(0, column) = i1[i] / pi;
              on_q(1, column) = i6[i] / pi;
            }
          }};
}

Tractions::SplitKernel ElasticEquations::matching(CountedKernels& kernels) const {
  if (!grips_) return frictionless_kernel(kernels);
  return {both(kernels), Eigen::Matrix2d::Identity(), Eigen::Matrix2d{{0, beta_ / 2}, {-beta_ / 2, 0}},
          [&kernels](Alphas alpha, Eigen::MatrixXd& on_p, Eigen::MatrixXd& on_q) {
            const auto row = [](const std::vector<double>& values) {
              return Eigen::Map<const Eigen::RowVectorXd>(values.data(),
                                                          static_cast<Eigen::Index>(values.size())) /
                     pi;
            };
            const std::vector<double> i1 = kernels.regular_I1(alpha), i3 = kernels.I3(alpha),
                                      i6 = kernels.regular_I6(alpha);
            on_p.resize(2, static_cast<Eigen::Index>(alpha.size()));
            on_q.resize(2, on_p.cols());
            on_p << row(i1), row(i3);
            on_q << -row(i3), row(i6);
          }};
}

Solution ElasticEquations::solve(double half_length, const std::vector<Panel>& panels, double tolerance,
                                 CountedKernels& kernels) const {
  std::vector<Panel> fitted = panels;
  fitted.back().right = 2 * half_length - fitted.back().left;
  const Tractions tractions(half_length, fitted, grips_, {0.5, grips_ ? -std::atanh(beta_) / pi : 0});
  const std::vector<double> points = tractions.matching_points();
  const int each = grips_ ? 2 : 1;
  const auto rows = static_cast<Eigen::Index>(points.size()) * each;
  Tractions::MatchingRows of_tractions = tractions.matching_rows(matching(kernels), tolerance);
  Equations equations{std::move(of_tractions.rows),
                      Eigen::MatrixXd::Zero(rows, each),
                      Eigen::VectorXd::Zero(rows),
                      std::move(of_tractions.sizes),
                      {},
                      {},
                      {}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double e = points[i];
    const auto row = static_cast<Eigen::Index>(i) * each;
    equations.on_unknowns(row, edge_displacement) = -1;
    equations.right(row) = e * (2 * half_length - e);
    if (grips_) equations.on_unknowns(row + 1, creep_ratio) = -(half_length - e);
  }
  return {tractions, equations};
}

std::vector<AccuracyTarget> ElasticEquations::accuracy_targets(const Solution& solution) const {
  const double half_length = solution.half_length();
  const double middle = solution.traction(half_length).real();
  std::vector<AccuracyTarget> targets{{solution.of_unknown(edge_displacement), half_length * half_length}};
  for (const Panel& panel : solution.tractions().panels()) {
    const double at = panel.about_middle && !panel.at_end ? half_length : panel.left + 0.2 * panel.width();
    const Eigen::MatrixXd both = solution.tractions().values(at);
    targets.push_back({solution.of_tractions(both.row(0)), middle});
    if (grips_) targets.push_back({solution.of_tractions(both.row(1)), middle});
  }
  if (grips_) targets.push_back({solution.of_unknown(creep_ratio), half_length});
  return targets;
}

double ElasticEquations::half_length_guess(double load) const { return fast::half_length_guess(load); }

Functional ElasticEquations::roller_displacement(const Solution& solution, double y) const {
  Functional displacement = solution.of_unknown(edge_displacement);
  displacement.constant = (solution.half_length() - y) * (solution.half_length() + y);
  return displacement;
}

Functional ElasticEquations::end_displacement(const Solution& solution, bool /*trailing*/) const {
  return solution.of_unknown(edge_displacement);
}

namespace {

/// The rows of a kernel's functionals at a place of the half on which it is not mirrored.
Eigen::MatrixXd acting(const Solution& solution, const Tractions::Kernel& kernel, const ContactPlace& place) {
  const double at[] = {place.in(solution).e};
  return solution.tractions().rows(at, false, kernel, quadrature_tolerance);
}

}  // namespace

double ElasticEquations::cancelling_sides(const Solution& solution) const {
  return (0.25 + std::fabs(beta_) / 2) * solution.value(solution.load());
}

Functional ElasticEquations::normal(const Solution& solution, const ContactPlace& place,
                                    CountedKernels& kernels) const {
  Functional displacement = solution.of_tractions(acting(solution, normal_kernel(kernels), place));
  displacement.cancelled = std::pow(solution.half_length(), 2) + (grips_ ? cancelling_sides(solution) : 0);
  return displacement;
}

SurfaceAlong ElasticEquations::along(const Solution& solution, const ContactPlace& place,
                                     CountedKernels& kernels) const {
  const Eigen::MatrixXd rows = acting(solution, along_kernel(kernels), place);
  // It is odd.
  const double sign = place.in(solution).trailing ? -1 : 1;
  Functional displacement = solution.of_tractions(sign * rows.row(0));
  displacement.cancelled = cancelling_sides(solution);
  if (grips_) return {displacement, {}};
  return {displacement, with_pressure_there(solution, place, rows.row(1))};
}

Functional ElasticEquations::strain(const Solution& solution, const ContactPlace& place) const {
  return with_pressure_there(solution, place, acting(solution, strain_kernel(), place));
}

Functional ElasticEquations::with_pressure_there(const Solution& solution, const ContactPlace& place,
                                                 const Eigen::RowVectorXd& nonlocal) const {
  Functional strain = solution.of_tractions(nonlocal);
  strain.cancelled = solution.traction(solution.half_length()).real();
  strain.on_tractions -= beta_ * traction(solution, TractionComponent::pressure, place).on_tractions;
  return strain;
}

Functional ElasticEquations::creep(const Solution& solution, CountedKernels& kernels) const {
  if (grips_) return solution.of_unknown(creep_ratio);
  return 1 / solution.half_length() * along(solution, {false, 0}, kernels).displacement;
}

}  // namespace nipref::fast
