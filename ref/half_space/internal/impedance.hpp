#pragma once
#include <optional>

#include <nipref/ref/half_space/internal/acoustic_matrices.hpp>

namespace nipref::ref {

/// The impedance M of a half-space (Hermitian, unit C33, axes 1, 2, 3): a surface displacement u exp(iq n.x), q > 0,
/// has the traction sigma_i3 = -q M_ik u_k. Nothing if no enclosure is proven at the precision of the matrices. An
/// enclosure also proves that the speed is below the limiting speed.
///
/// Proof: ref/half_space/README.md, The response of lines. M0 and X are found in floating point, the rest is interval
/// arithmetic.
std::optional<IntervalMatrix> surface_impedance(const AcousticMatrices& matrices);

}  // namespace nipref::ref
