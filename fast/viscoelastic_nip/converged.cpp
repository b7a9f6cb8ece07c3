#include <algorithm>
#include <cmath>
#include <utility>

#include <nipref/fast/nip/internal/domain.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/internal/functionals.hpp>
#include <nipref/fast/viscoelastic_nip/internal/levels.hpp>

namespace nipref::fast {
namespace {

NipShape shape(const data::ViscoelasticNip& nip) { return {nip.roller_radius, nip.sheet_thickness}; }

std::vector<MemoryTerm> memory_terms(const data::MaterialFunction& function, double way_per_time,
                                     double compliance) {
  std::vector<MemoryTerm> terms;
  for (const data::RelaxationTerm& term : function.terms)
    terms.push_back({term.amplitude / (way_per_time * compliance), term.rate / way_per_time});
  return terms;
}

ViscoelasticNipLevels levels(const data::ViscoelasticNip& nip) {
  const data::MaterialFunction normal = nip.material.normal_compliance();
  const double half_thicknesses_per_time = nip.speed / nip.half_thickness();
  const double compliance = normal.instantaneous;
  return ViscoelasticNipLevels({memory_terms(normal, half_thicknesses_per_time, compliance),
                                nip.material.theta2().instantaneous / compliance,
                                memory_terms(nip.material.theta2(), half_thicknesses_per_time, compliance)});
}

ContactUnits units_of(const data::ViscoelasticNip& nip) {
  return {shape(nip), nip.material.normal_compliance().instantaneous};
}

}  // namespace

struct ConvergedViscoelasticNip::Implementation {
  Implementation(const data::ViscoelasticNip& nip, ViscoelasticNipLadder solved)
      : units(units_of(nip)), roller_radius(nip.roller_radius), ladder(std::move(solved)) {}

  ContactUnits units;
  double roller_radius;
  ViscoelasticNipLadder ladder;

