#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/fast/nip/internal/length_search.hpp>
#include <nipref/fast/nip/internal/nip_equations.hpp>

namespace nipref::fast {
namespace {

/// A contact with memory carries about the load of one with the compliance that acts over this part of its half-length.
constexpr double part_that_softens = 0.47;

}  // namespace

ContactPlace ContactPlace::from_nearer_end_of(const Solution& solution) const {
  if (e <= solution.half_length()) return *this;
  return {!trailing, std::max(0.0, 2 * solution.half_length() - e)};
}

Functional NipEquations::traction(const Solution& solution, TractionComponent component,
                                  const ContactPlace& place) const {
  if (!(place.e > 0)) return solution.of_tractions(Eigen::RowVectorXd::Zero(solution.tractions().columns()));
  const auto [trailing, e] = place.from_nearer_end_of(solution);
  Eigen::MatrixXd both = solution.tractions().values(e);
  if (trailing) both.row(1) *= -1;
  if (!sticks()) return solution.of_tractions(both.colwise().sum());
  return solution.of_tractions(both.row(component == TractionComponent::pressure ? 0 : 1));
}

Functional NipEquations::eccentricity(const Solution& solution) const {
  const double load = solution.carried_load(), from_middle = solution.value(solution.moment()) / load;
  Functional result = solution.of_unknown(*offset_unknown());
  result.on_tractions =
      solution.moment().on_tractions / load - from_middle * (solution.load().on_tractions / load);
  result.constant = from_middle;
  return result;
}

/// Each step halves the error: a load grows at least like the length squared, softening at most like the length. In a
/// film that sticks it leaves up to two thirds, because softening falls at most like the length to the power -2.
double NipEquations::half_length_of(double load) const {
  constexpr int most_steps = 5;
  const double part = sticks() ? 1 : part_that_softens;
  double half_length = 0, softening = 0;
  for (int i = 0; i < most_steps; ++i) {
    const double before = std::exchange(softening, softening_over(part * half_length));
    if (softening == before) break;
    half_length = half_length_guess(load * softening);
  }
  return half_length;
}

double NipEquations::load_exponent_at(double half_length) const {
  constexpr double longer = 1.01;
  const double softening = softening_over(longer * half_length) / softening_over(half_length);
  return load_exponent(half_length) - std::log(softening) / std::log(longer);
}

Tractions::SplitKernel frictionless_kernel(CountedKernels& kernels) {
  using Alphas = CountedKernels::Alphas;
  // Eigen copies a row to a matrix of any size number by number, but a row to a row by vectors.
  const auto on_both = [](const Eigen::RowVectorXd& values, Eigen::MatrixXd& on_p, Eigen::MatrixXd& on_q) {
    on_p.resize(1, values.size());
    Eigen::RowVectorXd::Map(on_p.data(), values.size()) = values / std::numbers::pi;
    on_q = on_p;
  };
  const auto whole = [=, &kernels](Alphas alpha, Eigen::MatrixXd& on_p, Eigen::MatrixXd& on_q) {
    on_both(kernels.I1(alpha), on_p, on_q);
  };
  const auto regular = [=, &kernels](Alphas alpha, Alphas logarithm, Eigen::MatrixXd& on_p,
                                     Eigen::MatrixXd& on_q) {
    on_both(kernels.regular_I1(alpha, logarithm), on_p, on_q);
  };
  return {{1, Tractions::Kernel::FarAway::negligible, {}, whole},
          Eigen::RowVector2d(1, 1),
          Eigen::RowVector2d(0, 0),
          regular};
}

}  // namespace nipref::fast
