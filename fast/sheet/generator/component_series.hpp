#pragma once
#include <nipref/fast/sheet/generator/number.hpp>
#include <nipref/fast/sheet/internal/tables.hpp>

namespace nipref::fast::generator {

/// One component f as its residue series f(x) = limit + Re sum_n A_n e^(i z_n x), x > 0, and its power series, which
/// follow by differentiation and analytic continuation. The only input is the roots and the residues.
class ComponentSeries {
 public:
  ComponentSeries(internal::Component component, const std::vector<Complex>& roots);

  /// Value at infinity: pi/4 for the odd components, 0 for the others.
  [[nodiscard]] Real limit() const;

  /// The complex amplitudes A_n.
  [[nodiscard]] const std::vector<Complex>& amplitudes() const { return amplitudes_; }

  /// Taylor coefficients about centre > 0, the first `length` of them.
  [[nodiscard]] Series about(const Real& centre, int length) const;

  /// Power series about 0 of f, or of f + ln x when f is logarithmic: continued from a Taylor series about a
  /// centre inside the circle of convergence. Coefficients of the wrong parity must vanish, apart from those
  /// of the components of I6, which differ from even functions by (pi/4) x; a failed check throws
  /// std::logic_error.
  [[nodiscard]] Series about_zero() const;

 private:
  [[nodiscard]] Complex amplitude(const Complex& root) const;

  internal::Component component_;
  const std::vector<Complex>* roots_;
  std::vector<Complex> amplitudes_;
};

}  // namespace nipref::fast::generator
