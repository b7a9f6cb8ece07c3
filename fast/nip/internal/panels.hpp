#pragma once
#include <complex>
#include <vector>

#include <nipref/fast/nip/internal/tractions.hpp>

namespace nipref::fast {

/// The last coefficients of each expansion fall from one term to the next by at least this factor. Those of exponentials
/// have to, see degree_of_exponential in panels.cpp. Because of the singularities of the tractions alone they fall by 2.2
/// or more: slowest if one panel is a whole contact of half-length 12, with singularities 2 i beside its ends.
inline constexpr double least_fall = 1.6;

/// How small the last coefficients of a contact's expansions are to be, and what determines how fast coefficients fall.
struct Resolution {
  double nats;  ///< the coefficients are to fall to e^-nats of the largest
  /// The effect of an end on the tractions falls like e^(-decay e) with the distance e from it, 1/half-thickness: it is
  /// the zero of the kernel's transform that is nearest to the real axis.
  double decay;
  int polynomial;  ///< degree of the tractions far from the ends of a long contact
  std::vector<std::complex<double>>
      rates;  ///< of exponentials e^(-rate x) in the tractions, x the distance from the leading end
  /// The terms of each component of a panel beyond those that are needed; they show that the others suffice.
  int checking_terms = 3;
};

/// The largest half-lengths with one expansion over the whole contact, which needs the fewest terms. The wider a panel
/// is, the larger is the logarithm relative to the kernel, in which the logarithm cancels. Beyond the second
/// half-length several panels therefore have smaller rounding errors.
inline constexpr double longest_whole = 12, longest_always_whole = 4;

/// The panels of a contact. Up to the half-length `longest` one panel is the whole contact, if its terms are few
/// enough. Otherwise the widths of the panels double from the end on, until the effect of the end is less than rounding
/// or the middle is near, and one panel is about the middle. The number of terms follows from the singularities of the
/// tractions, at the ends and +- 2 i beside them, and from the exponentials, expanded in modified Bessel functions.
std::vector<Panel> panels(double half_length, const Resolution& resolution, double longest = longest_whole);

/// Whether the pressure of an exponential of this rate has its own function at the leading end, a layer (layer.hpp).
bool is_layer(std::complex<double> rate, const std::vector<Panel>& panels);

}  // namespace nipref::fast
