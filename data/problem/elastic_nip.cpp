#include <cmath>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/problem/elastic_nip.hpp>

namespace nipref::data {

void ElasticNip::check() const {
  if (!(std::isfinite(roller_radius) && roller_radius > 0)) {
    throw BadInput("roller_radius", roller_radius, "must be finite and > 0");
  }
  if (!(std::isfinite(sheet_thickness) && sheet_thickness > 0)) {
    throw BadInput("sheet_thickness", sheet_thickness, "must be finite and > 0");
  }
  material.check();
}

}  // namespace nipref::data
