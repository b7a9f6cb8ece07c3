#include <cmath>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/elastic_nip/internal/line_loads_system.hpp>
#include <nipref/fast/nip/internal/counted_kernels.hpp>
#include <nipref/fast/number/internal/checks.hpp>
#include <nipref/fast/sheet/kernels.hpp>
#include <nipref/fast/sheet/plain_series.hpp>

namespace nipref::fast {
namespace {

constexpr int most_elements = 10000;
constexpr double widest_half_element = 300;  // in half-thicknesses; e^(-2.106 * 300) = 1e-274

/// `coupling` is I3 alone.
LineLoadKernels from_residues(int terms, std::span<const double> alpha, WantedKernels wanted, Work& work) {
  LineLoadKernels values;
  const auto provided = [&](bool is_wanted, std::size_t kernel,
                            Eigen::RowVectorXd& room) -> std::span<double> {
    if (!is_wanted) return {};
    room.resize(static_cast<Eigen::Index>(alpha.size()));
    work.kernel_evaluations[kernel - 1] += alpha.size();
    work.terms += alpha.size() * static_cast<std::uint64_t>(terms);
    return {room.data(), alpha.size()};
  };
  plain_series(alpha, terms,
               {provided(wanted.I1, 1, values.I1), provided(wanted.coupling, 3, values.coupling),
                provided(wanted.I6, 6, values.I6)});
  return values;
}

/// Distances a, 3a .. (4m - 1) a in half-thicknesses.
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

/// A kernel's value at an odd multiple of half an element.
double even(const Eigen::RowVectorXd& kernel, int multiple) { return kernel[std::abs(multiple) / 2]; }
double odd(const Eigen::RowVectorXd& kernel, int multiple) {
  return multiple < 0 ? -even(kernel, multiple) : even(kernel, multiple);
}

}  // namespace

void LineLoadMethod::check() const {
  internal::check_range("elements_per_side", elements_per_side, 1, most_elements);
  internal::check_range("residue_terms", residue_terms, 0, most_residue_terms);
}

LineLoadKernels line_load_kernels(const data::ElasticMaterial& material, const LineLoadMethod& method,
                                  std::span<const double> alpha, WantedKernels wanted, Work& work) {
  LineLoadKernels kernels;
  if (method.residue_terms == 0) {
    CountedKernels of_library(method.accuracy, work);
    if (wanted.I1) kernels.I1 = of_library.I1(alpha);
    if (wanted.coupling) kernels.coupling = of_library.I3(alpha);
    if (wanted.I6) kernels.I6 = of_library.I6(alpha);
  } else {
    kernels = from_residues(method.residue_terms, alpha, wanted, work);
  }
  const double part = material.theta2() / material.normal_compliance();
  for (Eigen::Index i = 0; i < kernels.coupling.size(); ++i)
    kernels.coupling[i] -= part * I2(alpha[static_cast<std::size_t>(i)]);
  return kernels;
}

Eigen::MatrixXd matching_matrix(const data::ElasticNip& nip, const LineLoadMethod& method,
                                double contact_length, bool grips, Work& work) {
  const LineLoadKernels kernels =
      line_load_kernels(nip.material, method, odd_multiples(nip, method, contact_length),
                        {.I1 = true, .coupling = grips, .I6 = grips}, work);
  const int m = method.elements_per_side, unknowns = (grips ? 2 : 1) * m + 1;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(unknowns, unknowns);
  matrix.col(0).head(m + 1).setOnes();
  for (int k = 1; k <= m; ++k) {
    for (int i = 0; i <= m; ++i) {
      const int near = 2 * (i - k) + 1, far = 2 * (i + k) - 1;
      matrix(i, k) = -(even(kernels.I1, near) + even(kernels.I1, far));
      if (!grips) continue;
      matrix(i, m + k) = odd(kernels.coupling, near) - odd(kernels.coupling, far);
      if (i == 0) continue;
      matrix(m + i, k) = odd(kernels.coupling, near) + odd(kernels.coupling, far);
      matrix(m + i, m + k) = even(kernels.I6, near) - even(kernels.I6, far);
    }
  }
  return matrix;
}

}  // namespace nipref::fast
