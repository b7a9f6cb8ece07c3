#pragma once
#include <vector>

#include <nipref/ref/number/internal/cosines.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>
#include <nipref/ref/number/interval.hpp>
#include <nipref/ref/sheet/internal/smooth_kernel.hpp>

namespace nipref::ref {

/// The pressure 2A sum c_m sin(m theta) that is 0 at both ends and makes the slope of an elastic contact a given function of
/// t = cos(theta) but for a constant:
///
///     (1/pi) int_{-1}^{1} I1(A (t - s)) q(s) ds = constant - sum f_m T_m(t),    q = p'/(2A),   all m >= 1,
///     c_m + (1/2) sum_n g_mn n c_n = f_m,    J(A(t - s)) = sum g_mn T_m(t) T_n(s).
///
/// Proven as ProvenExpansion is: ref/viscoelastic_nip/README.md, Rolling contacts.
struct BoundedColumn {
  std::vector<Float> coefficients;  ///< c_0 = 0, c_1 .. c_{N-1}
  Interval energy_radius;           ///< sqrt(sum m dc_m^2) <= this
  Interval radius;                  ///< sum m |dc_m| <= this, all m
  Interval constant;
};

/// A right-hand side f_0 .. f_{N-1}; and a bound of f_N that each further one is at most half of the one before.
struct SlopeSeries {
  std::vector<Interval> coefficients;
  Interval next;
};

/// Elastic contacts of one half length A, exact to the working precision or an interval about it, at N Chebyshev points.
class BoundedColumns {
 public:
  BoundedColumns(const Interval& half_length, int points, SmoothKernel& kernel);

  [[nodiscard]] std::vector<BoundedColumn> solved(const std::vector<SlopeSeries>& right) const;
  [[nodiscard]] int points() const { return points_; }
  [[nodiscard]] const Interval& half_length() const { return half_length_; }
  /// cos(k pi/(2N)); theta_i is k = 2i + 1.
  [[nodiscard]] const Cosines& cosines() const { return cosines_; }

 private:
  [[nodiscard]] const Float& value(int i, int j) const {
    return values_[static_cast<std::size_t>(i * points_ + j)];
  }
  template <class Number>
  [[nodiscard]] std::vector<Number> operator_on(const std::vector<Number>& at_nodes) const;
  template <class Number>
  [[nodiscard]] std::vector<Number> at_nodes(const std::vector<Number>& x) const;
  template <class Number>
  [[nodiscard]] std::vector<Number> coefficients_of(const std::vector<Number>& z) const;
  template <class Number>
  [[nodiscard]] const Number& cosine(long k) const;
  [[nodiscard]] BoundedColumn proven(const std::vector<Float>& coefficients, const SlopeSeries& right) const;

  Interval half_length_;
  int points_;
  Cosines cosines_;
  std::vector<Float> middles_;  ///< of the cosines
  std::vector<Float> values_;   ///< J(A (t_i - t_j))
  Float entry_error_;
};

}  // namespace nipref::ref
