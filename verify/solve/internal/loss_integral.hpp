#pragma once
#include <functional>

#include <nipref/data/problem/viscoelastic_nip.hpp>
#include <nipref/fast/number/estimate.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>

namespace nipref::verify {

/// The energy that a steadily rolling sheet loses in a unit of length rolled, as the sum of its losses at all
/// frequencies,
///
///     (1/pi) int_0^inf S(q b) |p^(q)|^2 (-Im N(i q speed)) dq,   S(s) = 2 sinh^2 s/(sinh 2s + 2s),
///
/// where b is the half-thickness and p^ the Fourier transform of the pressure between the contact's `ends`. Unit: force
/// per unit width, which is energy per length and width. The loss equals W mu_R. It is computed without the kernels,
/// the memory and the linear systems by which the contact was solved, so that it is an independent check.
///
/// The pressure is expanded in Legendre polynomials on panels whose length doubles with the distance from each end;
/// their Fourier transforms are spherical Bessel functions. A smooth partition divides the frequencies into octaves. In
/// each octave the trapezoidal rule takes steps that are small against the octave. They either resolve the oscillation
/// e^{2 i q A} of |p^|^2, which comes from the two ends of the contact, or are an odd number of its half periods, which
/// cancel.
///
/// The error estimate is the sum of twice the change by a finer rule and more polynomials, of the largest change that
/// the pressure's own error can cause, and of rounding.
fast::Estimate loss_integral(const data::ViscoelasticNip& nip, const ContactEnds& ends,
                             const std::function<fast::Estimate(double y)>& pressure);

}  // namespace nipref::verify
