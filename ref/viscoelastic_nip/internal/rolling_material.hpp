#pragma once
#include <vector>

#include <nipref/data/problem/viscoelastic_nip.hpp>
#include <nipref/ref/number/internal/complex_float.hpp>

namespace nipref::ref {

/// Re amplitude e^(-rate w), w the way (half-thicknesses) that a material point has gone since: a relaxation
/// term of a compliance over the instantaneous part of N, as the steadily rolling sheet sees it. Dimensionless.
struct RollingMemory {
  ComplexFloat
      amplitude;      ///< twice that of the term, and not real, if it stands for a pair of conjugate ones
  ComplexFloat rate;  ///< real part > 0 and imaginary part >= 0, or 0: a fluid's
};

/// Whether it never fades.
inline bool is_flow(const RollingMemory& term) { return term.rate.re == 0; }

/// The compliances of a steadily rolling sheet.
struct RollingMaterial {
  Float compliance;                   ///< N at once, 1/stress
  std::vector<RollingMemory> normal;  ///< of N, beside 1
  Float theta2_at_once;               ///< over that of N
  std::vector<RollingMemory> theta2;
};

/// To the working precision, from the constants that the nip's material was made of, exactly, or, where there
/// are none, from its functions as they are. Throws data::NoMaterial as material_compliances().
RollingMaterial rolling_material(const data::ViscoelasticNip& nip);

}  // namespace nipref::ref
