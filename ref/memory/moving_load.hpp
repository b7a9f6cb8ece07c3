#pragma once
#include <nipref/ref/memory/exact_material.hpp>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

/// Displacements of the surface of a viscoelastic sheet under a pair of opposite unit line loads that move at
/// `speed` > 0 over the sheet, which was at rest before.
///
/// t >= 0 is the time since the load started, T the time at which it passes the point looked at, t0 the one
/// at which it passes the point of the centre line that is held; half_thickness > 0, any consistent units.
/// The way of the load in T, t0, T - t and t0 - t is at most 1000 half thicknesses. Results in 1/stress for a
/// unit load per length. A material's rates are at most 1e100 speed/half_thickness; with its fractions the ways
/// are at most 200. A value takes milliseconds, of fractions tens of them.
///
/// Definition: with alpha = speed (T - t)/half_thickness and eta the same of t0,
///
///     pi Un = N * I1(alpha),
///     pi Vn = N * I3(alpha) - theta2 * I2(alpha) + theta2 * I4(eta) - theta1 * I5(eta),
///
/// theta * I(alpha) = int_0^t theta(t - tau) I(speed (T - tau)/half_thickness) dtau. (thesis 6.18, 6.23-6.28)
///
/// residue_terms: 0, or 1 to 500 for the first so many residues of each kernel, as the thesis sums them; the error is
/// that of the sum.
///
/// Every function promises an Enclosure; digits 16 to 1000. The bound is proven: see kernels.hpp for what the
/// sheet answers at once, fading.hpp for what it remembers. Bad arguments throw data::BadInput.

/// Normal displacement; t != T.
Enclosure moving_load_normal_displacement(const Exact& t, const Exact& T, const Exact& speed,
                                          const Exact& half_thickness, const ExactMaterial& material,
                                          int digits, int residue_terms = 0);

/// Tangential displacement against the point held. At T = t, where it jumps, the mean of both sides (sign(0)
/// = 0), at t0 = t it is continuous.
Enclosure moving_load_tangential_displacement(const Exact& t, const Exact& T, const Exact& t0,
                                              const Exact& speed, const Exact& half_thickness,
                                              const ExactMaterial& material, int digits,
                                              int residue_terms = 0);

/// The same for a load that started infinitely long ago, alpha half thicknesses behind the point (alpha > 0:
/// the load has yet to come) and eta behind the one held; |alpha|, |eta| <= 1000.
Enclosure moving_load_steady_normal_displacement(const Exact& alpha, const Exact& speed,
                                                 const Exact& half_thickness, const ExactMaterial& material,
                                                 int digits);
Enclosure moving_load_steady_tangential_displacement(const Exact& alpha, const Exact& eta, const Exact& speed,
                                                     const Exact& half_thickness,
                                                     const ExactMaterial& material, int digits);

}  // namespace nipref::ref
