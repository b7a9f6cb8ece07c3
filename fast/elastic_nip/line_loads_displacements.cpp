#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/elastic_nip/internal/line_loads_system.hpp>
#include <nipref/fast/elastic_nip/line_loads_displacements.hpp>
#include <nipref/fast/sheet/kernels.hpp>

namespace nipref::fast {
namespace {

/// Distances of Y from the loads at +Y_k, then from those at -Y_k, in half-thicknesses.
std::vector<double> distances(const data::ElasticNip& nip, const LineLoadSolution& solution, double y) {
  const std::size_t m = solution.line_loads.size();
  std::vector<double> all(2 * m);
  for (std::size_t k = 0; k < m; ++k) {
    const double position = (static_cast<double>(k) + 0.5) * solution.element_width();
    all[k] = (y - position) / nip.half_thickness();
    all[m + k] = (y + position) / nip.half_thickness();
  }
  for (const double distance : all) {
    if (distance == 0) throw data::BadInput("y", y, "must not be the place of a line load");
  }
  return all;
}

/// sum over one side of load * (kernel at the near load + far_sign * kernel at its image).
double sum_of(const std::vector<double>& loads, const std::vector<double>& kernel, double far_sign) {
  double sum = 0;
  for (std::size_t k = 0; k < loads.size(); ++k) {
    sum += loads[k] * (kernel[k] + far_sign * kernel[loads.size() + k]);
  }
  return sum;
}

/// N I3 - theta2 I2: pi times vn without its part in eta, which cancels between the two sides, and minus us.
std::vector<double> normal_steps(const data::ElasticMaterial& material, const std::vector<double>& alpha,
                                 const std::vector<double>& I3) {
  std::vector<double> steps(alpha.size());
  for (std::size_t i = 0; i < alpha.size(); ++i) {
    steps[i] = material.normal_compliance() * I3[i] - material.theta2() * I2(alpha[i]);
  }
  return steps;
}

double of_element(const std::vector<double>& loads, const LineLoadSolution& solution, double y) {
  if (!std::isfinite(y)) throw data::BadInput("y", y, "must be finite");
  // A place on a border counts to the outer element, as far as rounding knows borders.
  constexpr double border = 1 + 0x1p-50;
  if (loads.empty() || std::abs(y) > solution.contact_length / 2 * border) return 0;
  const auto element = static_cast<std::size_t>(std::abs(y) / solution.element_width() * border);
  return loads[std::min(element, loads.size() - 1)] / solution.element_width();
}

double centre_of(std::ptrdiff_t element, const LineLoadSolution& solution) {
  return (static_cast<double>(element) + 0.5) * solution.element_width();
}

}  // namespace

double normal_displacement(const data::ElasticNip& nip, const LineLoadSolution& solution,
                           const LineLoadMethod& method, double y, Work* work) {
  nip.check();
  const bool friction = !solution.shear_loads.empty();
  const std::vector<double> alpha = distances(nip, solution, y);
  Work spent;
  const KernelValues kernels = line_load_kernels(method, alpha, {.I1 = true, .I3 = friction}, spent);
  double sum = nip.material.normal_compliance() * sum_of(solution.line_loads, kernels.I1, 1);
  if (friction) sum -= sum_of(solution.shear_loads, normal_steps(nip.material, alpha, kernels.I3), -1);
  if (work != nullptr) *work += spent;
  return sum * std::numbers::inv_pi;
}

double tangential_displacement(const data::ElasticNip& nip, const LineLoadSolution& solution,
                               const LineLoadMethod& method, double y, Work* work) {
  nip.check();
  const bool friction = !solution.shear_loads.empty();
  const std::vector<double> alpha = distances(nip, solution, y);
  Work spent;
  const KernelValues kernels = line_load_kernels(method, alpha, {.I3 = true, .I6 = friction}, spent);
  double sum = sum_of(solution.line_loads, normal_steps(nip.material, alpha, kernels.I3), 1);
  if (friction) sum += nip.material.normal_compliance() * sum_of(solution.shear_loads, kernels.I6, -1);
  if (work != nullptr) *work += spent;
  return sum * std::numbers::inv_pi;
}

double element_pressure(const LineLoadSolution& solution, double y) {
  return of_element(solution.line_loads, solution, y);
}

double place_of_largest_pressure(const LineLoadSolution& solution) {
  const auto& loads = solution.line_loads;
  return centre_of(std::ranges::max_element(loads) - loads.begin(), solution);
}

double place_of_largest_shear(const LineLoadSolution& solution) {
  const auto& loads = solution.shear_loads;
  const auto size = [](double load) { return std::fabs(load); };
  return centre_of(std::ranges::max_element(loads, {}, size) - loads.begin(), solution);
}

std::vector<double> shear_borders(const LineLoadSolution& solution) {
  const std::vector<double>& loads = solution.shear_loads;
  std::vector<double> borders;
  if (!loads.empty()) borders.push_back(0);
  for (std::size_t k = 1; k < loads.size(); ++k) {
    if ((loads[k - 1] < 0) != (loads[k] < 0))
      borders.push_back(static_cast<double>(k) * solution.element_width());
  }
  return borders;
}

double element_shear(const LineLoadSolution& solution, double y) {
  return std::copysign(1.0, y) * of_element(solution.shear_loads, solution, y);
}

}  // namespace nipref::fast
