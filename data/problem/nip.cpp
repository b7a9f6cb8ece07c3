#include <nipref/data/internal/common.hpp>
#include <nipref/data/problem/nip.hpp>

namespace nipref::data {

namespace {

/// Throws if N = theta1 + theta2 has no instantaneous part, as such a sheet cannot be rolled. For one term of memory,
/// u' = amplitude I1 * p - rate u. In the contact u is the parabola of the roller, and this equation determines p up to
/// two constants, the place of the roller. Two constants cannot meet three conditions: no inverse root of the pressure
/// at either end, and a surface that is not torn at the leading end. With an inverse root at the leading end the gap
/// ahead of it can open, like a power 3/2; with one at the trailing end roller and sheet would overlap behind it. Only
/// theta2 may lack an instantaneous part alone: if theta1 alone lacked it, the material would gain energy.
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
