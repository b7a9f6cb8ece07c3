#pragma once
#include <nipref/data/problem/sheet_load.hpp>

namespace nipref::verify {

/// Sizes of the field inside the sheet away from its zeros: the sum of the magnitudes of its parts. The parts are the field
/// of each half-plane, up to |alpha| = 1.25; the terms of the slowest residue, for a value that is odd in alpha times
/// |alpha| below 1; and in displacements the part that does not decay. Errors are measured against them.
struct FieldSize {
  double alpha, depth;  ///< in half-thicknesses, of any sign
  data::SheetLoad load;

  [[nodiscard]] double across() const;
  [[nodiscard]] double along() const;
  [[nodiscard]] double shear() const;
  [[nodiscard]] double u(double poisson) const;
  [[nodiscard]] double v(double eta, double poisson) const;
};

}  // namespace nipref::verify
