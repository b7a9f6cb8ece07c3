#pragma once
#include <complex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <nipref/data/bad_input.hpp>
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

/// What a modulus of a linear viscoelastic solid, in shear or in dilatation, is made of. All relaxation times are one.
/// (thesis 6.12-6.15, AIII.1-AIII.8)
enum class SpringModel {
  elastic,          ///< a spring
  standard_linear,  ///< a spring in series with a second spring and a dashpot side by side
  kelvin_voigt,     ///< a spring and a dashpot side by side: nothing gives way at once
  maxwell           ///< a spring and a dashpot in series: nothing holds for ever
};

/// What a material's functions were rounded from; std::monostate: they are what was given.
using MaterialConstants = std::variant<std::monostate, ElasticMaterial, StandardLinearSolid,
                                       SingleRelaxationTimeSolid, DifferentialOperators>;

/// amplitude e^(-rate t). Complex ones come in conjugate pairs, both members listed.
struct RelaxationTerm {
  std::complex<double> amplitude;  ///< 1/(stress time)
  std::complex<double> rate;       ///< real part > 0, or 0 (Maxwell's: it flows for ever), 1/time
};

/// theta(t) = instantaneous delta(t) + sum_r amplitude_r e^(-rate_r t), t >= 0: the strain that a unit
/// impulse of stress leaves. (thesis 6.16, 6.17)
struct MaterialFunction {
  double instantaneous;               ///< gamma_0, 1/stress: the compliance at once; 0: Kelvin's and Voigt's
  std::vector<RelaxationTerm> terms;  ///< no rate twice; none: elastic

  /// The transform gamma_0 + sum_r amplitude_r/(p + rate_r), 1/stress; p is no rate's negative, 1/time.
  [[nodiscard]] std::complex<double> transform(std::complex<double> p) const;
  /// Whether a rate is 0.
  [[nodiscard]] bool is_fluid() const;
  /// The compliance after a long time, transform(0), 1/stress; not of a fluid.
  [[nodiscard]] double long_time() const { return transform(0).real(); }
};

/// What is refused of a material, whoever finds it: a path that factors operators, or the check of its functions.
class NoMaterial : public BadInput {
 public:
  using BadInput::BadInput;
  /// What the argument is called in a scene: a key of [material].
  [[nodiscard]] std::string key() const;
};

/// Both compliances of an isotropic material in plane strain, in time.
struct MaterialFunctions {
  MaterialFunction theta1;  ///< 1/(2G) as an operator
  MaterialFunction theta2;  ///< 3/(6K + 2G) as an operator

  /// Throws NoMaterial unless both functions are well formed (finite, conjugate pairs complete, no rate twice,
  /// real parts of the rates positive, or the rate 0) and the material is physical: compliances not below 0 at
  /// once and positive after a long time, and in shear and in dilatation no gain of energy at any frequency.
  void check() const;
  /// N = theta1 + theta2, the compliance of the normal displacement under a normal load; terms of equal rate are
  /// joined.
  [[nodiscard]] MaterialFunction normal_compliance() const;
};

/// An isotropic linear viscoelastic material in plane strain as it was described; it never changes.
class ViscoelasticMaterial {
 public:
  /// Checks the functions, see above. `constants`: what they were rounded from.
  ViscoelasticMaterial(MaterialFunction theta1, MaterialFunction theta2, MaterialConstants constants = {});
  // The rates of these are roots of polynomials. Only the constants are checked here: the path that finds the roots
  // checks the functions that they make.
  explicit ViscoelasticMaterial(const StandardLinearSolid& solid);
  explicit ViscoelasticMaterial(DifferentialOperators operators);

  /// Absent where the rates are roots.
  [[nodiscard]] const std::optional<MaterialFunctions>& functions() const { return functions_; }
  [[nodiscard]] const MaterialConstants& constants() const { return constants_; }
  /// Whether theta1(0) > 0.
  [[nodiscard]] bool gives_way_at_once() const;

 private:
  std::optional<MaterialFunctions> functions_;
  MaterialConstants constants_;
};

// Viscoelastic materials from what describes them. Each throws BadInput, naming the argument as a scene's
// [material] does, for values out of their domain, and for what is no ViscoelasticMaterial.

/// No relaxation at all.
[[nodiscard]] ViscoelasticMaterial elastic_solid(const ElasticMaterial& material);

[[nodiscard]] ViscoelasticMaterial standard_linear_solid(const StandardLinearSolid& solid);

/// The same with G1 = G2 = shear, K1 = K2 = bulk and one relaxation time, > 0: it ends up twice as compliant
/// as it begins. theta2 fades `theta2_rate_factor` times as fast as theta1. (thesis AIII.10, AIII.11)
[[nodiscard]] ViscoelasticMaterial single_relaxation_time_solid(double bulk, double shear,
                                                                double relaxation_time,
                                                                int theta2_rate_factor = 1);

/// How many times faster than it should theta2 fades by the thesis's own result for that solid, which is wrong: it has
/// e^(-2t/tau) for e^(-t/tau), the residue of one root with the rate of the other. Its tables were computed with it.
/// Physical all the same. (thesis AIII.15)
inline constexpr int misprinted_rate_factor = 2;

/// G/K of the thesis's solid, exactly: Poisson's ratio is 1/3. (thesis AIII.12)
inline constexpr double thesis_shear_over_bulk = 3.0 / 8;

/// What a solid answers at once, 1/(2G) and 3/(6K + 2G): > 0 and finite, 1/stress.
struct Compliances {
  double theta1, theta2;
};

/// The same, its moduli at once given by the compliances.
[[nodiscard]] ViscoelasticMaterial single_relaxation_time_solid(const Compliances& at_once,
                                                                double relaxation_time,
                                                                int theta2_rate_factor = 1);

[[nodiscard]] ViscoelasticMaterial prony_solid(const PronyList& theta1, const PronyList& theta2);

[[nodiscard]] ViscoelasticMaterial operator_solid(const DifferentialOperators& operators);

}  // namespace nipref::data
