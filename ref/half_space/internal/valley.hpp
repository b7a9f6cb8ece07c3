#pragma once
#include <nipref/ref/half_space/internal/acoustic_matrices.hpp>

namespace nipref::ref {

/// The s = tan(phi), in a scan of half a turn, for which q + s (r + r^T) + s^2 t has the smallest eigenvalue, and its
/// neighbours; in double.
struct Valley {
  double left, right;
  double eigenvalue;
};

/// The valley for matrices at rest.
Valley lowest_valley(const AcousticMatrices& matrices);

}  // namespace nipref::ref
