#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <nipref/ref/elastic_nip/internal/grip_expansion.hpp>
#include <nipref/ref/number/internal/cosines.hpp>
#include <nipref/ref/number/internal/float_interval.hpp>
#include <nipref/ref/number/internal/refined_solution.hpp>

namespace nipref::ref {
namespace {

using Index = Matrix::Index;

std::atomic<long> expansions_solved = 0;

/// i^k = sign_of_power(k) times 1 or i.
int sign_of_power(long k) { return k % 4 < 2 ? 1 : -1; }
int alternating(long k) { return k % 2 == 0 ? 1 : -1; }

void accumulate(Float& sum, Float& scratch, const Float& x, const Float& y) {
  mpfr_mul(raw(scratch), raw(x), raw(y), MPFR_RNDN);
  mpfr_add(raw(sum), raw(sum), raw(scratch), MPFR_RNDN);
}

/// Half of the zeros of T_count or U_count, count even: those > 0, from the end.
class HalfGrid {
 public:
  HalfGrid(int count, bool first_kind)
      : count_(count / 2), first_kind_(first_kind), period_(4L * (first_kind ? count : count + 1)) {
    const Cosines cosines(period_ / 4, working_bits());
    for (long k = 0; k < period_; ++k) cosines_.push_back(middle_of(cosines(k)));
  }
  [[nodiscard]] int size() const { return count_; }
  /// T_n at the i-th.
  [[nodiscard]] const Float& chebyshev(long n, int i) const {
    const long angle = first_kind_ ? 2L * i + 1 : 2L * (i + 1);
    return cosines_[static_cast<std::size_t>(n * angle % period_)];
  }
  [[nodiscard]] const Float& point(int i) const { return chebyshev(1, i); }

 private:
  int count_;
  bool first_kind_;
  long period_;
  std::vector<Float> cosines_;
};

/// Displacements at the matching points in terms of tractions at the nodes > 0, their mirror images included.
struct FoldedKernels {
  Matrix normal_by_pressure, normal_by_shear, tangential_by_pressure, tangential_by_shear;

  FoldedKernels(const Float& half_length, const HalfGrid& points, const HalfGrid& nodes, GripKernels& kernels)
      : normal_by_pressure(points.size(), nodes.size()),
        normal_by_shear(points.size(), nodes.size()),
        tangential_by_pressure(points.size(), nodes.size()),
        tangential_by_shear(points.size(), nodes.size()) {
    const Float scale = 2 * log(half_length);
    for (int i = 0; i < points.size(); ++i) {
      for (int j = 0; j < nodes.size(); ++j) {
        const Float near = half_length * (points.point(i) - nodes.point(j));
        const Float far = half_length * (points.point(i) + nodes.point(j));
        const Float normal_near = kernels.normal(near), normal_far = kernels.normal(far);
        const Float odd_near = kernels.odd_coupling(near), odd_far = kernels.odd_coupling(far);
        normal_by_pressure(i, j) = (normal_near + normal_far - scale) / pi();
        normal_by_shear(i, j) = (odd_far - odd_near) / pi();
        tangential_by_pressure(i, j) = (odd_near + odd_far) / pi();
        tangential_by_shear(i, j) =
            (normal_near + kernels.stretch(near) - normal_far - kernels.stretch(far)) / pi();
      }
    }
  }
};

/// Displacements at the matching points over A, up to the constant of the normal ones, in terms of r_k.
template <class Scalar>
struct GripOperator {
  using M = DenseMatrix<Scalar>;
  M closed;             ///< to coefficients of i^n T_n in the closed part
  M moments;            ///< to i^{-m} int T_m f
  M pressures, shears;  ///< from these to what stands at the nodes for int p and int q
  M even, odd;          ///< from coefficients of i^n T_n to values at the matching points
  M normal_by_pressure, normal_by_shear, tangential_by_pressure, tangential_by_shear;

