#include "fast/contact_converged.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "data/bad_input.hpp"
#include "fast/contact_functionals.hpp"
#include "fast/contact_ladder.hpp"

namespace nipref::fast {
namespace {

using data::BadInput;

constexpr double shortest = 1e-8;  // L/B
constexpr double longest = 1e4;

/// Units of HalfContact's dimensionless quantities.
struct Units {
  explicit Units(const data::ElasticNip& nip)
      : length(nip.half_thickness()),
        displacement(length / (2 * nip.roller_radius) * length),
        pressure(length / (2 * nip.roller_radius) / nip.material.normal_compliance()),
        load(pressure * length),
        creep(length / (2 * nip.roller_radius)) {}
  double length;
  double displacement;
  double pressure;
  double load;
  double creep;
};

void check_accuracy(double accuracy) {
  if (!(accuracy >= 1e-13 && accuracy <= 0.1))
    throw BadInput("accuracy", accuracy, "must be from 1e-13 to 0.1");
}

double checked_position(double y) {
  if (!std::isfinite(y)) throw BadInput("y", y, "must be finite");
  return std::fabs(y);
}

std::string allowed_length(const data::ElasticNip& nip) {
  return fmt::format(
      "must be from {:g} to {:g}: 1e-8 to 1e4 sheet thicknesses and at most the roller's radius, beyond "
      "which a parabola no longer stands for the roller",
      shortest * nip.sheet_thickness, std::min(longest * nip.sheet_thickness, nip.roller_radius));
}

bool length_is_allowed(const data::ElasticNip& nip, double contact_length) {
  return contact_length >= shortest * nip.sheet_thickness &&
         contact_length <= longest * nip.sheet_thickness && contact_length <= nip.roller_radius;
}

Estimate times(double unit, const Estimate& estimate) {
  return {unit * estimate.value + 0.0, std::fabs(unit) * estimate.error};  // no -0
}

}  // namespace

struct ConvergedContact::Implementation {
  Implementation(const data::ElasticNip& nip, data::Friction friction, ContactLadder solved)
      : units(nip),
        surface{friction, nip.material.theta2() / nip.material.normal_compliance(), solved.tolerance()},
        ladder(std::move(solved)) {}

  Units units;
  SurfaceDisplacements surface;
  ContactLadder ladder;

