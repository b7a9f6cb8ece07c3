#include <nipref/fast/material/functions.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/internal/rolling_equations.hpp>

namespace nipref::fast {
namespace {

/// A relaxation length, half-thicknesses. A memory with a longer one adds nothing: it is at most 1e120 of the
/// compliance over that length. A memory of rate 0, which flows for ever, has no relaxation length.
constexpr double too_long = 1e150;

RollingSheet rolling_sheet(const data::ViscoelasticNip& nip, const data::MaterialFunctions& functions) {
  const double way_per_time = nip.speed / nip.half_thickness();
  const data::MaterialFunction normal = functions.normal_compliance();
  const auto memories = [&](const data::MaterialFunction& function) {
    std::vector<Memory> result;
    for (const data::RelaxationTerm& term : function.terms) {
      if (term.rate != 0.0 && !(way_per_time < too_long * std::abs(term.rate))) continue;
      result.push_back(
          {term.amplitude / (way_per_time * normal.instantaneous), 0.0 + term.rate / way_per_time});  // no -0
    }
    return result;
  };
  return {rolling_compliance(memories(normal)), functions.theta2.instantaneous / normal.instantaneous,
          memories(functions.theta2)};
}

ConvergedNip converged(const data::ViscoelasticNip& nip, const GivenContact& given, double accuracy) {
  nip.check();
  const data::MaterialFunctions functions = material_functions(nip.material);
  return converged_nip({nip.roller_radius, nip.sheet_thickness}, functions.normal_compliance().instantaneous,
                       std::make_shared<const RollingEquations>(rolling_sheet(nip, functions)), given,
                       accuracy);
}

}  // namespace

ConvergedNip converged_for_length(const data::ViscoelasticNip& nip, double contact_length, double accuracy) {
  return converged(nip, {.length = contact_length}, accuracy);
}

ConvergedNip converged_for_load(const data::ViscoelasticNip& nip, double load, double accuracy) {
  return converged(nip, {.load = load}, accuracy);
}

}  // namespace nipref::fast