  /// Of a solution's moments and coefficients; the operators themselves where these are for all r_k.
  [[nodiscard]] M normal(const M& coefficients, const M& f) const {
    return even * coefficients + normal_by_pressure * (pressures * f) + normal_by_shear * (shears * f);
  }
  [[nodiscard]] M tangential(const M& coefficients, const M& f) const {
    return odd * coefficients + tangential_by_pressure * (pressures * f) + tangential_by_shear * (shears * f);
  }
};

Matrix closed_parts(int terms, const Float& epsilon, const EndMoments& moments) {
  Matrix result(terms + 2, terms);
  const Float share = 1 / cosh(pi() * epsilon);
  for (long n = 1; n < terms + 2; ++n) {
    for (long k = std::max(0L, n - 2); k < terms; ++k) {
      Float sum = k < n ? Float(0) : alternating(n + k) * 2 * moments.plain(k - n) / pi();
      if (k == n) sum -= share / 2;
      if (k == n - 1) sum -= 2 * epsilon * share;
      if (k == n - 2) sum += share / 2;
      result(n, k) = sum / n;
    }
  }
  return result;
}

Matrix chebyshev_moments(int terms, int count, const EndMoments& moments) {
  Matrix result(count, terms);
  for (long m = 0; m < count; ++m) {
    for (long k = 0; k < terms; ++k) {
      result(m, k) =
          ldexp(alternating(k) * (moments.plain(k + m) + alternating(m) * moments.plain(k - m)), -1);
    }
  }
  return result;
}

/// i^n T_n at the points, real or imaginary; times `factor`.
Matrix values_at(const HalfGrid& points, int count, int parity, const Float& factor) {
  Matrix result(points.size(), count);
  for (int i = 0; i < points.size(); ++i) {
    for (long n = parity; n < count; n += 2) {
      result(i, n) = sign_of_power(n) * factor * points.chebyshev(n, i) / (n == 0 ? 2 : 1);
    }
  }
  return result;
}

GripOperator<Float> operator_of(const Float& half_length, const Float& epsilon, const GripLayout& layout,
                                const EndMoments& moments, const HalfGrid& points, GripKernels& kernels) {
  const HalfGrid nodes(layout.nodes, true);
  FoldedKernels folded(half_length, points, nodes, kernels);
  const Float weight = Float(2) / layout.nodes;
  return {.closed = closed_parts(layout.terms, epsilon, moments),
          .moments = chebyshev_moments(layout.terms, layout.nodes, moments),
          .pressures = values_at(nodes, layout.nodes, 0, weight),
          .shears = values_at(nodes, layout.nodes, 1, weight),
          .even = values_at(points, layout.terms + 2, 0, 1),
          .odd = values_at(points, layout.terms + 2, 1, 1),
          .normal_by_pressure = std::move(folded.normal_by_pressure),
          .normal_by_shear = std::move(folded.normal_by_shear),
          .tangential_by_pressure = std::move(folded.tangential_by_pressure),
          .tangential_by_shear = std::move(folded.tangential_by_shear)};
}

GripOperator<double> in_double(const GripOperator<Float>& from) {
  return {from.closed.cast<double>(),
          from.moments.cast<double>(),
          from.pressures.cast<double>(),
          from.shears.cast<double>(),
          from.even.cast<double>(),
          from.odd.cast<double>(),
          from.normal_by_pressure.cast<double>(),
          from.normal_by_shear.cast<double>(),
          from.tangential_by_pressure.cast<double>(),
          from.tangential_by_shear.cast<double>()};
}

// Unknowns: r_k, minus the constant of the normal displacement over A, minus the creep. Rows: normal
// displacements at the matching points, tangential ones.

DenseMatrix<double> system_matrix(const GripOperator<double>& to, const Vector& points) {
  const Index terms = to.closed.cols(), half = points.size();
  DenseMatrix<double> result(2 * half, 2 * half);
  result.topLeftCorner(half, terms) = to.normal(to.closed, to.moments);
  result.bottomLeftCorner(half, terms) = to.tangential(to.closed, to.moments);
  for (Index i = 0; i < half; ++i) {
    result(i, terms) = 1;
    result(half + i, terms + 1) = static_cast<double>(points(i));
  }
  return result;
}

Vector applied(const GripOperator<Float>& to, const Vector& points, const Vector& x) {
  const Index terms = to.closed.cols(), half = points.size();
  const Vector r = x.topRows(terms);
  const Vector coefficients = to.closed * r, f = to.moments * r;
  Vector result(2 * half);
  result.topRows(half) = to.normal(coefficients, f);
  result.bottomRows(half) = to.tangential(coefficients, f);
  for (Index i = 0; i < half; ++i) {
    result(i) += x(terms);
    result(half + i) += points(i) * x(terms + 1);
  }
  return result;
}

}  // namespace

long GripExpansion::solved() { return expansions_solved; }

GripExpansion::GripExpansion(Float half_length, Float beta, const GripLayout& layout, GripKernels& kernels)
    : half_length_(std::move(half_length)), beta_(std::move(beta)), epsilon_(atanh(beta_) / pi()) {
  const EndMoments moments(epsilon_, layout.terms + layout.nodes + 2);
  const HalfGrid grid(layout.terms + 2, layout.at_zeros);
  const GripOperator<Float> to = operator_of(half_length_, epsilon_, layout, moments, grid, kernels);
  Vector points(grid.size()), right(2L * grid.size());
  for (int i = 0; i < grid.size(); ++i) {
    points(i) = grid.point(i);
    right(i) = half_length_ * (1 - points(i)) * (1 + points(i));
  }
  const std::optional<Vector> solved = refined_solution(
      system_matrix(in_double(to), points), right, [&](const Vector& x) { return applied(to, points, x); });
  if (!solved) throw std::logic_error("a linear system that refinement does not solve");
  ++expansions_solved;
  const Vector& x = *solved;
  coefficients_ = x.topRows(layout.terms);
  creep_ = -x(layout.terms + 1);
  load_ = half_length_ * (to.moments.topLeftCorner(1, layout.terms) * coefficients_)(0);
  // At t = 1 the closed part is -int ln(1 - t) f/pi, of which the sum over T_n has all but the constant.
  Float constant = 0;
  for (long k = 0; k < layout.terms; ++k) {
    constant -= alternating(k) * moments.logarithmic(k) * coefficients_(k) / pi();
  }
  const Vector closed = to.closed * coefficients_;
  for (long n = 2; n < closed.size(); n += 2) constant -= sign_of_power(n) * closed(n);
  edge_displacement_ = half_length_ * (constant - x(layout.terms));
}

Float GripExpansion::growth() const {
  Float re = 0, im = 0;
  for (long k = 0; k < terms(); ++k) {
    (k % 2 == 0 ? re : im) += sign_of_power(k) * (k + 1) * coefficients_(k);
  }
  const Float cosine = cosh(pi() * epsilon_);
  return pi() / 2 * (re * re + im * im) * (1 + 4 * epsilon_ * epsilon_) / (load_ * cosine * cosine);
}

GripTraction GripExpansion::traction(const Float& before_end) const {
  if (!(before_end > 0)) return {0, 0};
  const Float beyond = 2 - before_end, twofold = 2 * (1 - before_end);
  // Clenshaw's sums of the even and of the odd terms.
  GripTraction now{0, 0}, last{0, 0};
  Float scratch;
  for (long k = terms() - 1; k >= 0; --k) {
    for (Float GripTraction::*part : {&GripTraction::pressure, &GripTraction::shear}) {
      Float& next = last.*part;
      mpfr_neg(raw(next), raw(next), MPFR_RNDN);
      accumulate(next, scratch, twofold, now.*part);
    }
    std::swap(now, last);
    (k % 2 == 0 ? now.pressure : now.shear) += sign_of_power(k) * coefficients_(k);
  }
  const Float size = sqrt(before_end * beyond);
  const Float phase = epsilon_ * log(beyond / before_end);
  const Float c = cos(phase), s = sin(phase);
  return {size * (c * now.pressure - s * now.shear), size * (s * now.pressure + c * now.shear)};
}

namespace {

/// Displacements over A by tractions at both places +-t, and the tractions' distances from `place`.
class OutsideIntegrand {
 public:
  OutsideIntegrand(const GripExpansion& contact, const Float& beta, const Float& beyond_end,
                   GripKernels& kernels)
      : contact_(contact), sign_part_(beta * pi() / 2), beyond_end_(beyond_end), kernels_(kernels) {}

