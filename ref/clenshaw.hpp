#pragma once
#include <gmpxx.h>

#include "ref/nodes.hpp"
#include "ref/real.hpp"

namespace nipref::ref {

/// The angle theta = a h, 0 <= theta <= 16, between neighbouring nodes, to `precision` bits.
struct Angle {
  Angle(const mpq_class& theta, mpfr_prec_t precision);
  Real sine;              ///< sin(theta), relatively good as theta -> 0
  Real half_sine_square;  ///< sin^2(theta/2)
};

/// Precision an Angle needs for the sums over `nodes`.
mpfr_prec_t angle_precision(const Nodes& nodes);

/// sum_{j=0}^{last} Re(g_j e^{i j theta}) by Clenshaw's recurrence in fixed point,
///
///     b_j = g_j + 2 b_{j+1} - b_{j+2} - 4 kappa b_{j+1},    kappa = sin^2(theta/2).
///
/// An error made in b_j acts on the sum as a change of g_j by the same amount. In units of 2^-F one step makes less than 8: the
/// product is cut by less than one unit and taken fourfold (4), kappa is cut to as many bits as b has, by which the product loses at
/// most 2 more, and the node is off by 1. Additions are exact. Hence |error| <= 8 (last + 3) units a recurrence (one on the real
/// axis, two off it), the last steps and the rounding of the Angle included.
Real wave_sum(const Nodes& nodes, const Angle& angle);

/// sum_{j=1}^{last} Re(g_j) sin(j theta) for symbols on the real axis; |error| <= 8 min(last + 3, theta (last + 3)^2) units.
Real sine_sum(const Nodes& nodes, const Angle& angle);

/// Error bound of a recurrence is this many units a node, see wave_sum.
constexpr long rounding_units = 8;

}  // namespace nipref::ref
