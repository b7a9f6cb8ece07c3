#pragma once
#include <nipref/data/problem/sheet_load.hpp>

namespace nipref::verify {

// Sizes of the sheet kernels away from their zeros, all functions of x = |argument| (dimensionless),
// dimensionless. They are only the scale against which errors are measured: a few digits are enough, and
// neither path is used.

/// 2 pi |c| e^(-K x): the amplitude of the slowest residue term (thesis AI.5, AI.13, AI.14), K = Im z of the
/// first root.
double envelope_I1(double alpha);
double envelope_I3(double alpha);
double envelope_I7(double eta);
/// The same for the two parts of I6, which is r(alpha) - s(eta) + pi/4 (|eta| - |alpha|).
double envelope_r(double alpha);
double envelope_s(double eta);

/// Least upper bounds that are easy to write: min(slope at 0 * x, largest value), thesis (AI.8), (AI.13).
double magnitude_I3(double alpha);
double magnitude_I4(double eta);
double magnitude_I5(double eta);

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
