#pragma once
#include <array>
#include <complex>

#include <nipref/fast/sheet/internal/field_table.hpp>

namespace nipref::fast::internal {

/// A function of w = alpha + i depth, depth >= 0, that is real for real w.
struct ComplexValue {
  double re, im;
};

/// The functions of which the field inside the sheet consists, analytic for |Im w| < 1:
///
///     I4, I5, I7   the kernels
///     K5           the integral of I5 that tends to w pi/4 at infinity
///     I5', I7'     derivatives
///
/// Integrals in stresses, like that of z cosh z cosh sz cos(alpha z)/S (thesis 3.19, 3.20), are parts of these functions.
struct FieldFunctions {
  std::array<ComplexValue, field_functions> of;

  const ComplexValue& operator[](FieldFunction f) const { return of[static_cast<std::size_t>(f)]; }
  ComplexValue& operator[](FieldFunction f) { return of[static_cast<std::size_t>(f)]; }
};

/// The functions from `first` on at 0 <= alpha < near_load_end, 0 <= depth <= 1, minus the half-planes' parts
///     I5  2 w/(1 + w^2),    I7  2/(1 + w^2),    K5  ln(1 + w^2),    I4  2 arctan w.
/// Imaginary parts, and real parts of I4, I5 and I7', are relatively accurate near their zeros. Stresses need the
/// functions from I5 on.
FieldFunctions near_rest(double alpha, double depth, FieldFunction first);

/// e^{i alpha z_n}/scale for the roots that contribute at alpha, or for all field_roots roots if alpha < near_load_end.
/// The scale is 1, but where the waves would be subnormal numbers it keeps their 53 bits.
struct AlongWaves {
  explicit AlongWaves(double alpha);

  int count;
  std::array<std::complex<double>, field_roots> of;
  double scale = 1;
};

/// cosh(s z_n) and sinh(s z_n) for the first `count` roots, where s is the depth.
struct AcrossWaves {
  AcrossWaves(double depth, int count);

  std::array<std::complex<double>, field_roots> cosh, sinh;
};

/// The functions from `first` on at alpha >= near_load_end, minus their parts that do not decay: pi/4 of I4 and I5,
/// w pi/4 of K5.
FieldFunctions decaying(const AlongWaves& along, const AcrossWaves& across, FieldFunction first);
inline FieldFunctions decaying(double alpha, double depth, FieldFunction first) {
  const AlongWaves along(alpha);
  return decaying(along, AcrossWaves(depth, along.count), first);
}

}  // namespace nipref::fast::internal