  void add(const Float& before_end, const Float& weight, GripDisplacement& sum) {
    const GripTraction here = contact_.traction(before_end);
    const Float near = contact_.half_length() * (beyond_end_ + before_end);
    const Float far = contact_.half_length() * (beyond_end_ + 2 - before_end);
    const Float stretch = kernels_.stretch(near) - kernels_.stretch(far);
    const Float normal_near = kernels_.normal(near) - log(near), normal_far = kernels_.normal(far) - log(far);
    const Float odd_near = sign_part_ - kernels_.coupling(near),
                odd_far = sign_part_ - kernels_.coupling(far);
    const Float factor = weight / pi();
    sum.normal += factor * ((normal_near + normal_far) * here.pressure + (odd_near - odd_far) * here.shear);
    sum.tangential +=
        factor * ((normal_near - normal_far + stretch) * here.shear - (odd_near + odd_far) * here.pressure);
    sum.strain += factor * ((slope_by_shear(near) - slope_by_shear(far)) * here.shear +
                            (kernels_.coupling.slope(near) + kernels_.coupling.slope(far)) * here.pressure);
  }

 private:
  /// Of I6 from a shear alpha behind.
  Float slope_by_shear(const Float& alpha) {
    return kernels_.normal.slope(alpha) - 1 / alpha - kernels_.coupling(alpha);
  }

