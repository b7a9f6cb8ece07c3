#include "fast/contact_spectral.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <vector>

namespace nipref::fast {
namespace {

constexpr double pi = std::numbers::pi;

/// Positions are cos(i step), step = pi/(4 (terms + 1)): matching points at odd i, quadrature nodes at even
/// i, so that the two never meet.
struct Grid {
  explicit Grid(int count) : terms(count), step(pi / (4 * (count + 1))) {}
  int terms;
  double step;
  [[nodiscard]] double matching_angle(int i) const { return (2 * i + 1) * step; }  // i = 0 .. terms
  [[nodiscard]] double node_angle(int j) const {
    return 2 * (j + 1) * step;
  }  // j = 0 .. terms, the last at t = 0
  /// Gauss-Chebyshev weight of node j and its mirror image together, times sqrt(1 - t^2) U_2k = sin((2k + 1)
  /// angle).
  [[nodiscard]] double node_weight(int j) const {
    return (j == terms ? 1 : 2) * 2 * step * std::sin(node_angle(j));
  }
};

/// cos(first) - cos(second), also where the two are close.
double cosine_difference(double first, double second) {
  return -2 * std::sin((first + second) / 2) * std::sin((first - second) / 2);
}

/// Mean over node j and its mirror image of I1(A (t - s)) + ln(A |t - s|), the part of the kernel that is
/// analytic.
Eigen::MatrixXd smooth_kernel(const Grid& grid, double half_length, ContactKernels& kernels) {
  const int size = grid.terms + 1;
  std::vector<double> alpha;
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) {
      const double near = cosine_difference(grid.node_angle(j), grid.matching_angle(i));
      const double far = cosine_difference(pi - grid.node_angle(j), grid.matching_angle(i));
      alpha.push_back(half_length * std::fabs(near));
      alpha.push_back(half_length * std::fabs(far));
    }
  }
  const std::vector<double> values = kernels.I1(alpha);
  Eigen::MatrixXd smooth(size, size);
  std::size_t next = 0;
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j, next += 2) {
      smooth(i, j) =
          0.5 * (values[next] + std::log(alpha[next]) + values[next + 1] + std::log(alpha[next + 1]));
    }
  }
  return smooth;
}

/// int -ln|t - s| sqrt(1 - s^2) U_n(s) ds at t = cos(angle), n even, without its constant for n = 0.
double logarithm_of(int n, double angle) {
  const double upper = std::cos((n + 2) * angle) / (n + 2);
  return pi / 2 * ((n == 0 ? std::numbers::ln2 : std::cos(n * angle) / n) - upper);
}

class SpectralContact : public HalfContact {
 public:
  SpectralContact(double length, int terms, ContactKernels& kernels) {
    half_length = length;
    breaks = {0, length};
    solve(Grid(terms), kernels);
  }

  [[nodiscard]] Traction traction(double e) const override {
    const double angle = 2 * std::asin(std::sqrt(e / (2 * half_length)));
    double sum = 0;
    for (Eigen::Index k = 0; k < coefficients_.size(); ++k) {
      sum += coefficients_(k) * std::sin(static_cast<double>(2 * k + 1) * angle);
    }
    return {sum, 0};
  }

 private:
  void solve(const Grid& grid, ContactKernels& kernels) {
    const int terms = grid.terms;
    Eigen::MatrixXd nodes(terms + 1, terms);
    for (int j = 0; j <= terms; ++j) {
      for (int k = 0; k < terms; ++k) {
        nodes(j, k) = grid.node_weight(j) * std::sin((2 * k + 1) * grid.node_angle(j));
      }
    }
    Eigen::MatrixXd matrix(terms + 1, terms + 1);
    matrix.leftCols(terms) = half_length / pi * (smooth_kernel(grid, half_length, kernels) * nodes);
    Eigen::VectorXd gap(terms + 1);
    for (int i = 0; i <= terms; ++i) {
      const double angle = grid.matching_angle(i);
      for (int k = 0; k < terms; ++k) matrix(i, k) += half_length / pi * logarithm_of(2 * k, angle);
      matrix(i, 0) -= half_length / 2 * std::log(half_length);
      matrix(i, terms) = -1;
      gap(i) = std::pow(half_length * std::sin(angle), 2);  // A^2 - y^2
    }
    const Eigen::VectorXd unknowns = matrix.partialPivLu().solve(gap);
    kernels.count_system(terms + 1);
    coefficients_ = unknowns.head(terms);
    edge_displacement = unknowns(terms);
    load = half_length * pi / 2 * coefficients_(0);
  }

  Eigen::VectorXd coefficients_;
};

}  // namespace

std::unique_ptr<HalfContact> spectral_contact(double half_length, int terms, ContactKernels& kernels) {
  return std::make_unique<SpectralContact>(half_length, terms, kernels);
}

}  // namespace nipref::fast
