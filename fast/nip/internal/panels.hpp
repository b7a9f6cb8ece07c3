#pragma once
#include <complex>
#include <vector>

#include <nipref/fast/nip/internal/tractions.hpp>

namespace nipref::fast {

/// The last coefficients of each expansion fall from one term to the next by at least this factor.
inline constexpr double least_fall = 1.6;

/// How far the expansions of a contact are to converge, and what limits how fast they do.
struct Resolution {
  double nats;  ///< the coefficients are to fall to e^-nats of the largest
  /// The effect of an end on the tractions falls like e^(-decay e) with the distance e from it, 1/half-thickness: it is the
  /// zero of the kernel's transform that is nearest to the real axis.
  double decay;
  int polynomial;  ///< degree of the tractions far from the ends of a long contact
  std::vector<std::complex<double>>
      rates;  ///< of exponentials e^(-rate x) from the leading end on, x the distance from it
  /// Of each component of a panel, beyond those that the coefficients need: they show that those suffice.
  int checking_terms = 3;
};

/// One expansion over the whole contact needs the fewest terms. The wider it is, the larger is the logarithm against the
/// kernel, in which it cancels: beyond the second of these half lengths panels have less rounding.
inline constexpr double longest_whole = 12, longest_always_whole = 4;

/// The panels of a contact of half length A. Up to `longest` one panel is the whole contact. Otherwise the width of panels
/// doubles from the end on, until the effect of the end is less than rounding or the middle is near, and one panel is about
/// the middle. The number of terms follows from the singularities of the tractions, which are at the ends and 2 i to both
/// sides of these, and from the exponentials, whose Chebyshev coefficients are modified Bessel functions.
std::vector<Panel> panels(double half_length, const Resolution& resolution, double longest = longest_whole);

/// Whether the pressure of an exponential of this rate is a layer of its own (layer.hpp) next to the leading end.
bool is_layer(std::complex<double> rate, const std::vector<Panel>& panels);

}  // namespace nipref::fast
