#pragma once
#include <array>
#include <complex>

#include <nipref/fast/sheet/internal/field_table.hpp>

namespace nipref::fast::internal {

/// A function of w = alpha + i depth, depth >= 0, that is real for real w.
struct ComplexValue {
  double re, im;
};

/// What the field inside the sheet is made of, analytic in |Im w| < 1:
///
///     I4, I5, I7   the kernels
///     K5           the integral of I5 that goes with w pi/4 at infinity
///     I5', I7'     derivatives
///
/// In stresses z cosh z cosh sz cos(alpha z)/S and its like are real or imaginary parts of these (thesis 3.19, 3.20).
struct FieldFunctions {
  std::array<ComplexValue, field_functions> of;

  const ComplexValue& operator[](FieldFunction f) const { return of[static_cast<std::size_t>(f)]; }
  ComplexValue& operator[](FieldFunction f) { return of[static_cast<std::size_t>(f)]; }
};

/// What is left of them at 0 <= alpha < near_load_end, 0 <= depth <= 1 without
///     I5  2 w/(1 + w^2),    I7  2/(1 + w^2),    K5  ln(1 + w^2),    I4  2 arctan w.
/// Imaginary parts, and real parts of I4, I5 and I7', are relatively accurate where they vanish.
/// Only the functions from `first` on: stresses need those from I5 on.
FieldFunctions near_rest(double alpha, double depth, FieldFunction first);

/// e^{i alpha z_n} of the roots that count at alpha >= near_load_end, of all that may below.
struct AlongWaves {
  explicit AlongWaves(double alpha);

  int count;
  std::array<std::complex<double>, field_roots> of;
};

/// cosh(s z_n) and sinh(s z_n) of the first `count` roots, s the depth.
struct AcrossWaves {
  AcrossWaves(double depth, int count);

  std::array<std::complex<double>, field_roots> cosh, sinh;
};

/// The same functions, again from `first` on, at alpha >= near_load_end without what does not decay: pi/4 of I4 and I5, w pi/4 of
/// K5.
FieldFunctions decaying(const AlongWaves& along, const AcrossWaves& across, FieldFunction first);
inline FieldFunctions decaying(double alpha, double depth, FieldFunction first) {
  const AlongWaves along(alpha);
  return decaying(along, AcrossWaves(depth, along.count), first);
}

}  // namespace nipref::fast::internal
