
#include <nipref/data/bad_input.hpp>
#include <nipref/fast/elastic_nip/internal/line_loads_system.hpp>
#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/fast/elastic_nip/line_loads_displacements.hpp>
#include <nipref/fast/number/internal/linear_system.hpp>

namespace nipref::fast {

LineLoadSolution line_loads_for_length(const data::ElasticNip& nip, const LineLoadMethod& method,
                                       double contact_length, Work* work) {
  const std::vector<double> distances = odd_multiples(nip, method, contact_length);
  const int m = method.elements_per_side;
  Work spent;
  const KernelValues kernels = line_load_kernels(method, distances, {.I1 = true}, spent);
  const Eigen::VectorXd unknowns =
      linear_solution(slip_matrix(kernels.I1), gap_at_matching_points(nip, m, contact_length));
  count_system(m + 1, spent);
  if (work != nullptr) *work += spent;
  return solution_of(nip, m, contact_length, unknowns);
}

LineLoadSolution line_loads_for_load(const data::ElasticNip& nip, const LineLoadMethod& method, double load,
                                     const LoadSearch& search, Work* work) {
  LengthSearch lengths = length_search(load, nip.sheet_thickness, search);
  LineLoadSolution solution = solution_at_end(
      lengths, [&](double length) { return line_loads_for_length(nip, method, length, work); });
  if (!lengths.met()) throw data::BadInput("load", load, "no contact length was found that carries it");
  return solution;
}

double creep_ratio(const data::ElasticNip& nip, const LineLoadSolution& solution,
                   const LineLoadMethod& method, Work* work) {
  if (solution.gripped_creep) return *solution.gripped_creep;
  const double end = solution.contact_length / 2;
  return tangential_displacement(nip, solution, method, end, work) / end;
}

}  // namespace nipref::fast
