#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/elastic_nip/internal/line_loads_system.hpp>
#include <nipref/fast/nip/internal/counted_kernels.hpp>
#include <nipref/fast/nip/internal/domain.hpp>
#include <nipref/fast/sheet/plain_series.hpp>

namespace nipref::fast {
namespace {

constexpr int most_elements = 10000;
constexpr double widest_half_element = 300;  // in half-thicknesses; e^(-2.106 * 300) = 1e-274

void check_in(const char* name, int value, int least, int most) {
  if (value >= least && value <= most) return;
  throw data::BadInput(name, std::to_string(value),
                       "must be from " + std::to_string(least) + " to " + std::to_string(most));
}

KernelValues from_library(Accuracy accuracy, std::span<const double> alpha, WantedKernels wanted,
                          Work& work) {
  CountedKernels kernels(accuracy, work);
  KernelValues values;
  if (wanted.I1) values.I1 = kernels.I1(alpha);
  if (wanted.I3) values.I3 = kernels.I3(alpha);
  if (wanted.I6) values.I6 = kernels.I6(alpha);
  return values;
}

KernelValues from_residues(int terms, std::span<const double> alpha, WantedKernels wanted, Work& work) {
  KernelValues values;
  const auto provide = [&](bool is_wanted, int kernel, std::vector<double>& room) {
    if (!is_wanted) return;
    room.resize(alpha.size());
    work.kernel_evaluations[static_cast<std::size_t>(kernel - 1)] += alpha.size();
    work.terms += alpha.size() * static_cast<std::uint64_t>(terms);
  };
  provide(wanted.I1, 1, values.I1);
  provide(wanted.I3, 3, values.I3);
  provide(wanted.I6, 6, values.I6);
  plain_series(alpha, terms, {values.I1, values.I3, values.I6});
  return values;
}

/// A kernel's values at odd multiples of half an element, by the multiple.
class AtOddMultiple {
 public:
  explicit AtOddMultiple(const std::vector<double>& values) : values_(values) {}
  double even(int multiple) const { return values_[static_cast<std::size_t>(std::abs(multiple) / 2)]; }
  double odd(int multiple) const { return multiple < 0 ? -even(multiple) : even(multiple); }

 private:
  const std::vector<double>& values_;
};

int elements_per_side(const std::vector<double>& kernel) { return static_cast<int>(kernel.size() / 2); }

/// pi/N times us at positive distance, sign reversed: I3 - (theta2/N) I2.
std::vector<double> normal_step(const std::vector<double>& I3, double poisson) {
  const double I2_part = (1 - 2 * poisson) / (2 * (1 - poisson)) * std::numbers::pi / 2;
  std::vector<double> step(I3);
  for (double& value : step) value -= I2_part;
  return step;
}

double largest_size(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace

void LineLoadMethod::check() const {
  check_in("elements_per_side", elements_per_side, 1, most_elements);
  check_in("residue_terms", residue_terms, 0, most_residue_terms);
}

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

KernelValues line_load_kernels(const LineLoadMethod& method, std::span<const double> alpha,
                               WantedKernels wanted, Work& work) {
  return method.residue_terms == 0 ? from_library(method.accuracy, alpha, wanted, work)
                                   : from_residues(method.residue_terms, alpha, wanted, work);
}

Eigen::MatrixXd slip_matrix(const std::vector<double>& I1) {
  const int m = elements_per_side(I1);
  const AtOddMultiple kernel(I1);
  Eigen::MatrixXd matrix(m + 1, m + 1);
  matrix.col(0).setOnes();
  for (int k = 1; k <= m; ++k) {
    for (int i = 0; i <= m; ++i) {
      matrix(i, k) = -(kernel.even(2 * (i - k) + 1) + kernel.even(2 * (i + k) - 1));
    }
  }
  return matrix;
}

Eigen::MatrixXd grip_matrix(const KernelValues& kernels, double poisson) {
  const int m = elements_per_side(kernels.I1);
  const std::vector<double> steps = normal_step(kernels.I3, poisson);
  const AtOddMultiple step(steps);
  const AtOddMultiple along(kernels.I6);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(2 * m + 1, 2 * m + 1);
  matrix.topLeftCorner(m + 1, m + 1) = slip_matrix(kernels.I1);
  for (int k = 1; k <= m; ++k) {
    for (int i = 0; i <= m; ++i) {
      const int near = 2 * (i - k) + 1;
      const int far = 2 * (i + k) - 1;
      matrix(i, m + k) = step.odd(near) - step.odd(far);
      if (i == 0) continue;
      matrix(m + i, k) = step.odd(near) + step.odd(far);
      matrix(m + i, m + k) = along.even(near) - along.even(far);
    }
  }
  return matrix;
}

Eigen::VectorXd gap_at_matching_points(const data::ElasticNip& nip, int elements_per_side,
                                       double contact_length) {
  Eigen::VectorXd gap(elements_per_side + 1);
  for (int i = 0; i <= elements_per_side; ++i) {
    gap(i) = std::pow(i * contact_length / (2 * elements_per_side), 2) / (2 * nip.roller_radius);
  }
  return gap;
}

void count_system(int unknowns, Work& work) {
  ++work.systems;
  work.unknowns = std::max(work.unknowns, unknowns);
}

LengthSearch length_search(double load, double trial_length, const LoadSearch& search) {
  check_contact_load(load);
  if (!(search.tolerance >= 1e-14 && search.tolerance <= 0.1)) {
    throw data::BadInput("tolerance", search.tolerance, "must satisfy 1e-14 <= tolerance <= 0.1");
  }
  return {
      load,
      trial_length,
      {.tolerance = search.tolerance, .fixed_exponent = search.iteration == LoadSearch::Iteration::thesis}};
}

LineLoadSolution solution_of(const data::ElasticNip& nip, int elements_per_side, double contact_length,
                             const Eigen::VectorXd& unknowns) {
  const double edge_gap = std::pow(contact_length / 2, 2) / (2 * nip.roller_radius);
  LineLoadSolution solution{contact_length, unknowns(0), unknowns(0) - edge_gap, 0, 0, {}};
  const double load_scale = std::numbers::pi / nip.material.normal_compliance();
  for (int k = 1; k < unknowns.size(); ++k) {
    auto& loads = k <= elements_per_side ? solution.line_loads : solution.shear_loads;
    loads.push_back(load_scale * unknowns(k));
  }
  for (const double line_load : solution.line_loads) solution.load += 2 * line_load;
  solution.peak_pressure =
      *std::max_element(solution.line_loads.begin(), solution.line_loads.end()) / solution.element_width();
  solution.peak_shear = largest_size(solution.shear_loads) / solution.element_width();
  return solution;
}

}  // namespace nipref::fast