  [[nodiscard]] double half_length() const { return ladder.last().half_length(); }
  /// Dimensionless Y.
  [[nodiscard]] double position(double y) const {
    check_position(y);
    return y / units.length;
  }
};

ConvergedViscoelasticNip::ConvergedViscoelasticNip(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
ConvergedViscoelasticNip::ConvergedViscoelasticNip(ConvergedViscoelasticNip&&) noexcept = default;
ConvergedViscoelasticNip::~ConvergedViscoelasticNip() = default;

Estimate ConvergedViscoelasticNip::contact_length() const {
  const auto& [units, radius, ladder] = *implementation_;
  return times(2 * units.length, ladder.estimate(std::mem_fn(&ViscoelasticPressure::half_length)));
}

Estimate ConvergedViscoelasticNip::leading_length() const {
  const auto& [units, radius, ladder] = *implementation_;
  return times(units.length, ladder.estimate(std::mem_fn(&ViscoelasticPressure::leading_length),
                                             implementation_->half_length()));
}

Estimate ConvergedViscoelasticNip::trailing_length() const {
  const auto& [units, radius, ladder] = *implementation_;
  return times(units.length, ladder.estimate(std::mem_fn(&ViscoelasticPressure::trailing_length),
                                             implementation_->half_length()));
}

Estimate ConvergedViscoelasticNip::load() const {
  const auto& [units, radius, ladder] = *implementation_;
  return times(units.load, ladder.estimate(std::mem_fn(&ViscoelasticPressure::load)));
}

Estimate ConvergedViscoelasticNip::indentation() const {
  const auto& [units, radius, ladder] = *implementation_;
  return times(units.displacement, ladder.estimate(fast::indentation));
}

Estimate ConvergedViscoelasticNip::leading_displacement() const {
  const auto& [units, radius, ladder] = *implementation_;
  return times(units.displacement, ladder.estimate(std::mem_fn(&ViscoelasticPressure::edge_displacement),
                                                   std::pow(implementation_->half_length(), 2)));
}

Estimate ConvergedViscoelasticNip::trailing_displacement() const {
  const auto& [units, radius, ladder] = *implementation_;
  return times(units.displacement,
               ladder.estimate(fast::trailing_displacement, std::pow(implementation_->half_length(), 2)));
}

Estimate ConvergedViscoelasticNip::pressure(double y) const {
  const auto& [units, radius, ladder] = *implementation_;
  const double position = implementation_->position(y);
  const auto at = [&](const ViscoelasticPressure& contact) {
    const ContactPlace place = contact.place(position);
    return place.e > 0 ? contact.pressure(place) : 0;
  };
  const bool inside = ladder.last().place(position).e > 0;
  const double middle = ladder.last().pressure({Half::leading, implementation_->half_length()});
  return times(units.pressure, ladder.estimate(at, inside ? middle : 0));
}

Estimate ConvergedViscoelasticNip::peak_pressure() const {
  const auto& [units, radius, ladder] = *implementation_;
  return times(units.pressure, ladder.estimate(fast::peak_pressure));
}

Estimate ConvergedViscoelasticNip::rolling_resistance() const {
  const auto& [units, radius, ladder] = *implementation_;
  return times(units.length / radius, ladder.estimate_down_to_rounding(fast::eccentricity));
}

Estimate ConvergedViscoelasticNip::creep_ratio() const {
  const auto& [units, radius, ladder] = *implementation_;
  CountedKernels kernels = ladder.kernels();
  const auto stretch = [&](const ViscoelasticPressure& contact) {
    const double change =
        contact.tangential_displacement({Half::leading, 0}, {Half::trailing, 0}, ladder.tolerance(), kernels);
    return change / (2 * contact.half_length());
  };
  return times(units.creep, ladder.estimate(stretch, implementation_->half_length()));
}

Estimate ConvergedViscoelasticNip::normal_displacement(double y) const {
  const auto& [units, radius, ladder] = *implementation_;
  const double position = implementation_->position(y);
  CountedKernels kernels = ladder.kernels();
  const auto displacement = [&](const ViscoelasticPressure& contact) {
    return contact.normal_displacement(contact.place(position), ladder.tolerance(), kernels);
  };
  return times(units.displacement,
               ladder.estimate(displacement, std::pow(implementation_->half_length(), 2)));
}

Estimate ConvergedViscoelasticNip::tangential_displacement(double y) const {
  const auto& [units, radius, ladder] = *implementation_;
  const double position = implementation_->position(y);
  if (position == 0) return {0, 0};
  CountedKernels kernels = ladder.kernels();
  const auto displacement = [&](const ViscoelasticPressure& contact) {
    return contact.tangential_displacement(contact.place(position), contact.place(0), ladder.tolerance(),
                                           kernels);
  };
  const double half_length = implementation_->half_length();
  return times(units.creep * units.length,
               ladder.estimate(displacement, half_length * std::min(std::fabs(position), half_length)));
}

Work ConvergedViscoelasticNip::work() const { return implementation_->ladder.work(); }

ConvergedViscoelasticNip converged_for_length(const data::ViscoelasticNip& nip, double contact_length,
                                              double accuracy) {
  nip.check();
  check_contact_accuracy(accuracy);
  check_contact_length(shape(nip), contact_length);
  return ConvergedViscoelasticNip(std::make_unique<ConvergedViscoelasticNip::Implementation>(
      nip,
      ViscoelasticNipLadder::at_half_length(levels(nip), contact_length / nip.sheet_thickness, accuracy)));
}

ConvergedViscoelasticNip converged_for_load(const data::ViscoelasticNip& nip, double load, double accuracy) {
  nip.check();
  check_contact_accuracy(accuracy);
  check_contact_load(load);
  auto solved = std::make_unique<ConvergedViscoelasticNip::Implementation>(
      nip, ViscoelasticNipLadder::at_load(levels(nip), load / units_of(nip).load, accuracy));
  check_length_of_load(shape(nip), load, solved->half_length() * nip.sheet_thickness);
  return ConvergedViscoelasticNip(std::move(solved));
}

}  // namespace nipref::fast
