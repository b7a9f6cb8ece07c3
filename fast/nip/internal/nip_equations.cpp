#include <algorithm>
#include <utility>

#include <nipref/fast/nip/internal/nip_equations.hpp>

namespace nipref::fast {

ContactPlace ContactPlace::in(const Solution& solution) const {
  if (e <= solution.half_length()) return *this;
  return {!trailing, std::max(0.0, 2 * solution.half_length() - e)};
}

Functional NipEquations::traction(const Solution& solution, Component component,
                                  const ContactPlace& place) const {
  if (!(place.e > 0)) return solution.of_tractions(Eigen::RowVectorXd::Zero(solution.tractions().columns()));
  const auto [trailing, e] = place.in(solution);
  Eigen::MatrixXd both = solution.tractions().values(e);
  if (trailing) both.row(1) *= -1;
  if (!grips()) return solution.of_tractions(both.colwise().sum());
  return solution.of_tractions(both.row(component == Component::pressure ? 0 : 1));
}

Functional NipEquations::eccentricity(const Solution& solution) const {
  return solution.of_tractions(Eigen::RowVectorXd::Zero(solution.tractions().columns()));
}

}  // namespace nipref::fast
