#pragma once
#include <variant>
#include <vector>

#include <nipref/data/material/elastic.hpp>

namespace nipref::data {

// What materials are described by. Each is judged by what makes a ViscoelasticMaterial of it.

/// A spring in series with a spring and a dashpot side by side, in shear and in dilatation: 1/G = 1/G1 +
/// 1/(G2 + shear_viscosity p), 1/K likewise. All > 0 and finite, moduli in stress, viscosities in stress
/// time. Two equal relaxation times make one term. (thesis AIII.1-AIII.8)
struct StandardLinearSolid {
  double shear_1, shear_2;
  double bulk_1, bulk_2;
  double shear_viscosity, bulk_viscosity;
};

/// The same with G1 = G2 = shear, K1 = K2 = bulk and one relaxation time, > 0; theta2 fades
/// `theta2_rate_factor` times as fast as theta1. (thesis AIII.10, AIII.11)
struct SingleRelaxationTimeSolid {
  double bulk, shear;
  double relaxation_time;
  int theta2_rate_factor;
};

/// G = Q/P and K = Q'/P' with polynomials in d/dt, the coefficient of p^0 first. theta1 = P/(2Q) and theta2 =
/// 3/(6Q'/P' + 2Q/P) must have finite limits > 0 for short times. Common factors are cancelled, repeated
/// roots refused, complex rates allowed. (thesis 6.14-6.17)
struct DifferentialOperators {
  std::vector<double> p, q;                        ///< in shear: P, Q
  std::vector<double> p_dilatation, q_dilatation;  ///< P', Q'
};

/// theta(t) = instantaneous delta(t) + sum amplitude e^(-rate t): 1/stress, 1/(stress time), 1/time; the
/// lists of equal length, not empty. (thesis 6.16, 6.17)
struct PronyList {
  double instantaneous;
  std::vector<double> amplitudes, rates;
};
struct PronySeries {
  PronyList theta1, theta2;
};

/// What a material's functions were rounded from; std::monostate: they are what was given.
using MaterialConstants = std::variant<std::monostate, ElasticMaterial, StandardLinearSolid,
                                       SingleRelaxationTimeSolid, DifferentialOperators>;

}  // namespace nipref::data
