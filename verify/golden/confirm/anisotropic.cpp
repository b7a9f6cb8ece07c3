#include <algorithm>
#include <numbers>

#include <nipref/fast/half_space/anisotropic.hpp>
#include <nipref/verify/golden/confirm/half_space_number.hpp>
#include <nipref/verify/golden/confirm/stroh.hpp>

namespace nipref::verify::confirm {
namespace {

/// The solid of the upper triangle of Voigt's matrix row by row, which begins with c11.
template <unsigned digits>
StrohSolid<digits> any_solid(Arguments x) {
  StrohSolid<digits> solid{{}, Number<digits>(x["density"])};
  auto modulus = x.from("c11").begin();
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = i; k < 6; ++k) solid.voigt[i][k] = solid.voigt[k][i] = *modulus++;
  return solid;
}

enum class Part { re, minus_im };

Confirm entry_of(std::size_t row, std::size_t column, Part part) {
  return [=](Arguments x) {
    using Float = Number<150>;
    const Float phase = Float(x["speed"]) * cosine_between<150>(x["psi_deg"], x["theta_deg"]);
    const auto y = any_solid<150>(x).admittance(x["psi_deg"], phase);
    const Wave value(part == Part::re ? Float(y[row][column].real()) : Float(-y[row][column].imag()));
    const Wave size = std::max<Wave>(abs(Wave(y[2][2].real())),
                                     std::max<Wave>(abs(Wave(y[0][0].real())), abs(Wave(y[1][1].real()))));
    return confirmation<Wave>("Stroh's eigenproblem", value, size * Wave("1e-80"));
  };
}

Confirmation critical_of_any(Arguments x) {
  const auto exact = any_solid<130>(x);
  data::Stiffness solid{{}, x["density"]};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = 0; k < 6; ++k) solid.voigt[i][k] = static_cast<double>(exact.voigt[i][k]);
  const auto near = fast::critical_speed(solid, fast::Direction::of_degrees(x["theta_deg"]));
  return lowest_surface_wave(exact, near.psi * 180 / std::numbers::pi, x["theta_deg"], near.speed);
}

}  // namespace

const Methods& anisotropic_methods() {
  static const Methods methods{{"anisotropic.compliance", entry_of(2, 2, Part::re)},
                               {"anisotropic.coupling", entry_of(2, 0, Part::minus_im)},
                               {"anisotropic.coupling_across", entry_of(2, 1, Part::minus_im)},
                               {"anisotropic.shear_compliance", entry_of(2, 0, Part::re)},
                               {"anisotropic.shear_compliance_across", entry_of(2, 1, Part::re)},
                               {"anisotropic.in_line", entry_of(0, 0, Part::re)},
                               {"anisotropic.across", entry_of(1, 1, Part::re)},
                               {"anisotropic.critical", critical_of_any}};
  return methods;
}

}  // namespace nipref::verify::confirm
