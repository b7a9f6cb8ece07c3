#pragma once
#include <complex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/material/elastic.hpp>

namespace nipref::data {

// Descriptions of materials. Their values are checked when a ViscoelasticMaterial is made of them.

/// A spring in series with a spring and a dashpot side by side, in shear and in dilatation: 1/G = 1/G1 +
/// 1/(G2 + shear_viscosity p), 1/K likewise. All > 0 and finite, moduli in stress, viscosities in stress
/// time. Two equal relaxation times make one term. (thesis AIII.1-AIII.8)
struct StandardLinearSolid {
  double shear_1, shear_2;
  double bulk_1, bulk_2;
  double shear_viscosity, bulk_viscosity;
};

/// A standard linear solid with G1 = G2 = shear, K1 = K2 = bulk and one relaxation time, > 0. theta2 decays
/// `theta2_rate_factor` times as fast as theta1. (thesis AIII.10, AIII.11)
struct SingleRelaxationTimeSolid {
  double bulk, shear;
  double relaxation_time;
  int theta2_rate_factor;
};

/// G = Q/P and K = Q'/P' with polynomials in d/dt, the coefficient of p^0 first. For short times theta1 = P/(2Q) and
/// theta2 = 3/(6Q'/P' + 2Q/P) must have finite limits, > 0, or 0 as for Kelvin-Voigt. Common factors are cancelled,
/// repeated roots refused, complex rates allowed. (thesis 6.14-6.17)
struct DifferentialOperators {
  std::vector<double> p, q;                        ///< in shear: P, Q
  std::vector<double> p_dilatation, q_dilatation;  ///< P', Q'
};

/// theta(t) = instantaneous delta(t) + sum amplitude e^(-rate t), in 1/stress, 1/(stress time) and 1/time. The lists
/// have equal lengths and are not empty. (thesis 6.16, 6.17)
struct PronyList {
  double instantaneous;
  std::vector<double> amplitudes, rates;
};
struct PronySeries {
  PronyList theta1, theta2;
};

/// The springs and dashpots of a modulus of a linear viscoelastic solid, in shear or in dilatation. A modulus has at
/// most one relaxation time. (thesis 6.12-6.15, AIII.1-AIII.8)
enum class SpringModel {
  elastic,          ///< a spring
  standard_linear,  ///< a spring in series with a second spring and a dashpot side by side
  kelvin_voigt,     ///< a spring and a dashpot side by side: no instantaneous deformation
  maxwell           ///< a spring and a dashpot in series: flows for ever under a constant stress
};

/// The constants from which the functions of a material were computed and rounded; std::monostate: none.
using MaterialConstants = std::variant<std::monostate, ElasticMaterial, StandardLinearSolid,
                                       SingleRelaxationTimeSolid, DifferentialOperators>;

/// A term amplitude e^(-rate t). Complex terms come in conjugate pairs, both listed.
struct RelaxationTerm {
  std::complex<double> amplitude;  ///< 1/(stress time)
  std::complex<double> rate;       ///< real part > 0, or 0 for a material that flows for ever, 1/time
};

/// theta(t) = instantaneous delta(t) + sum_r amplitude_r e^(-rate_r t), t >= 0: the strain that a unit
/// impulse of stress leaves. (thesis 6.16, 6.17)
struct MaterialFunction {
  double instantaneous;               ///< gamma_0, 1/stress: instantaneous compliance; 0 for Kelvin-Voigt
  std::vector<RelaxationTerm> terms;  ///< no two of equal rate; empty for an elastic material

