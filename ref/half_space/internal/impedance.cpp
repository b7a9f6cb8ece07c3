#include <nipref/ref/half_space/internal/barnett_lothe.hpp>
#include <nipref/ref/half_space/internal/impedance.hpp>
#include <nipref/ref/half_space/internal/interval_float.hpp>

namespace nipref::ref {
namespace {

using Index = Matrix::Index;
using Complex = ComplexMatrix;

Index index(std::size_t i) { return static_cast<Index>(i); }

IntervalMatrix points(const Complex& x, mpfr_prec_t precision) {
  return {[&](std::size_t i, std::size_t k) {
    return ComplexInterval{interval_of(x.re(index(i), index(k)), precision),
                           interval_of(x.im(index(i), index(k)), precision)};
  }};
}

IntervalMatrix identity(mpfr_prec_t precision) {
  return IntervalMatrix::real(
      [&](std::size_t i, std::size_t k) { return Interval(i == k ? 1L : 0L, precision); });
}

/// The Lyapunov operator x g + (x g)*.
Complex lyapunov(const Complex& x, const Complex& g) {
  const Matrix re = x.re * g.re - x.im * g.im;
  const Matrix im = x.re * g.im + x.im * g.re;
  return {re + re.transpose(), im - im.transpose()};
}

/// A Hermitian matrix as nine real numbers: the real part on and above the diagonal, the imaginary part below it.
Vector packed(const Complex& x) {
  Vector result(9);
  for (Index k = 0; k < 9; ++k) {
    result(k) = k / 3 <= k % 3 ? x.re(k / 3, k % 3) : x.im(k / 3, k % 3);
  }
  return result;
}

Complex unpacked(const Vector& x) {
  Complex result{Matrix(3, 3), Matrix(3, 3)};
  for (Index i = 0; i < 3; ++i) {
    for (Index k = i; k < 3; ++k) {
      result.re(i, k) = result.re(k, i) = x(3 * i + k);
      if (k == i) continue;
      result.im(k, i) = x(3 * k + i);
      result.im(i, k) = -x(3 * k + i);
    }
  }
  return result;
}

/// The matrix x with g* x + x g = I.
Complex lyapunov_solution(const Complex& g) {
  Matrix operator_matrix(9, 9);
  for (Index k = 0; k < 9; ++k) {
    Vector unit(9);
    unit(k) = 1;
    operator_matrix.col(k) = packed(lyapunov(unpacked(unit), g));
  }
  return unpacked(solve(operator_matrix, packed({Matrix::Identity(3, 3), Matrix(3, 3)})));
}

bool is_below(const Interval& x, long bound) { return mpfi_cmp_si(x.get(), bound) < 0; }

/// The radius of the ball in the proof of impedance.hpp, or nothing if the proof fails.
std::optional<Interval> proven_radius(const AcousticMatrices& matrices, const IntervalMatrix& impedance) {
  const mpfr_prec_t precision = impedance.precision();
  const IntervalMatrix compliance = hermitian_inverse(matrices.t);
  const IntervalMatrix right = impedance + times_i(matrices.r.adjoint());
  const IntervalMatrix generator = compliance * right;
  const IntervalMatrix x = points(lyapunov_solution(middle(generator)), precision);
  const IntervalMatrix product = x * generator;
  const Interval defect = norm_bound(product + product.adjoint() - identity(precision));
  if (!is_below(defect, 1) || !is_positive_definite(x)) return std::nullopt;
  const Interval inverse_norm = (x(0, 0).real + x(1, 1).real + x(2, 2).real) / (-defect + 1);
  const Interval residual = norm_bound(right.adjoint() * generator - matrices.q);
  if (!is_below(4 * (square(inverse_norm) * norm_bound(compliance) * residual), 1)) return std::nullopt;
  return 2 * (inverse_norm * residual);
}

}  // namespace

std::optional<IntervalMatrix> surface_impedance(const AcousticMatrices& matrices) {
  const mpfr_prec_t precision = matrices.q.precision();
  const WorkingDigits working(digits_of(precision));
  // Enough for speeds so close to the limiting speed that Im s = 2^(-precision/4).
  const int most_doublings = static_cast<int>(precision / 4) + 16;
  const Float small = ldexp(Float(1), -static_cast<int>(precision / 2));
  const auto approximate = barnett_lothe_impedance(middle(matrices.q).re, middle(matrices.r).re,
                                                   middle(matrices.t).re, small, most_doublings);
  if (!approximate) return std::nullopt;
  const IntervalMatrix centre = points({approximate->re, approximate->im}, precision);
  const auto radius = proven_radius(matrices, centre);
  if (!radius) return std::nullopt;
  return IntervalMatrix([&](std::size_t i, std::size_t k) {
    const ComplexInterval& entry = centre(i, k);
    return ComplexInterval{entry.real.widened(*radius), i == k ? entry.imag : entry.imag.widened(*radius)};
  });
}

}  // namespace nipref::ref
