#pragma once
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/material/constants.hpp>

namespace nipref::data {

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

}  // namespace nipref::data
