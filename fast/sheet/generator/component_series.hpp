#pragma once
#include <nipref/fast/sheet/generator/series.hpp>
#include <nipref/fast/sheet/internal/tables.hpp>

namespace nipref::fast::generator {

/// The first roots of sinh 2z + 2z = 0 in the first quadrant, ordered by modulus. Each is checked to solve the equation and
/// to lie in its own strip n pi - pi/2 < Im z < n pi, which holds no other (thesis Appendix IV); a failed check throws
/// std::logic_error.
const std::vector<Complex>& roots();

/// One component f as its residue series f(x) = limit + Re sum_n A_n e^(i z_n x), x > 0. The only input is the roots and the
/// residues.
class ComponentSeries {
 public:
  explicit ComponentSeries(internal::Component component);

  /// Value at infinity: pi/4 for the odd components, 0 for the others.
  [[nodiscard]] Real limit() const;
  /// The complex amplitudes A_n.
  [[nodiscard]] const std::vector<Complex>& amplitudes() const { return amplitudes_; }
  /// c such that f - c x is even, or f is odd.
  [[nodiscard]] Real linear() const;
  /// The power series in x^2 of f + ln x where f is logarithmic, f/x where it is odd and f elsewhere, less c x: good to 40
  /// digits for 0 <= x <= 1/2.
  [[nodiscard]] const Series& about_zero() const { return about_zero_; }
  /// f(x), or f(x)/x where f is odd; for a logarithmic f from x = 1/8 on.
  [[nodiscard]] Real operator()(const Real& x) const;

 private:
  [[nodiscard]] Real by_residues(const Real& x) const;
  [[nodiscard]] Real even_part(const Real& square) const;

  internal::Component component_;
  std::vector<Complex> amplitudes_;
  Series about_zero_;
};

}  // namespace nipref::fast::generator
