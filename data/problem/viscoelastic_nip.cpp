#include <nipref/data/magnitude.hpp>
#include <nipref/data/problem/viscoelastic_nip.hpp>

namespace nipref::data {

void ViscoelasticNip::check() const {
  check_magnitude("roller_radius", roller_radius);
  check_magnitude("sheet_thickness", sheet_thickness);
  check_magnitude("speed", speed);
}

}  // namespace nipref::data
