#pragma once
#include <gmpxx.h>

#include "ref/nodes.hpp"

namespace nipref::ref {

/// cos(theta) and sin(theta) for theta = a h, to `precision` bits: |d cos|, |d sin| <= 2^-(precision-5) for
/// theta <= 16, and sin relatively good as theta -> 0.
struct Angle {
  Angle(const mpq_class& theta, mpfr_prec_t precision);
  Real cosine;
  Real sine;
};

/// Precision an Angle needs for the sums over `nodes`.
mpfr_prec_t angle_precision(const Nodes& nodes);

/// sum_{j=0}^{last} Re(g_j e^{i j theta}) by Clenshaw's recurrence b_j = g_j + 2 cos(theta) b_{j+1} -
/// b_{j+2}.
///
/// A rounding error made in b_j acts on the sum as a change of g_j by the same amount. With the working
/// precision of a block p >= A + magnitude + 2 and |b_j| <= 2^magnitude, one step makes at most 2^-A (1/4 +
/// 1/4 + 1/8 + 1/2) in product, difference, sum and rounded 2 cos(theta); the node itself is off by at most
/// 2^-A/2. Hence |error| <= 2 (last + 3) 2^-A a recurrence.
Real wave_sum(const Nodes& nodes, const Angle& angle);

/// sum_{j=1}^{last} Re(g_j) sin(j theta) for symbols on the real axis; |error| <= 2 min(last + 3, theta (last
/// + 3)^2) 2^-A.
Real sine_sum(const Nodes& nodes, const Angle& angle);

}  // namespace nipref::ref
