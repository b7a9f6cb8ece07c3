#include <nipref/data/magnitude.hpp>
#include <nipref/data/problem/elastic_nip.hpp>

namespace nipref::data {

void ElasticNip::check() const {
  check_magnitude("roller_radius", roller_radius);
  check_magnitude("sheet_thickness", sheet_thickness);
  material.check();
}

}  // namespace nipref::data
