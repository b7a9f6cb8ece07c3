#pragma once
#include <complex>
#include <vector>

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

/// Isotropic linear viscoelastic material in plane strain. There is none that is not physical: it is looked
/// at over all frequencies once, when it is made, and never changes.
class ViscoelasticMaterial {
 public:
  /// Throws BadInput unless both functions are well formed (finite, conjugate pairs complete, no rate twice,
  /// real parts of the rates positive, or the rate 0) and the material physical: compliances not below 0 at
  /// once and positive after a long time, and in shear and in dilatation no gain of energy at any frequency.
  /// `constants`: what they were rounded from.
  ViscoelasticMaterial(MaterialFunction theta1, MaterialFunction theta2, MaterialConstants constants = {});

  /// 1/(2G) as an operator.
  [[nodiscard]] const MaterialFunction& theta1() const { return theta1_; }
  /// 3/(6K + 2G) as an operator.
  [[nodiscard]] const MaterialFunction& theta2() const { return theta2_; }

  /// N = theta1 + theta2, what acts in the normal displacement under a normal load; terms of equal rate
  /// joined.
  [[nodiscard]] MaterialFunction normal_compliance() const;

  /// For those who need them without the rounding of the functions.
  [[nodiscard]] const MaterialConstants& constants() const { return constants_; }

 private:
  MaterialFunction theta1_, theta2_;
  MaterialConstants constants_;
};

}  // namespace nipref::data
