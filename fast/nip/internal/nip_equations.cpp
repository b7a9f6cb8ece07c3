#include <algorithm>
#include <numbers>

#include <nipref/fast/nip/internal/nip_equations.hpp>

namespace nipref::fast {

ContactPlace ContactPlace::in(const Solution& solution) const {
  if (e <= solution.half_length()) return *this;
  return {!trailing, std::max(0.0, 2 * solution.half_length() - e)};
}

Functional NipEquations::traction(const Solution& solution, TractionComponent component,
                                  const ContactPlace& place) const {
  if (!(place.e > 0)) return solution.of_tractions(Eigen::RowVectorXd::Zero(solution.tractions().columns()));
  const auto [trailing, e] = place.in(solution);
  Eigen::MatrixXd both = solution.tractions().values(e);
  if (trailing) both.row(1) *= -1;
  if (!grips()) return solution.of_tractions(both.colwise().sum());
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

Tractions::SplitKernel frictionless_kernel(CountedKernels& kernels) {
  using Alphas = CountedKernels::Alphas;
  const auto whole = [&kernels](Alphas alpha, Eigen::MatrixXd& on_p, Eigen::MatrixXd& on_q) {
    on_q = on_p = kernels.I1(alpha) / std::numbers::pi;
  };
  const auto regular = [&kernels](Alphas alpha, Eigen::MatrixXd& on_p, Eigen::MatrixXd& on_q) {
    on_q = on_p = kernels.regular_I1(alpha) / std::numbers::pi;
  };
  return {{1, Tractions::Kernel::FarAway::negligible, {}, whole},
          Eigen::RowVector2d(1, 1),
          Eigen::RowVector2d(0, 0),
          regular};
}

}  // namespace nipref::fast
