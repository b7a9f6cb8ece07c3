#pragma once
#include <nipref/data/material/elastic.hpp>
#include <nipref/data/material/solids.hpp>

/// The solids of the seeds, in the seeds' units.
namespace nipref::data::seed {

/// The sphere of (brock2013 section 3): GPa, kg/m^3. Poisson's ratio follows from the paper's c_D = 1.8554.
inline constexpr IsotropicSolid steel{77.2, 0.29529, 7860};

/// The half-space under the sphere: GPa, kg/m^3. The paper's C55 is c44.
inline constexpr TransverselyIsotropicSolid graphite_epoxy{13.9, 160.7, 6.44, 7.07, 3.5, 1688};

/// The sheet of the thesis's tables III-XXVI as the thesis states it, psi; for the viscoelastic sheet these are the
/// instantaneous values. Its bulk modulus equals Young's modulus.
inline constexpr ElasticMaterial sheet{1.45e5, 1.0 / 3};

/// The sheet that reproduces these tables; the stated modulus reproduces none of them. Poisson's ratio is 0.33333, as
/// the thesis's program must have read one third: of the 126 legible cells d0, d1, p_max and q_max of III-VI, 83 match
/// at 1/3 and 105 at 0.33333. At 1/3 no other change gives more than 87: not E changed by up to 3 psi, kernels of 20 to
/// 500 residues, or kernels in single precision, binary or the IBM 360's hexadecimal.
inline constexpr ElasticMaterial sheet_of_the_tables{1.40536e5, 0.33333};

}  // namespace nipref::data::seed
