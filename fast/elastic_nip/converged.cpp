#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/elastic_nip/internal/elastic_equations.hpp>

namespace nipref::fast {
namespace {

ConvergedNip converged(const data::ElasticNip& nip, data::Friction friction, const GivenContact& given,
                       double accuracy) {
  nip.check();
  return converged_nip({nip.roller_radius, nip.sheet_thickness}, nip.material.normal_compliance(),
                       std::make_shared<const ElasticEquations>(friction, nip.material.poisson), given,
                       accuracy);
}

}  // namespace

ConvergedNip converged_for_length(const data::ElasticNip& nip, data::Friction friction, double contact_length,
                                  double accuracy) {
  return converged(nip, friction, {.length = contact_length}, accuracy);
}

ConvergedNip converged_for_load(const data::ElasticNip& nip, data::Friction friction, double load,
                                double accuracy) {
  return converged(nip, friction, {.load = load}, accuracy);
}

}  // namespace nipref::fast
