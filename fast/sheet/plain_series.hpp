#pragma once
#include <span>

namespace nipref::fast {

// The thesis's own method for the kernels: the first `terms` residues of (AI.9) and (AI.12), sum e^(-K_n |alpha|)
// (A_n sin m_n |alpha| + B_n cos m_n |alpha|) with z_n = m_n + i K_n, evaluated as printed. It serves to reproduce the
// thesis's tables and to compare speed and accuracy.
//
//   alpha  dimensionless, finite and nonzero (the series diverge at 0), otherwise BadInput
//   terms  1 .. most_residue_terms, otherwise BadInput
//   error  truncation error, about e^(-pi |alpha| terms)/(pi |alpha| terms) for I1 and I6, and rounding error
//
// The roots are computed at the first call.

inline constexpr int most_residue_terms = 500;

enum class PlainKernel { I1, I3, I4, I5, I6_alpha_part, I6_eta_part, I7 };  ///< I6 is the sum of its parts

/// A term of a kernel over pi is e^(-K x) (A sin m x + B cos m x), with the argument x >= 0 and the n-th root m + i K.
struct ResidueCoefficients {
  double A, B;
};

/// The coefficients of the n-th term. n: 1 <= n <= 1000000, otherwise BadInput. |error| <= 32 units in the last place
/// of sqrt(A^2 + B^2). Thesis (AI.8), (AI.13), (AI.14).
ResidueCoefficients residue_coefficients(PlainKernel kernel, int n);

/// I1 at one argument.
double plain_series_I1(double alpha, int terms);

/// The output spans, each as long as alpha, or empty if the kernel is not wanted.
struct PlainSeriesValues {
  std::span<double> I1;
  std::span<double> I3;
  /// The part of I6 that depends on alpha: the limit of I6(alpha, eta) - (pi/4)|eta| as |eta| grows.
  std::span<double> I6_alpha_part;
};

/// Computes the wanted kernels together; they share the exponential, the sine and the cosine of each term.
void plain_series(std::span<const double> alpha, int terms, PlainSeriesValues values);

}  // namespace nipref::fast
