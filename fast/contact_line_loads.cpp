#include "fast/contact_line_loads.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include "data/bad_input.hpp"
#include "fast/sheet_kernels.hpp"

namespace nipref::fast {
namespace {

constexpr int most_elements = 10000;

void check_positive(const char* name, double value) {
  if (!(std::isfinite(value) && value > 0)) throw data::BadInput(name, value, "must be finite and > 0");
}

void check(const data::ElasticNip& nip, int elements_per_side) {
  nip.check();
  if (elements_per_side < 1 || elements_per_side > most_elements) {
    throw data::BadInput("elements_per_side", std::to_string(elements_per_side), "must be from 1 to 10000");
  }
}

/// I1((2q - 1) beta), q = 1 .. 2m: all distances between matching points and loads are odd multiples of half
/// an element.
std::vector<double> kernel_at_odd_multiples(int m, double beta, Accuracy accuracy) {
  std::vector<double> values(2 * static_cast<std::size_t>(m));
  for (std::size_t q = 0; q < values.size(); ++q) values[q] = static_cast<double>(2 * q + 1) * beta;
  I1(values, values, accuracy);
  return values;
}

/// Rows: matching points at 2 i a, i = 0 .. m. Unknowns: d0, then the loads at +-(2k - 1) a, k = 1 .. m,
/// times N/pi.
Eigen::MatrixXd matching_matrix(int m, const std::vector<double>& kernel) {
  const auto at = [&](int odd_multiple) { return kernel[static_cast<std::size_t>(odd_multiple / 2)]; };
  Eigen::MatrixXd matrix(m + 1, m + 1);
  for (int i = 0; i <= m; ++i) {
    matrix(i, 0) = 1;
    for (int k = 1; k <= m; ++k) matrix(i, k) = -(at(std::abs(2 * (i - k) + 1)) + at(2 * (i + k) - 1));
  }
  return matrix;
}

}  // namespace

LineLoadSolution line_loads_for_length(const data::ElasticNip& nip, int elements_per_side,
                                       double contact_length, Accuracy accuracy) {
  check(nip, elements_per_side);
  check_positive("contact_length", contact_length);
  const int m = elements_per_side;
  const double half_element = contact_length / (4 * m);
  const auto kernel = kernel_at_odd_multiples(m, half_element / nip.half_thickness(), accuracy);
  Eigen::VectorXd gap(m + 1);
  for (int i = 0; i <= m; ++i) gap(i) = std::pow(2 * i * half_element, 2) / (2 * nip.roller_radius);
  const Eigen::VectorXd unknowns = matching_matrix(m, kernel).partialPivLu().solve(gap);

  const double load_scale = std::numbers::pi / nip.material.normal_compliance();
  LineLoadSolution solution{contact_length, unknowns(0), unknowns(0) - gap(m), 0, 0, {}};
  for (int k = 1; k <= m; ++k) solution.line_loads.push_back(load_scale * unknowns(k));
  for (const double line_load : solution.line_loads) solution.load += 2 * line_load;
  solution.peak_pressure =
      *std::max_element(solution.line_loads.begin(), solution.line_loads.end()) / (2 * half_element);
  return solution;
}

LineLoadSolution line_loads_for_load(const data::ElasticNip& nip, int elements_per_side, double load,
                                     Accuracy accuracy) {
  check(nip, elements_per_side);
  check_positive("load", load);
  const auto excess = [&](double contact_length) {
    return line_loads_for_length(nip, elements_per_side, contact_length, accuracy).load / load - 1;
  };
  const double trial_length = nip.sheet_thickness;
  const double estimate = trial_length / std::cbrt(excess(trial_length) + 1);
  std::uintmax_t evaluations = 200;
  const auto [shorter, longer] = boost::math::tools::bracket_and_solve_root(
      excess, estimate, 1.5, true, boost::math::tools::eps_tolerance<double>(48), evaluations);
  return line_loads_for_length(nip, elements_per_side, std::midpoint(shorter, longer), accuracy);
}

double creep_ratio(const data::ElasticNip& nip, const LineLoadSolution& solution, Accuracy accuracy) {
  nip.check();
  check_positive("contact_length", solution.contact_length);
  const double end = solution.contact_length / 2 / nip.half_thickness();
  const auto m = static_cast<double>(solution.line_loads.size());
  double displacement = 0;
  for (std::size_t k = 0; k < solution.line_loads.size(); ++k) {
    const double load_position = end * (2 * static_cast<double>(k) + 1) / (2 * m);
    // The loads at +-load_position: their centre-line terms in eta are odd and cancel.
    for (const double distance : {end - load_position, end + load_position}) {
      displacement += solution.line_loads[k] * vn(distance, 0.0, nip.material, accuracy);
    }
  }
  return 2 / solution.contact_length * displacement;
}

}  // namespace nipref::fast
