#pragma once
#include <nipref/verify/replay/replay.hpp>

namespace nipref::verify {

/// Fills a replay of thesis XI-XXVI. `corrected`: the continuous contact, within 1e-6, that carries the
/// table's load, with the solid as it was defined (one relaxation time in shear and dilatation);
/// `corrected_with_seed_material`: the same with the thesis's theta2. `costs`, each at the load of the row's
/// replay, in L, d0, p_max and muR: "truncation", the replay against the same line loads with exact kernels;
/// "discretisation", these against the continuous contact; "exponent", the continuous contact with the
/// thesis's theta2 against the one with the solid's.
void correct_viscoelastic(Replay& replay);

}  // namespace nipref::verify
