#include <nipref/data/internal/common.hpp>
#include <nipref/data/problem/nip.hpp>

namespace nipref::data {

namespace {

/// What can be rolled. Where N gives way to nothing at once, u' = amplitude I1 * p - rate u of a memory: in the
/// contact, with u the parabola, that settles p but for the two freedoms of the roller's place, and these cannot
/// meet three wants, a pressure without inverse root at either end and a surface that is not torn at the leading
/// one. Ahead of an inverse root at the leading end the gap can open, like a power 3/2; behind one at the trailing
/// end roller and sheet would overlap. theta2 alone may give way to nothing at once; where theta1 does, theta2
/// does as well, or the material would gain energy.
void check_gives_way_at_once(const ViscoelasticMaterial& material) {
  if (!material.gives_way_at_once())
    throw BadInput("theta1 instantaneous", 0,
                   "must be > 0: under a roller a sheet that gives way to nothing at once has an infinite "
                   "pressure at the leading end of the contact");
}

}  // namespace

void ElasticNip::check() const {
  check_magnitude("roller_radius", roller_radius);
  check_magnitude("sheet_thickness", sheet_thickness);
  material.check();
}

void ViscoelasticNip::check() const {
  check_magnitude("roller_radius", roller_radius);
  check_magnitude("sheet_thickness", sheet_thickness);
  check_magnitude("speed", speed);
  check_gives_way_at_once(material);
}

}  // namespace nipref::data
