#pragma once
#include <functional>

#include <nipref/data/problem/viscoelastic_nip.hpp>
#include <nipref/fast/number/estimate.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>

namespace nipref::verify {

/// What a steadily rolling sheet loses in a unit of length rolled, by its losses at all frequencies,
///
///     (1/pi) int_0^inf S(q b) |p^(q)|^2 (-Im N(i q speed)) dq,   S(s) = 2 sinh^2 s/(sinh 2s + 2s),
///
/// b the half-thickness, p^ the Fourier transform of the pressure over the contact's `ends`: force per unit
/// width, energy per length and width. It is W mu_R, to which it comes by none of the kernels, memories and
/// systems that the contact was solved by: a check.
///
/// The pressure is expanded in Legendre's polynomials on panels that double away from both ends; p^ has their
/// transforms, spherical Bessel functions, in closed form. The frequencies are cut smoothly into octaves; in each
/// the trapezoidal rule takes steps that are small beside the octave and either resolve the swing of |p^|^2 from
/// one end of the contact to the other, e^{2 i q A}, or are an odd number of half swings, which cancel.
///
/// The error is twice what a finer rule and more polynomials change, what the pressure's own error can change, and
/// rounding.
fast::Estimate loss_integral(const data::ViscoelasticNip& nip, const ContactEnds& ends,
                             const std::function<fast::Estimate(double y)>& pressure);

}  // namespace nipref::verify
