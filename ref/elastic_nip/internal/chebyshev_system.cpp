#include <algorithm>
#include <utility>

#include <nipref/ref/elastic_nip/internal/chebyshev_system.hpp>
#include <nipref/ref/number/internal/float_interval.hpp>

namespace nipref::ref {
namespace {

using Index = Matrix::Index;

/// Of refinement: each gains some ten digits.
constexpr int most_rounds = 200;

/// sum += x y.
void add_product(Float& sum, Float& scratch, const Float& x, const Float& y) {
  mpfr_mul(raw(scratch), raw(x), raw(y), MPFR_RNDN);
  mpfr_add(raw(sum), raw(sum), raw(scratch), MPFR_RNDN);
}

/// The system at the nodes: with y_i = sum_m mu c_m cos(mu theta_i), (log_ij + odd_ij) y_j = n cos(theta_i),
/// log_ij = f(i - j) + f(i + j + 1), f(k) = sum_m cos(mu k pi/(2n))/mu. Symmetric and positive definite.
class NodeSystem {
 public:
  explicit NodeSystem(const ChebyshevSystem& system) : system_(system) {
    for (int k = 0; k <= 2 * system.size(); ++k) {
      Float sum = 0;
      for (int m = 0; m < system.size(); ++m) {
        sum += middle_of(system.cosines()((2L * m + 1) * 2 * k)) / (2 * m + 1);
      }
      logarithm_.push_back(sum);
    }
  }

  [[nodiscard]] Float at(int i, int j) const {
    return logarithm_[static_cast<std::size_t>(std::abs(i - j))] +
           logarithm_[static_cast<std::size_t>(i + j + 1)] + system_.odd_part(i, j);
  }

  [[nodiscard]] Vector residual(const Vector& right, const Vector& y) const {
    Vector result = right;
    Float scratch, sum;
    for (int i = 0; i < system_.size(); ++i) {
      sum = 0;
      for (int j = 0; j < system_.size(); ++j) add_product(sum, scratch, at(i, j), y(j));
      result(i) -= sum;
    }
    return result;
  }

 private:
  const ChebyshevSystem& system_;
  std::vector<Float> logarithm_;
};

Float largest_of(const Vector& x) {
  Float largest = 0;
  for (Index i = 0; i < x.size(); ++i) largest = std::max(largest, abs(x(i)));
  return largest;
}

/// Solved in double, scaled so that nothing underflows.
Vector solved_in_double(const Eigen::LLT<Eigen::MatrixXd>& factor, const Vector& right) {
  const Float scale = largest_of(right);
  Eigen::VectorXd x(right.size());
  for (Index i = 0; i < right.size(); ++i) x(i) = static_cast<double>(right(i) / scale);
  factor.solveInPlace(x);
  Vector result(right.size());
  for (Index i = 0; i < right.size(); ++i) result(i) = x(i) * scale;
  return result;
}

}  // namespace

ChebyshevSystem::ChebyshevSystem(Float half_length, int size, SmoothKernel& kernel)
    : half_length_(std::move(half_length)), size_(size), cosines_(2L * size, working_bits()) {
  std::vector<Float> places;
  for (int i = 0; i < size; ++i) places.push_back(half_length_ * middle_of(cosines_(2L * i + 1)));
  odd_part_.reserve(place(size - 1, size - 1) + 1);
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      odd_part_.push_back(ldexp(kernel(places[i] - places[j]) - kernel(places[i] + places[j]), -1));
    }
  }
  kernel_error_ = kernel.error();
}

Vector ChebyshevSystem::solution() const {
  const NodeSystem nodes(*this);
  DenseMatrix<double> in_double(size_, size_);  // its lower triangle
  Vector right(size_);
  for (int i = 0; i < size_; ++i) {
    right(i) = size_ * middle_of(cosines_(2L * i + 1));
    for (int j = 0; j <= i; ++j) in_double(i, j) = static_cast<double>(nodes.at(i, j));
  }
  const Eigen::LLT<Eigen::MatrixXd> factor(in_double);
  Vector y(size_);
  Vector rest = right;
  const Float enough = size_ * std::numeric_limits<Float>::epsilon() * largest_of(right);
  for (int round = 0; round < most_rounds && largest_of(rest) > enough; ++round) {
    const Vector change = solved_in_double(factor, rest);
    const Vector better = y + change;
    const Vector left = nodes.residual(right, better);
    if (!(largest_of(left) < largest_of(rest))) break;
    y = better;
    rest = left;
  }
  Vector coefficients(size_);
  Float scratch;
  for (int m = 0; m < size_; ++m) {
    Float sum = 0;
    for (int i = 0; i < size_; ++i) {
      add_product(sum, scratch, middle_of(cosines_((2L * m + 1) * (2L * i + 1))), y(i));
    }
    coefficients(m) = 2 * sum / (Float(size_) * (2 * m + 1));
  }
  return coefficients;
}

}  // namespace nipref::ref