  const GripExpansion& contact_;
  Float sign_part_, beyond_end_;
  GripKernels& kernels_;
};

}  // namespace

/// Over 0 < t < 1 by t = tanh((pi/2) sinh x): the step is halved until that no longer changes anything. Nodes go on so
/// far towards the end that what lies beyond is too little even next to it, where the logarithm is steepest.
GripOutside GripExpansion::displacement_outside(const Float& before_end, const Float& enough,
                                                GripKernels& kernels) const {
  OutsideIntegrand integrand(*this, beta_, -before_end, kernels);
  const Float nearest = enough * std::min(Float(1), Float(-before_end));
  const auto add_node = [&](const Float& x, GripDisplacement& sum) {
    const Float growth = exp(pi() * sinh(x));
    const Float node = 2 / (1 + growth);  // 1 - t
    if (node < nearest) return false;
    integrand.add(node, pi() * cosh(x) * growth * node * node / 2, sum);
    return true;
  };
  GripDisplacement sum{0, 0, 0};
  add_node(0, sum);
  sum = {sum.normal / 2, sum.tangential / 2, sum.strain / 2};
  Float step = 1;
  GripOutside now{{0, 0, 0}, {0, 0, 0}};
  for (int level = 0; level < 14; ++level) {
    const long stride = level == 0 ? 1 : 2;
    for (long i = 1; add_node(i * step, sum); i += stride) {
    }
    const Float size = half_length_ * step;
    const auto renew = [&](Float GripDisplacement::*part) {
      const Float value = size * sum.*part;
      now.error.*part = abs(value - now.value.*part);
      now.value.*part = value;
    };
    renew(&GripDisplacement::normal), renew(&GripDisplacement::tangential), renew(&GripDisplacement::strain);
    const Float change = std::max({now.error.normal, now.error.tangential, now.error.strain * half_length_});
    if (level > 3 && change <= enough * half_length_ * half_length_) break;
    step = ldexp(step, -1);
  }
  return now;
}

}  // namespace nipref::ref
