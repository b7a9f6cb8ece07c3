#pragma once
#include <optional>

#include <nipref/ref/half_space/direction.hpp>
#include <nipref/ref/half_space/stiffness.hpp>
#include <nipref/ref/number/internal/interval_matrix.hpp>

namespace nipref::ref {

/// With n the direction of the line in the surface and m = e3, in units of C33: q_ik = n_j C_ijkl n_l -
/// inertia delta_ik, r_ik = n_j C_ijkl m_l, t_ik = m_j C_ijkl m_l. Fields exp(iq(n.x + s x3)) satisfy
/// [q + s (r + r^T) + s^2 t] a = 0, where inertia = density (speed cos(psi - theta))^2/C33.
struct AcousticMatrices {
  IntervalMatrix q, r, t;
};

AcousticMatrices acoustic_matrices(const ExactStiffness& solid, const SurfaceDirection& psi,
                                   const Interval& inertia);

/// density (speed cosine)^2/C33.
Interval inertia_of(const ExactStiffness& solid, const Exact& speed, const Interval& cosine);

/// The impedance M of a half-space (Hermitian, unit C33, axes 1, 2, 3): a surface displacement u exp(iq n.x), q > 0,
/// has the traction sigma_i3 = -q M_ik u_k. Nothing if no enclosure is proven at the precision of the matrices. An
/// enclosure also proves that the speed is below the limiting speed.
///
/// Proof: ref/half_space/README.md, The response of lines. M0 and X are found in floating point, the rest is interval
/// arithmetic.
std::optional<IntervalMatrix> surface_impedance(const AcousticMatrices& matrices);

}  // namespace nipref::ref
