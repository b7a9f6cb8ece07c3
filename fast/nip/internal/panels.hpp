#pragma once
#include <complex>
#include <vector>

#include <nipref/fast/nip/internal/tractions.hpp>

namespace nipref::fast {

/// The factor, at least, by which the coefficients at the end of each expansion fall a term.
inline constexpr double least_fall = 1.6;

/// What limits how fast the expansions of a kind of contact converge.
struct Resolution {
  double nats;  ///< coefficients are to fall to e^-nats of the largest
  /// Of what an end causes in the tractions, e^(-decay e) is left at the distance e, 1/half-thickness: the zero of the
  /// kernel's transform that is nearest to the real axis.
  double decay;
  int polynomial;  ///< degree of the tractions far from the ends of a long contact
  std::vector<std::complex<double>>
      rates;  ///< of exponentials e^(-rate x) from the leading end on, x the distance from it
};

/// One expansion over the whole contact needs the fewest terms. The wider it is, the larger is the logarithm against the
/// kernel, in which it cancels: beyond the second of these half lengths panels have less rounding.
inline constexpr double longest_whole = 12, longest_always_whole = 4;

/// Panels of a contact of half length A: one that is the whole contact up to `longest`, otherwise panels that double
/// from the end on until the end is forgotten or the middle is near, and one about the middle. The number of terms
/// follows from the singularities of the tractions, which are at the ends and 2 i to both sides of these, and from the
/// exponentials, whose Chebyshev coefficients are modified Bessel functions.
std::vector<Panel> panels(double half_length, const Resolution& resolution, double longest = longest_whole);

/// Whether the pressure of an exponential of this rate is a layer of its own (layer.hpp) next to the leading end.
bool is_layer(std::complex<double> rate, const std::vector<Panel>& panels);

}  // namespace nipref::fast
