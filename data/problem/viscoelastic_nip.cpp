#include <cmath>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/problem/viscoelastic_nip.hpp>

namespace nipref::data {

void ViscoelasticNip::check() const {
  const auto check_positive = [](const char* name, double value) {
    if (!(std::isfinite(value) && value > 0)) throw BadInput(name, value, "must be finite and > 0");
  };
  check_positive("roller_radius", roller_radius);
  check_positive("sheet_thickness", sheet_thickness);
  check_positive("speed", speed);
}

}  // namespace nipref::data
