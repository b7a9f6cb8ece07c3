#include <fmt/format.h>

#include <cmath>

#include <nipref/data/material/seed_solids.hpp>
#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/fast/memory/moving_load.hpp>
#include <nipref/fast/memory/plain_moving_load.hpp>
#include <nipref/verify/figures/internal/drawings.hpp>

// The thesis's viscoelastic solid, and its sheet under one moving load. (thesis chapter VI, Appendix III)

namespace nipref::verify {
namespace {

constexpr double stated_bulk = data::seed::sheet.young,
                 stated_shear = data::thesis_shear_over_bulk * stated_bulk;
constexpr double half_thickness = 0.0025, load_speed = 1;
constexpr int residue_sums = 500;

/// Strain under a stress that is put on at t = 0 and stays, over its strain at once.
double creep_response(const data::MaterialFunction& theta, double t) {
  double compliance = theta.instantaneous;
  for (const data::RelaxationTerm& term : theta.terms)
    compliance -= (term.amplitude / term.rate * std::expm1(-term.rate.real() * t)).real();
  return compliance / theta.instantaneous;
}

std::vector<Panel> creep_responses(const FigureSubject& subject) {
  const auto defined = *data::single_relaxation_time_solid(stated_bulk, stated_shear, 1).functions();
  const auto printed = *data::misprinted_thesis_solid(stated_bulk, stated_shear, 1).functions();
  const auto response = [&](const std::string& label, const std::string& role, Mark mark,
                            const data::MaterialFunction& theta) {
    return sampled(label, role, mark, subject.numbers("t"),
                   [&](double at) { return creep_response(theta, at); });
  };
  const std::string right = "solid as defined", wrong = "solid as printed (6.29)";
  return {{{"time over the relaxation time t/tau"},
           {"strain over the strain at once"},
           {response("theta1 = 1/(2G)", right, Mark::line, defined.theta1),
            response("theta2 = 3/(6K + 2G)", right, Mark::line, defined.theta2),
            response("theta1 + theta2", right, Mark::line, defined.normal_compliance()),
            response("theta2 = 3/(6K + 2G)", wrong, Mark::marked_line, printed.theta2),
            response("theta1 + theta2", wrong, Mark::marked_line, printed.normal_compliance())}}};
}

/// The point and, for the tangential displacement, the pinned point lie so many half-thicknesses ahead of the load's start.
std::vector<Panel> under_moving_load(const FigureSubject& subject) {
  const bool is_normal = subject.text == "Un";
  const double point = subject.number("T"), pinned = is_normal ? 0 : subject.number("t0");
  Panel panel{{"way of the load since its start F0 t/b"}, {subject.text + ", 1/psi"}, {}};
  for (const double memory : subject.numbers("memory")) {
    const std::string label = fmt::format("F0 tau = {:g} in", memory);
    const fast::MovingLoad load(data::single_relaxation_time_solid(stated_bulk, stated_shear, memory),
                                load_speed, half_thickness);
    const fast::PlainMovingLoad by_sums(data::misprinted_thesis_solid(stated_bulk, stated_shear, memory),
                                        load_speed, half_thickness, residue_sums);
    const auto displacement = [&](const auto& of_load, double t, double unit) {
      return is_normal ? of_load.normal_displacement(t * unit, point * unit)
                       : of_load.tangential_displacement(t * unit, point * unit, pinned * unit);
    };
    panel.series.push_back(sampled(label, "exact, solid as defined", Mark::line, subject.numbers("t"),
                                   [&](double t) { return displacement(load, t, half_thickness); }));
    panel.series.push_back(sampled(label, "500 residues, solid as printed", Mark::points,
                                   subject.numbers("sparse"),
                                   [&](double t) { return displacement(by_sums, t, 1); }));
  }
  return {panel};
}

}  // namespace

Drawings moving_load_drawings() {
  return {{"creep of the solid", creep_responses}, {"moving load", under_moving_load}};
}

}  // namespace nipref::verify
