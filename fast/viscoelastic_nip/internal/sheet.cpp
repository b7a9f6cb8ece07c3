#include <nipref/fast/material/functions.hpp>
#include <nipref/fast/viscoelastic_nip/internal/sheet.hpp>

namespace nipref::fast {
namespace {

std::variant<MovingLoad, PlainMovingLoad> moving_load(const data::ViscoelasticNip& nip, int residue_terms,
                                                      double smallest_term) {
  if (residue_terms == 0) return MovingLoad(nip.material, nip.speed, nip.half_thickness());
  return PlainMovingLoad(nip.material, nip.speed, nip.half_thickness(), residue_terms, smallest_term);
}

}  // namespace

ViscoelasticSheet::ViscoelasticSheet(const data::ViscoelasticNip& nip, int residue_terms,
                                     double smallest_term)
    : compliance_(material_functions(nip.material).normal_compliance().instantaneous),
      time_(residue_terms == 0 ? nip.half_thickness() / nip.speed : 1),
      load_(moving_load(nip, residue_terms, smallest_term)) {}

double ViscoelasticSheet::normal_displacement(double t, double T) const {
  return std::visit([&](const auto& load) { return load.normal_displacement(t * time_, T * time_); }, load_);
}

double ViscoelasticSheet::tangential_displacement(double t, double T, double t0) const {
  return std::visit(
      [&](const auto& load) { return load.tangential_displacement(t * time_, T * time_, t0 * time_); },
      load_);
}

}  // namespace nipref::fast