  /// The transform gamma_0 + sum_r amplitude_r/(p + rate_r), 1/stress; p, 1/time, must not be the negative of a rate.
  [[nodiscard]] std::complex<double> transform(std::complex<double> p) const;
  /// Whether the material flows for ever: one of its rates is 0.
  [[nodiscard]] bool is_fluid() const;
  /// The compliance after a long time, transform(0), 1/stress; undefined for a fluid.
  [[nodiscard]] double long_time() const { return transform(0).real(); }
};

/// The error for constants that describe no material. The check of the functions and the search for roots throw it.
class NoMaterial : public BadInput {
 public:
  using BadInput::BadInput;
  /// The key of the argument in the table [material] of a scene.
  [[nodiscard]] std::string key() const;
};

/// The two compliances of an isotropic material in plane strain as functions of time.
struct MaterialFunctions {
  MaterialFunction theta1;  ///< 1/(2G) as an operator
  MaterialFunction theta2;  ///< 3/(6K + 2G) as an operator

  /// Throws NoMaterial unless both functions are well formed and the material is physical. Well formed: finite,
  /// complete conjugate pairs, no rate twice, each rate 0 or with a positive real part. Physical: instantaneous
  /// compliances >= 0, long-time compliances > 0, and no gain of energy at any frequency, in shear and in dilatation.
  void check() const;
  /// N = theta1 + theta2, the compliance of the normal displacement under a normal load. Terms of equal rate are
  /// joined.
  [[nodiscard]] MaterialFunction normal_compliance() const;
};

/// An isotropic linear viscoelastic material in plane strain, with the constants that described it. It is immutable.
class ViscoelasticMaterial {
 public:
  /// Checks the functions by MaterialFunctions::check(). `constants`: those from which the functions were computed.
  ViscoelasticMaterial(MaterialFunction theta1, MaterialFunction theta2, MaterialConstants constants = {});
  // The rates of these two are roots of polynomials. Only the constants are checked here; the path that finds the roots
  // checks the functions.
  explicit ViscoelasticMaterial(const StandardLinearSolid& solid);
  explicit ViscoelasticMaterial(DifferentialOperators operators);

  /// Empty if the rates are roots of polynomials.
  [[nodiscard]] const std::optional<MaterialFunctions>& functions() const { return functions_; }
  [[nodiscard]] const MaterialConstants& constants() const { return constants_; }
  /// Whether theta1 has an instantaneous part.
  [[nodiscard]] bool gives_way_at_once() const;

 private:
  std::optional<MaterialFunctions> functions_;
  MaterialConstants constants_;
};

// Functions that make viscoelastic materials. Each throws BadInput for values outside their domain and for constants
// that describe no material, and names the argument like the key in a scene's [material].

/// A material without relaxation.
[[nodiscard]] ViscoelasticMaterial elastic_solid(const ElasticMaterial& material);

[[nodiscard]] ViscoelasticMaterial standard_linear_solid(const StandardLinearSolid& solid);

/// A SingleRelaxationTimeSolid: its long-time compliance is twice its instantaneous one. (thesis AIII.10, AIII.11)
[[nodiscard]] ViscoelasticMaterial single_relaxation_time_solid(double bulk, double shear,
                                                                double relaxation_time,
                                                                int theta2_rate_factor = 1);

/// The theta2_rate_factor of the thesis's own result for that solid, which is wrong: it has e^(-2t/tau) in place of
/// e^(-t/tau), the residue of one root with the rate of the other. The thesis's tables were computed with this result.
/// The material is physical nevertheless. (thesis AIII.15)
inline constexpr int misprinted_rate_factor = 2;

/// G/K of the thesis's solid, exactly: Poisson's ratio is 1/3. (thesis AIII.12)
inline constexpr double thesis_shear_over_bulk = 3.0 / 8;

/// The instantaneous compliances of a solid, 1/(2G) and 3/(6K + 2G): > 0 and finite, 1/stress.
struct Compliances {
  double theta1, theta2;
};

/// The same solid, given by its instantaneous compliances instead of its moduli.
[[nodiscard]] ViscoelasticMaterial single_relaxation_time_solid(const Compliances& at_once,
                                                                double relaxation_time,
                                                                int theta2_rate_factor = 1);

[[nodiscard]] ViscoelasticMaterial prony_solid(const PronyList& theta1, const PronyList& theta2);

[[nodiscard]] ViscoelasticMaterial operator_solid(const DifferentialOperators& operators);

}  // namespace nipref::data
