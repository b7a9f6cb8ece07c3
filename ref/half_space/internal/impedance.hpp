#pragma once
#include <optional>

#include <nipref/ref/half_space/internal/acoustic_matrices.hpp>

namespace nipref::ref {

/// The impedance M of a half-space (Hermitian, unit C33, axes 1, 2, 3): a surface displacement u exp(iq n.x), q > 0,
/// has the traction sigma_i3 = -q M_ik u_k. Nothing if no enclosure is proven at the precision of the matrices. An
/// enclosure also proves that the speed is below the limiting speed.
///
/// Proof. M is the one Hermitian solution of Riccati's equation F(M) = (M - i r) t^{-1} (M + i r^T) - q = 0
/// for which G = t^{-1} (M + i r^T), the generator of exp(-q G x3), has its spectrum in Re > 0. For an
/// approximation M0 with F0 = F(M0), G0 and any X > 0 with G0* X + X G0 >= (1 - d) I, d < 1, Lyapunov's
/// operator E -> G0* E + E G0 has an inverse of norm <= b = trace X/(1 - d) (attained at the identity), and
/// the error E = M - M0 solves E = -L^{-1}(F0 + E t^{-1} E). If 4 b^2 |t^{-1}| |F0| < 1 the ball |E| <= 2 b
/// |F0| is mapped into itself, and G stays stable in it by the same X. M0 and X are found in floating point,
/// the rest is interval arithmetic.
std::optional<IntervalMatrix> surface_impedance(const AcousticMatrices& matrices);

}  // namespace nipref::ref
