#pragma once
#include <span>

#include <nipref/fast/number/accuracy.hpp>
#include <nipref/fast/sheet/displacements.hpp>  // IWYU pragma: export

// Kernels of the elastic sheet in double, which are computed from the residue series alone (roots of sinh 2z + 2z = 0):
// from a tabulated local polynomial in two words up to 12 half-thicknesses, from the first residue beyond, with the
// logarithm in closed form below 1/2; see arithmetic/component.hpp. A value takes about 9 ns, in batches 1 to 3 ns on a
// processor with AVX-512 and 3 to 4 ns on one with AVX2.
//
// In common to all functions of this header:
//   alpha, eta   dimensionless distances from the load, in units of the sheet's half-thickness b
//   domain       every finite double, denormals included; I1, I6, un and vs are infinite at alpha = 0
//   accuracy     I1..I7: |error| <= rtol * scale, scale = max(|value|, envelope); 2 units in the last place
//                of the scale by default. The envelope is the first residue without its cosine,
//                2 pi |c_1| e^(-2.106 x); for odd kernels as the argument goes to 0 the scale is |value|.
//                F1, F2 and the influence functions are sums of two or three kernels, each within its own
//                promise. Results below 2^-1022 are good to one unit of 2^-1074.
//   bad input    nan or infinite arguments, and alpha = 0 where the kernel is infinite: data::BadInput
//   batches      value[i] = kernel(alpha[i]), within the same promise, not necessarily bit by bit; all spans
//                have the same size; value may be the argument's own span, but not overlap it otherwise. On
//                bad input BadInput names the element and nothing is written.

namespace nipref::fast {

/// int_0^inf 2 sinh^2 x cos(alpha x)/(x (sinh 2x + 2x)) dx. Even, -ln|alpha| - 0.3517 at 0. Thesis (4.9), (AI.9).
double I1(double alpha, Accuracy accuracy = {});

/// int_0^inf sin(alpha x)/x dx = (pi/2) sign(alpha), 0 at 0; correctly rounded. Thesis (AI.10).
double I2(double alpha);

/// int_0^inf 2 sin(alpha x)/(sinh 2x + 2x) dx. Odd, pi/4 at infinity. Thesis (4.9), (AI.12).
double I3(double alpha, Accuracy accuracy = {});

/// int_0^inf 2 sinh x sin(eta x)/(x (sinh 2x + 2x)) dx. Odd, pi/4 at infinity. Thesis (4.9), (AI.12).
double I4(double eta, Accuracy accuracy = {});

/// int_0^inf 2 cosh x sin(eta x)/(sinh 2x + 2x) dx. Odd, pi/4 at infinity. Thesis (4.9), (AI.12).
double I5(double eta, Accuracy accuracy = {});

/// int_0^inf 2 cosh x (cosh x cos(alpha x) - cos(eta x))/(x (sinh 2x + 2x)) dx. Even in both, -ln|alpha| at
/// alpha = 0, (pi/4)(|eta| - |alpha|) at infinity; the envelope is the sum of those of its two parts. Thesis
/// (4.20), (AI.12).
double I6(double alpha, double eta, Accuracy accuracy = {});

/// int_0^inf 2 sinh x cos(eta x)/(sinh 2x + 2x) dx. Even. Thesis (4.20), (AI.12).
double I7(double eta, Accuracy accuracy = {});

void I1(std::span<const double> alpha, std::span<double> value, Accuracy accuracy = {});
void I2(std::span<const double> alpha, std::span<double> value);
void I3(std::span<const double> alpha, std::span<double> value, Accuracy accuracy = {});
void I4(std::span<const double> eta, std::span<double> value, Accuracy accuracy = {});
void I5(std::span<const double> eta, std::span<double> value, Accuracy accuracy = {});
void I6(std::span<const double> alpha, std::span<const double> eta, std::span<double> value,
        Accuracy accuracy = {});
void I7(std::span<const double> eta, std::span<double> value, Accuracy accuracy = {});

}  // namespace nipref::fast
