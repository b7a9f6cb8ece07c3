#include <cmath>

#include <nipref/fast/elastic_nip/internal/line_loads_system.hpp>
#include <nipref/fast/elastic_nip/line_loads_diagnostics.hpp>
#include <nipref/fast/number/internal/linear_system.hpp>

namespace nipref::fast {

double condition_number(const data::ElasticNip& nip, const LineLoadMethod& method, double contact_length,
                        data::Friction friction, Work* work) {
  const std::vector<double> distances = odd_multiples(nip, method, contact_length);
  const bool full = friction == data::Friction::full;
  Work spent;
  const KernelValues kernels =
      line_load_kernels(method, distances, {.I1 = true, .I3 = full, .I6 = full}, spent);
  const Eigen::MatrixXd matrix = full ? grip_matrix(kernels, nip.material.poisson) : slip_matrix(kernels.I1);
  if (work != nullptr) *work += spent;
  return condition_estimate(matrix);
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
