#pragma once
#include <nipref/data/problem/sheet_load.hpp>

namespace nipref::verify {

/// Sizes of the field inside the sheet away from its zeros: the sum of the magnitudes of its parts. These are, up to
/// |alpha| = 1.25, each half-plane's field; the terms of the slowest residue (times |alpha| below 1 where the value is
/// odd in it); in displacements what does not decay. They are only the yardstick that errors are measured with.
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
