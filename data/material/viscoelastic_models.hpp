#pragma once
#include <vector>

#include <nipref/data/material/constants.hpp>
#include <nipref/data/material/viscoelastic.hpp>

namespace nipref::data {

// Viscoelastic materials from what describes them. Each throws BadInput, naming the argument as a scene's
// [material] does, for values out of their domain, and for what is no ViscoelasticMaterial.

/// No relaxation at all.
[[nodiscard]] ViscoelasticMaterial elastic_solid(const ElasticMaterial& material);

[[nodiscard]] ViscoelasticMaterial standard_linear_solid(const StandardLinearSolid& solid);

/// The same with G1 = G2 = shear, K1 = K2 = bulk and one relaxation time, > 0: it ends up twice as compliant
/// as it begins. (thesis AIII.10, AIII.11)
[[nodiscard]] ViscoelasticMaterial single_relaxation_time_solid(double bulk, double shear,
                                                                double relaxation_time);

/// The thesis's own result for that solid, which is wrong: in theta2 it has e^(-2t/tau) for e^(-t/tau), the
/// residue of one root with the rate of the other. Its tables were computed with it. Physical all the same.
/// (thesis AIII.15)
[[nodiscard]] ViscoelasticMaterial misprinted_thesis_solid(double bulk, double shear, double relaxation_time);

/// How many times faster than it should theta2 fades by the misprint.
inline constexpr int misprinted_rate_factor = 2;

/// G/K of the thesis's solid, exactly: Poisson's ratio is 1/3. (thesis AIII.12)
inline constexpr double thesis_shear_over_bulk = 3.0 / 8;

/// What a solid answers at once, 1/(2G) and 3/(6K + 2G): > 0 and finite, 1/stress.
struct Compliances {
  double theta1, theta2;
};

/// The same two solids, their moduli at once given by the compliances.
[[nodiscard]] ViscoelasticMaterial single_relaxation_time_solid(const Compliances& at_once,
                                                                double relaxation_time);
[[nodiscard]] ViscoelasticMaterial misprinted_thesis_solid(const Compliances& at_once,
                                                           double relaxation_time);

[[nodiscard]] ViscoelasticMaterial prony_solid(const PronyList& theta1, const PronyList& theta2);

[[nodiscard]] ViscoelasticMaterial operator_solid(const DifferentialOperators& operators);

}  // namespace nipref::data
