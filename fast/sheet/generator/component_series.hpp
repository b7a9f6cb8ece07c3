#pragma once
#include <nipref/fast/sheet/generator/series.hpp>
#include <nipref/fast/sheet/internal/tables.hpp>

namespace nipref::fast::generator {

/// The first roots of sinh 2z + 2z = 0 in the first quadrant, ordered by modulus. Each is checked to solve the equation and
/// to lie in its own strip n pi - pi/2 < Im z < n pi, which holds no other (thesis Appendix IV); a failed check throws
/// std::logic_error.
const std::vector<Complex>& roots();

/// One component f by its residue series f(x) = limit + Re sum_n A_n e^(i z_n x), x > 0, from the roots and residues alone.
class ComponentSeries {
 public:
  explicit ComponentSeries(internal::Component component);

  /// The value at infinity: pi/4 for the odd components, 0 for the others.
  [[nodiscard]] Real limit() const;
  /// The complex amplitudes A_n.
  [[nodiscard]] const std::vector<Complex>& amplitudes() const { return amplitudes_; }
  /// The number c for which f - c x, or f + ln x - c x for logarithmic f, is even; 0 for odd f.
  [[nodiscard]] Real linear() const;
  /// The power series in x^2 of f + ln x - c x for logarithmic f, of f/x for odd f, and of f - c x for other f. It has
  /// 40 correct digits for 0 <= x <= 1/2.
  [[nodiscard]] const Series& about_zero() const { return about_zero_; }
  /// f(x), or f(x)/x for odd f. For logarithmic f, x must be at least 1/8.
  [[nodiscard]] Real operator()(const Real& x) const;

 private:
  [[nodiscard]] Real by_residues(const Real& x) const;
  [[nodiscard]] Real even_part(const Real& square) const;

  internal::Component component_;
  std::vector<Complex> amplitudes_;
  Series about_zero_;
};

}  // namespace nipref::fast::generator