  [[nodiscard]] double half_length() const { return ladder.last().half_length; }
  [[nodiscard]] Estimate traction_at(double y, double Traction::*component, double scale) const {
    const double position = checked_position(y) / units.length;
    const Estimate estimate = ladder.estimate(
        [&](const HalfContact& contact) {
          const double e = contact.half_length - position;
          return e > 0 ? contact.traction(e).*component : 0;
        },
        position < half_length() ? scale : 0);
    return times(std::copysign(units.pressure, component == &Traction::shear ? y : 1), estimate);
  }
};

ConvergedContact::ConvergedContact(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
ConvergedContact::ConvergedContact(ConvergedContact&&) noexcept = default;
ConvergedContact::~ConvergedContact() = default;

Estimate ConvergedContact::contact_length() const {
  const auto& [units, surface, ladder] = *implementation_;
  return times(2 * units.length,
               ladder.estimate([](const HalfContact& contact) { return contact.half_length; }));
}

Estimate ConvergedContact::load() const {
  const auto& [units, surface, ladder] = *implementation_;
  return times(units.load, ladder.estimate([](const HalfContact& contact) { return contact.load; }));
}

Estimate ConvergedContact::indentation() const {
  const auto& [units, surface, ladder] = *implementation_;
  return times(units.displacement, ladder.estimate([](const HalfContact& contact) {
    return contact.edge_displacement + contact.half_length * contact.half_length;
  }));
}

Estimate ConvergedContact::edge_displacement() const {
  const auto& [units, surface, ladder] = *implementation_;
  const double parabola = std::pow(implementation_->half_length(), 2);
  return times(
      units.displacement,
      ladder.estimate([](const HalfContact& contact) { return contact.edge_displacement; }, parabola));
}

Estimate ConvergedContact::creep_ratio() const {
  const auto& [units, surface, ladder] = *implementation_;
  const double size = implementation_->half_length();
  if (surface.friction == data::Friction::full) {
    return times(units.creep,
                 ladder.estimate([](const HalfContact& contact) { return contact.creep; }, size));
  }
  ContactKernels kernels = ladder.kernels();
  const auto stretch = [&](const HalfContact& contact) {
    const double end = contact.half_length;
    return fast::tangential_displacement(contact, end, surface, kernels) / end;
  };
  return times(units.creep, ladder.estimate(stretch, size));
}

Estimate ConvergedContact::pressure(double y) const {
  const Estimate middle = implementation_->traction_at(0, &Traction::pressure, 0);
  return implementation_->traction_at(y, &Traction::pressure, middle.value / implementation_->units.pressure);
}

Estimate ConvergedContact::shear(double y) const {
  if (implementation_->surface.friction == data::Friction::none) {
    checked_position(y);
    return {0, 0};
  }
  const double scale = fast::peak_shear(implementation_->ladder.last());
  return implementation_->traction_at(y, &Traction::shear, scale);
}

Estimate ConvergedContact::peak_pressure() const {
  const auto& [units, surface, ladder] = *implementation_;
  return times(units.pressure, ladder.estimate(fast::peak_pressure));
}

Estimate ConvergedContact::peak_shear() const {
  const auto& [units, surface, ladder] = *implementation_;
  if (surface.friction == data::Friction::none) return {0, 0};
  return times(units.pressure, ladder.estimate(fast::peak_shear));
}

Estimate ConvergedContact::normal_displacement(double y) const {
  const auto& [units, surface, ladder] = *implementation_;
  const double position = checked_position(y) / units.length;
  ContactKernels kernels = ladder.kernels();
  const auto displacement = [&](const HalfContact& contact) {
    return fast::normal_displacement(contact, position, surface, kernels);
  };
  return times(units.displacement,
               ladder.estimate(displacement, std::pow(implementation_->half_length(), 2)));
}

Estimate ConvergedContact::tangential_displacement(double y) const {
  const auto& [units, surface, ladder] = *implementation_;
  const double position = checked_position(y) / units.length;
  ContactKernels kernels = ladder.kernels();
  const auto displacement = [&](const HalfContact& contact) {
    return fast::tangential_displacement(contact, position, surface, kernels);
  };
  const double scale = implementation_->half_length() * std::min(position, implementation_->half_length());
  return times(std::copysign(units.creep * units.length, y), ladder.estimate(displacement, scale));
}

ContactWork ConvergedContact::work() const { return implementation_->ladder.work(); }

ConvergedContact converged_for_length(const data::ElasticNip& nip, data::Friction friction,
                                      double contact_length, double accuracy) {
  nip.check();
  check_accuracy(accuracy);
  if (!length_is_allowed(nip, contact_length)) {
    throw BadInput("contact_length", contact_length, allowed_length(nip));
  }
  return ConvergedContact(std::make_unique<ConvergedContact::Implementation>(
      nip, friction,
      ContactLadder::at_half_length(contact_length / nip.sheet_thickness, friction, nip.material.poisson,
                                    accuracy)));
}

ConvergedContact converged_for_load(const data::ElasticNip& nip, data::Friction friction, double load,
                                    double accuracy) {
  nip.check();
  check_accuracy(accuracy);
  if (!(std::isfinite(load) && load > 0)) throw BadInput("load", load, "must be finite and > 0");
  auto solved = std::make_unique<ConvergedContact::Implementation>(
      nip, friction,
      ContactLadder::at_load(load / Units(nip).load, friction, nip.material.poisson, accuracy));
  const double contact_length = solved->half_length() * nip.sheet_thickness;
  if (!length_is_allowed(nip, contact_length)) {
    throw BadInput("load", load,
                   fmt::format("must give an allowed contact length, not {:g}; {}", contact_length,
                               allowed_length(nip)));
  }
  return ConvergedContact(std::move(solved));
}

}  // namespace nipref::fast
