#pragma once

namespace nipref::data {

/// What a modulus of a linear viscoelastic solid, in shear or in dilatation, is made of. All relaxation times are one.
/// (thesis 6.12-6.15, AIII.1-AIII.8)
enum class SpringModel {
  elastic,          ///< a spring
  standard_linear,  ///< a spring in series with a second spring and a dashpot side by side
  kelvin_voigt,     ///< a spring and a dashpot side by side: nothing gives way at once
  maxwell           ///< a spring and a dashpot in series: nothing holds for ever
};

}  // namespace nipref::data
