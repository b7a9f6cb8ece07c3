#include <memory>

#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>
#include <nipref/verify/replay/internal/half_space.hpp>

namespace nipref::verify {

SphereOnHalfSpace::SphereOnHalfSpace(const data::Table& table) {
  const auto value = [&](const char* name) { return table.parameter(name).value; };
  const double c_d = value("c_D");
  const double mu0 = value("mu0");
  sphere = {mu0, (c_d * c_d - 2) / (2 * (c_d * c_d - 1)), value("rho0")};
  half_space = {value("C11"), value("C33"), value("C13"), value("C55"), value("C66"), value("rho")};
  scaled = scaled_moduli(half_space, sphere);
  scaled.sphere_dilatation = c_d;  // as printed
}

fast::SurfaceResponse SphereOnHalfSpace::in_contact(data::SymmetryAxis axis, fast::Direction motion,
                                                    double c0) const {
  const double speed = c0 * speed_unit();
  const auto surface =
      std::make_shared<const fast::TransverselyIsotropicHalfSpace>(half_space, axis, motion, speed);
  return [=, sphere = sphere](fast::Direction from_motion) -> fast::LineResponse {
    const fast::LineResponse lower = surface->along(from_motion.turned(motion));
    const fast::LineResponse upper = fast::isotropic_response(sphere, speed, from_motion);
    return fast::in_contact(lower, upper);
  };
}

}  // namespace nipref::verify
