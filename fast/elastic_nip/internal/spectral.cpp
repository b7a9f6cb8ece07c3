#include <cmath>
#include <cstdlib>
#include <numbers>
#include <vector>

#include <nipref/fast/elastic_nip/internal/spectral.hpp>
#include <nipref/fast/nip/internal/expansion_tail.hpp>
#include <nipref/fast/number/internal/linear_system.hpp>

namespace nipref::fast {
namespace {

constexpr double pi = std::numbers::pi;

/// Positions are cos(angle), with matching points at odd multiples of step = pi/(4 (terms + 1)) and quadrature nodes at
/// even ones, so that the two never coincide. Angles are counted in half steps, and all sines come from one table.
class Grid {
 public:
  explicit Grid(int count) : terms(count), half_turn_(8 * (count + 1)) {
    for (int i = 0; i < 2 * half_turn_; ++i) sines_.push_back(std::sin(pi * i / half_turn_));
  }
  const int terms;

  // Angles in half steps.
  [[nodiscard]] static int matching_angle(int i) { return 2 * (2 * i + 1); }  // i = 0 .. terms
  [[nodiscard]] static int node_angle(int j) { return 4 * (j + 1); }  // j = 0 .. terms, the last at t = 0
  [[nodiscard]] int mirrored(int angle) const { return half_turn_ - angle; }

  [[nodiscard]] double sine(int angle) const {
    const int turn = 2 * half_turn_;
    return sines_[static_cast<std::size_t>((angle % turn + turn) % turn)];
  }
  [[nodiscard]] double cosine(int angle) const { return sine(angle + half_turn_ / 2); }
  /// |cos(first) - cos(second)|, also where the two are close; even angles from 0 to half a turn.
  [[nodiscard]] double cosine_distance(int first, int second) const {
    return std::fabs(2 * sines_[static_cast<std::size_t>((first + second) / 2)] *
                     sines_[static_cast<std::size_t>(std::abs(first - second) / 2)]);
  }
  /// Gauss-Chebyshev weight of node j, together with its mirror image, times sqrt(1 - t^2).
  [[nodiscard]] double node_weight(int j) const {
    return (j == terms ? 1 : 2) * 4 * pi / half_turn_ * sine(node_angle(j));
  }

 private:
  int half_turn_;
  std::vector<double> sines_;
};

/// Mean over node j and its mirror image of I1(A (t - s)) + ln|t - s|, the part of the kernel that is analytic.
Eigen::MatrixXd smooth_kernel(const Grid& grid, double half_length, CountedKernels& kernels) {
  const int size = grid.terms + 1;
  std::vector<double> distance;
  for (int i = 0; i < size; ++i) {
    const int at = Grid::matching_angle(i);
    for (int j = 0; j < size; ++j) {
      const int node = Grid::node_angle(j);
      distance.push_back(grid.cosine_distance(node, at));
      distance.push_back(grid.cosine_distance(grid.mirrored(node), at));
    }
  }
  std::vector<double> alpha;
  for (const double d : distance) alpha.push_back(half_length * d);
  const std::vector<double> values = kernels.I1(alpha);
  Eigen::MatrixXd smooth(size, size);
  std::size_t next = 0;
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j, next += 2) {
      smooth(i, j) = 0.5 * (values[next] + values[next + 1] + std::log(distance[next] * distance[next + 1]));
    }
  }
  return smooth;
}

/// int -ln|t - s| sqrt(1 - s^2) U_n(s) ds at t = cos(angle), n even.
double logarithm_of(int n, int angle, const Grid& grid) {
  const double lower = n == 0 ? std::numbers::ln2 : grid.cosine(n * angle) / n;
  return pi / 2 * (lower - grid.cosine((n + 2) * angle) / (n + 2));
}

class SpectralContact : public HalfContact {
 public:
  /// `unknowns`: the coefficients, then the edge displacement.
  SpectralContact(double length, const Eigen::VectorXd& unknowns)
      : coefficients_(unknowns.head(unknowns.size() - 1)) {
    half_length = length;
    breaks = {0, length};
    edge_displacement = unknowns(unknowns.size() - 1);
    load = half_length * pi / 2 * coefficients_(0);
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
  Eigen::VectorXd coefficients_;
};

SolutionAndTwins solve(double half_length, const Grid& grid, CountedKernels& kernels) {
  const int terms = grid.terms;
  Eigen::MatrixXd nodes(terms + 1, terms);
  for (int j = 0; j <= terms; ++j) {
    for (int k = 0; k < terms; ++k) {
      nodes(j, k) = grid.node_weight(j) * grid.sine((2 * k + 1) * Grid::node_angle(j));
    }
  }
  Eigen::MatrixXd matrix(terms + 1, terms + 1);
  matrix.leftCols(terms) = scaled_product(half_length / pi, smooth_kernel(grid, half_length, kernels), nodes);
  Eigen::MatrixXd size = matrix.cwiseAbs();
  size.col(terms).setOnes();
  Eigen::VectorXd gap(terms + 1);
  for (int i = 0; i <= terms; ++i) {
    const int angle = Grid::matching_angle(i);
    for (int k = 0; k < terms; ++k) {
      const double logarithm = half_length / pi * logarithm_of(2 * k, angle, grid);
      matrix(i, k) += logarithm;
      size(i, k) += std::fabs(logarithm);
    }
    matrix(i, terms) = -1;
    gap(i) = std::pow(half_length * grid.sine(angle), 2);  // A^2 - y^2
  }
  kernels.count_system(terms + 1);
  // Rounding to nearest changes an entry by half a unit at most; the other roundings of its sum average out (measured).
  return solution_and_twins(matrix, 0.5 * size, gap);
}

}  // namespace

std::unique_ptr<HalfContact> spectral_contact(double half_length, int terms, CountedKernels& kernels) {
  const SolutionAndTwins found = solve(half_length, Grid(terms), kernels);
  auto contact = std::make_unique<SpectralContact>(half_length, found.solution);
  contact->tail = expansion_tails(found, terms, 1).front();
  for (const auto& twin : found.twins.colwise())
    contact->twins.push_back(std::make_unique<SpectralContact>(half_length, twin));
  return contact;
}

}  // namespace nipref::fast
