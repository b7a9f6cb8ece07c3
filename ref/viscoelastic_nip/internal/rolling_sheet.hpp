#pragma once
#include <vector>

#include <nipref/ref/nip/internal/nip_solution.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_material.hpp>

namespace nipref::ref {

/// A steadily rolling sheet and the inverse of its compliance. With D = d/dx, x the way behind the leading end, the surface
/// follows u = C f, C = 1 + sum_i a_i/(D + r_i), from what an elastic sheet would do, f = K p; and
///
///     f = u/C = (1 + sum_j b_j/(D + s_j)) u,   C(-s_j) = 0,   b_j = 1/C'(-s_j).
///
/// Both lists have both terms of a pair of conjugate ones.
struct RollingSheet {
  RollingMaterial material;
  std::vector<RollingMemory> memory, inverse;

  explicit RollingSheet(RollingMaterial the_material);
  /// Of the pressure in a contact, on panels on which all r_i and s_j change little at an end.
  [[nodiscard]] Resolution resolution() const;
  /// Digits that are lost where memories make the sheet far softer than it is at once, a fluid over a half-thickness:
  /// their parts cancel.
  [[nodiscard]] int lost_digits() const;
};

}  // namespace nipref::ref
