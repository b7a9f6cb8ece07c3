#include <vector>

#include <nipref/ref/half_space/internal/impedance.hpp>

namespace nipref::ref {
namespace {

using Index = Matrix::Index;

Index index(std::size_t i) { return static_cast<Index>(i); }

IntervalMatrix points(const ComplexMatrix<Float>& x, mpfr_prec_t precision) {
  return {[&](std::size_t i, std::size_t k) {
    return ComplexInterval{interval_of(x.re(index(i), index(k)), precision),
                           interval_of(x.im(index(i), index(k)), precision)};
  }};
}

template <class To, class From>
ComplexMatrix<To> cast(const ComplexMatrix<From>& x) {
  return {x.re.template cast<To>(), x.im.template cast<To>()};
}

IntervalMatrix identity(mpfr_prec_t precision) {
  return IntervalMatrix::real(
      [&](std::size_t i, std::size_t k) { return Interval(i == k ? 1L : 0L, precision); });
}

/// Voigt's index of a pair of axes.
constexpr std::size_t voigt_index[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};

/// C_ijkl/C33 in intervals.
class Moduli {
 public:
  Moduli(const ExactStiffness& solid, mpfr_prec_t precision) {
    for (const auto& row : solid.voigt) {
      for (const auto& modulus : row) {
        values_.emplace_back(Exact(mpq_class(modulus / solid.voigt[2][2])), precision);
      }
    }
  }
  [[nodiscard]] const Interval& operator()(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const {
    return values_[6 * voigt_index[i][j] + voigt_index[k][l]];
  }

 private:
  std::vector<Interval> values_;
};

/// The Lyapunov operator x g + (x g)*.
template <class Scalar>
ComplexMatrix<Scalar> lyapunov(const ComplexMatrix<Scalar>& x, const ComplexMatrix<Scalar>& g) {
  const DenseMatrix<Scalar> re = x.re * g.re - x.im * g.im;
  const DenseMatrix<Scalar> im = x.re * g.im + x.im * g.re;
  return {re + re.transpose(), im - im.transpose()};
}

/// A Hermitian matrix as nine real numbers: the real part on and above the diagonal, the imaginary part below it.
template <class Scalar>
DenseMatrix<Scalar> packed(const ComplexMatrix<Scalar>& x) {
  DenseMatrix<Scalar> result(9);
  for (Index k = 0; k < 9; ++k) {
    result(k) = k / 3 <= k % 3 ? x.re(k / 3, k % 3) : x.im(k / 3, k % 3);
  }
  return result;
}

template <class Scalar>
ComplexMatrix<Scalar> unpacked(const DenseMatrix<Scalar>& x) {
  ComplexMatrix<Scalar> result{DenseMatrix<Scalar>(3, 3), DenseMatrix<Scalar>(3, 3)};
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

/// The Lyapunov operator of g on packed matrices.
template <class Scalar>
DenseMatrix<Scalar> lyapunov_matrix(const ComplexMatrix<Scalar>& g) {
  DenseMatrix<Scalar> result(9, 9);
  for (Index k = 0; k < 9; ++k) {
    DenseMatrix<Scalar> unit(9);
    unit(k) = 1;
    result.col(k) = packed(lyapunov(unpacked(unit), g));
  }
  return result;
}

/// The matrix x with g* x + x g = I.
template <class Scalar>
ComplexMatrix<Scalar> lyapunov_solution(const ComplexMatrix<Scalar>& g) {
  const DenseMatrix<Scalar> identity = DenseMatrix<Scalar>::Identity(3, 3), zero(3, 3);
  return unpacked(solve(lyapunov_matrix(g), packed(ComplexMatrix<Scalar>{identity, zero})));
}

bool is_below(const Interval& x, long bound) { return mpfi_cmp_si(x.get(), bound) < 0; }

/// The radius 2b|F0| of the ball about M0 in the proof, with X found in Scalar; nothing if the proof fails.
template <class Scalar>
std::optional<Interval> proven_radius(const AcousticMatrices& matrices, const IntervalMatrix& impedance) {
  const mpfr_prec_t precision = impedance.precision();
  const IntervalMatrix compliance = hermitian_inverse(matrices.t);
  const IntervalMatrix right = impedance + times_i(matrices.r.adjoint());
  const IntervalMatrix generator = compliance * right;
  const auto solution = lyapunov_solution(cast<Scalar>(middle(generator)));
  const IntervalMatrix x = points(cast<Float>(solution), precision);
  const IntervalMatrix product = x * generator;
  const Interval defect = norm_bound(product + product.adjoint() - identity(precision));
  if (!is_below(defect, 1) || !is_positive_definite(x)) return std::nullopt;
  const Interval inverse_norm = (x(0, 0).re + x(1, 1).re + x(2, 2).re) / (-defect + 1);
  const Interval residual = norm_bound(right.adjoint() * generator - matrices.q);
  if (!is_below(4 * (square(inverse_norm) * norm_bound(compliance) * residual), 1)) return std::nullopt;
  return 2 * (inverse_norm * residual);
}

template <class Scalar>
std::optional<IntervalMatrix> proven(const AcousticMatrices& matrices,
                                     const std::optional<ComplexMatrix<Float>>& approximate) {
  if (!approximate) return std::nullopt;
  const IntervalMatrix centre = points(*approximate, matrices.q.precision());
  const auto radius = proven_radius<Scalar>(matrices, centre);
  if (!radius) return std::nullopt;
  return IntervalMatrix([&](std::size_t i, std::size_t k) {
    const ComplexInterval& entry = centre(i, k);
    return ComplexInterval{entry.re.widened(*radius), i == k ? entry.im : entry.im.widened(*radius)};
  });
}

/// Newton's method for F(M) = 0 from the impedance in double, whose Lyapunov operator serves for all steps. Each step
/// gains about as many digits as a double has. Nothing if a step gains less than four bits, as near the limiting speed.
std::optional<ComplexMatrix<Float>> refined(const Matrix& q, const Matrix& r, const Matrix& t, int bits) {
  const auto start =
      barnett_lothe_impedance<double>(q.cast<double>(), r.cast<double>(), t.cast<double>(), 1e-8, 30);
  if (!start) return std::nullopt;
  const Matrix compliance = t.inverse();
  ComplexMatrix<Float> m = cast<Float>(*start);
  DenseMatrix<double> inverse;
  // The last step is the first whose change is within the last 40 bits. It leaves an error at most 1/16 of this change.
  for (Float last = start->re.norm(), enough = ldexp(last, 40 - bits); last > enough;) {
    const Matrix right = m.im + r.transpose(), left = right.transpose();
    const ComplexMatrix<Float> g{compliance * m.re, compliance * right};
    const ComplexMatrix<Float> f{m.re * g.re + left * g.im - q, m.re * g.im - left * g.re};
    if (inverse.size() == 0) inverse = lyapunov_matrix(cast<double>(g)).inverse();
    const Float unit = std::max(largest_entry(f.re), largest_entry(f.im));
    if (unit == Float(0)) break;
    const auto change =
        unpacked<double>(inverse * packed(cast<double>(ComplexMatrix<Float>{f.re / unit, f.im / unit})));
    const Float size = unit * std::hypot(change.re.norm(), change.im.norm());
    if (!(size < last / 16)) return std::nullopt;
    m.re -= unit * change.re.cast<Float>();
    m.im -= unit * change.im.cast<Float>();
    last = size;
  }
  return m;
}

}  // namespace

AcousticMatrices acoustic_matrices(const ExactStiffness& solid, const SurfaceDirection& psi,
                                   const Interval& inertia) {
  const mpfr_prec_t precision = inertia.precision();
  const Moduli c(solid, precision);
  const auto [n0, n1] = psi.at(precision);
  const auto q = [&](std::size_t i, std::size_t k) {
    const Interval static_part =
        square(n0) * c(i, 0, k, 0) + square(n1) * c(i, 1, k, 1) + n0 * n1 * (c(i, 0, k, 1) + c(i, 1, k, 0));
    return i == k ? static_part - inertia : static_part;
  };
  const auto r = [&](std::size_t i, std::size_t k) { return n0 * c(i, 0, k, 2) + n1 * c(i, 1, k, 2); };
  const auto t = [&](std::size_t i, std::size_t k) { return c(i, 2, k, 2); };
  return {IntervalMatrix::real(q), IntervalMatrix::real(r), IntervalMatrix::real(t)};
}

Interval inertia_of(const ExactStiffness& solid, const Exact& speed, const Interval& cosine) {
  const mpq_class factor = solid.density * speed.value() * speed.value() / solid.voigt[2][2];
  return Interval(factor, cosine.precision()) * square(cosine);
}

std::optional<IntervalMatrix> surface_impedance(const AcousticMatrices& matrices) {
  const mpfr_prec_t precision = matrices.q.precision();
  const WorkingDigits working(digits_of(precision));
  const Matrix q = middle(matrices.q).re, r = middle(matrices.r).re, t = middle(matrices.t).re;
  if (auto found = proven<double>(matrices, refined(q, r, t, static_cast<int>(precision)))) return found;
  // Enough steps for speeds so close to the limiting speed that Im s = 2^(-precision/4).
  const int most_doublings = static_cast<int>(precision / 4) + 16;
  const Float small = ldexp(Float(1), -static_cast<int>(precision / 2));
  return proven<Float>(matrices, barnett_lothe_impedance(q, r, t, small, most_doublings));
}

}  // namespace nipref::ref
