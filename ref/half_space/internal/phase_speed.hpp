#pragma once
#include <functional>
#include <optional>

#include <nipref/ref/half_space/direction.hpp>
#include <nipref/ref/half_space/stiffness.hpp>
#include <nipref/ref/number/enclosure.hpp>

namespace nipref::ref {

// Phase speeds as inertia = density speed^2/C33, enclosed to a relative width of about 2^-bits. BadInput
// "solid" where that is not proven, as where moduli are many powers of ten apart or a surface wave is next to
// the limiting speed.

inline constexpr auto surface_wave = "surface wave";
[[noreturn]] void refuse_proof(const SurfaceDirection& psi, const char* what);

/// Of the limiting speed.
Interval limiting_inertia(const ExactStiffness& solid, const SurfaceDirection& psi, mpfr_prec_t bits);

/// Of the surface wave; nothing where none is slower than 1 - 2^(-bits - 8) of the limiting speed.
std::optional<Interval> surface_wave_inertia(const ExactStiffness& solid, const SurfaceDirection& psi,
                                             mpfr_prec_t bits);

/// The surface wave's inertia, or the limiting one where there is none, to some 12 digits and unproven.
double approximate_critical_inertia(const ExactStiffness& solid, const SurfaceDirection& psi);

/// Whether lines of psi that move with this inertia along them are proven to be slower than both. The proof
/// needs some distance from these, far below that of two doubles.
bool is_subcritical(const ExactStiffness& solid, const SurfaceDirection& psi,
                    const std::function<Interval(mpfr_prec_t precision)>& inertia);

}  // namespace nipref::ref
