#pragma once
#include <gmpxx.h>

#include <nipref/ref/number/float.hpp>
#include <nipref/ref/sheet/internal/nodes.hpp>

namespace nipref::ref {

/// The angle theta = a h, 0 <= theta <= 16, between neighbouring nodes, to `precision` bits.
struct Angle {
  Angle(const mpq_class& theta, mpfr_prec_t precision);
  Float sine;              ///< sin(theta), with a small relative error also as theta -> 0
  Float half_sine_square;  ///< sin^2(theta/2)
};

/// The precision that an Angle needs for the sums over `nodes`.
mpfr_prec_t angle_precision(const Nodes& nodes);

/// sum_{j=0}^{last} g_j cos(j theta) by Clenshaw's recurrence in Reinsch's form and in fixed point, with B_j = 4 b_j.
/// |error| <= 4 (last + 3) units 2^-F, including the last steps and the rounding of the Angle: ref/README.md, Lemma 5.
Float cosine_sum(const Nodes& nodes, const Angle& angle);

/// sum_{j=1}^{last} g_j sin(j theta); |error| <= 4 min(last + 3, theta (last + 3)^2) units.
Float sine_sum(const Nodes& nodes, const Angle& angle);

/// The error bound of a recurrence is this many units for each node, see cosine_sum.
constexpr long rounding_units = 4;

}  // namespace nipref::ref
