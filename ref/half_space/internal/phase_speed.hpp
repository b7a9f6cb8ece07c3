#pragma once
#include <functional>
#include <optional>

#include <nipref/ref/half_space/direction.hpp>
#include <nipref/ref/half_space/stiffness.hpp>
#include <nipref/ref/number/enclosure.hpp>

namespace nipref::ref {

// Phase speeds as inertia = density speed^2/C33, enclosed to a relative width of about 2^-bits. BadInput "solid" if no
// proof is found, because moduli differ by many powers of ten or a surface wave is close to the limiting speed.

inline constexpr auto surface_wave = "surface wave";
[[noreturn]] void refuse_proof(const SurfaceDirection& psi, const char* what);

/// The inertia at the limiting speed.
Interval limiting_inertia(const ExactStiffness& solid, const SurfaceDirection& psi, mpfr_prec_t bits);

/// The inertia of the surface wave; nothing if no surface wave is slower than 1 - 2^(-bits - 8) of the limiting speed.
std::optional<Interval> surface_wave_inertia(const ExactStiffness& solid, const SurfaceDirection& psi,
                                             mpfr_prec_t bits);

/// The inertia of the surface wave or, if there is none, of the limiting speed, to about 12 digits; not proven.
double approximate_critical_inertia(const ExactStiffness& solid, const SurfaceDirection& psi);

/// Whether an inertia along psi is proven to be below the inertias of the limiting speed and of the surface wave. The
/// proof fails close to them, at a distance far below the spacing of doubles.
bool is_subcritical(const ExactStiffness& solid, const SurfaceDirection& psi,
                    const std::function<Interval(mpfr_prec_t precision)>& inertia);

}  // namespace nipref::ref
