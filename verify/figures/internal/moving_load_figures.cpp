#include <fmt/format.h>

#include <cmath>

#include <nipref/data/material/seed_solids.hpp>
#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/fast/memory/moving_load.hpp>
#include <nipref/fast/memory/plain_moving_load.hpp>
#include <nipref/verify/figures/internal/groups.hpp>
#include <nipref/verify/figures/internal/series.hpp>

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

std::vector<Panel> creep_responses() {
  const auto defined = *data::single_relaxation_time_solid(stated_bulk, stated_shear, 1).functions();
  const auto printed = *data::misprinted_thesis_solid(stated_bulk, stated_shear, 1).functions();
  const std::vector<double> t = evenly(0, 6, 121);
  const auto response = [&](const std::string& label, const std::string& role, Mark mark,
                            const data::MaterialFunction& theta) {
    return sampled(label, role, mark, t, [&](double at) { return creep_response(theta, at); });
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

/// Where the point and the pinned point lie ahead of the load's start, in half-thicknesses: T and t0 in b/F0.
struct Places {
  double point, pinned;
};

using Displacement = double (*)(const fast::MovingLoad&, double t, const Places&);
using PlainDisplacement = double (*)(const fast::PlainMovingLoad&, double t, const Places&);

double exact_normal(const fast::MovingLoad& load, double t, const Places& places) {
  return load.normal_displacement(t * half_thickness, places.point * half_thickness);
}
double exact_tangential(const fast::MovingLoad& load, double t, const Places& places) {
  return load.tangential_displacement(t * half_thickness, places.point * half_thickness,
                                      places.pinned * half_thickness);
}
double plain_normal(const fast::PlainMovingLoad& load, double t, const Places& places) {
  return load.normal_displacement(t, places.point);
}
double plain_tangential(const fast::PlainMovingLoad& load, double t, const Places& places) {
  return load.tangential_displacement(t, places.point, places.pinned);
}

Panel under_moving_load(const std::string& axis, const Places& places, Displacement exact,
                        PlainDisplacement plain) {
  const std::vector<double> way = without(evenly(0, 12, 241), {places.point});
  const std::vector<double> sparse = evenly(0.25, 11.75, 12);
  Panel panel{{"way of the load since its start F0 t/b"}, {axis}, {}};
  for (int decade = 2; decade >= -5; --decade) {
    const double memory = std::pow(10, decade);
    const std::string label = fmt::format("F0 tau = {:g} in", memory);
    const fast::MovingLoad load(data::single_relaxation_time_solid(stated_bulk, stated_shear, memory),
                                load_speed, half_thickness);
    const fast::PlainMovingLoad by_sums(data::misprinted_thesis_solid(stated_bulk, stated_shear, memory),
                                        load_speed, half_thickness, residue_sums);
    panel.series.push_back(sampled(label, "exact, solid as defined", Mark::line, way,
                                   [&](double t) { return exact(load, t, places); }));
    panel.series.push_back(sampled(label, "500 residues, solid as printed", Mark::points, sparse,
                                   [&](double t) { return plain(by_sums, t, places); }));
  }
  return panel;
}

constexpr double behind = -0.5, ahead = 4, pin_behind = -2, pin_ahead = 6;

FigurePlan normal_figure(int number, double point, const std::string& sign) {
  return {fmt::format("thesis-{}", number),
          "Normal displacement by a moving load on a viscoelastic sheet, T " + sign,
          fmt::format("B = 0.005 in, K0 = 1.45e5 psi, G0 = 3K0/8, F0 T/b = {:g}", point), [=] {
            return std::vector{under_moving_load("Un, 1/psi", {point, 0}, exact_normal, plain_normal)};
          }};
}

FigurePlan tangential_figure(int number, const Places& places, const std::string& signs,
                             const std::string& remark = "") {
  return {fmt::format("thesis-{}", number),
          "Tangential displacement by a moving load on a viscoelastic sheet, " + signs,
          fmt::format("B = 0.005 in, K0 = 1.45e5 psi, G0 = 3K0/8, F0 T/b = {:g}, F0 t0/b = {:g}",
                      places.point, places.pinned) +
              remark,
          [=] {
            return std::vector{under_moving_load("Vn, 1/psi", places, exact_tangential, plain_tangential)};
          }};
}

}  // namespace

/// The captions of 35 and 37 are the same, and so are those of 36 and 38, though the text says that the four cases are
/// shown: in the order of (6.23) to (6.28), 36 must be T < 0, t0 > 0 and 37 T > 0, t0 < 0.
std::vector<FigurePlan> moving_load_figures() {
  return {{"thesis-32", "Creep of the thesis's standard linear solid under a constant stress",
           "G1 = G2, K1 = K2, one relaxation time", creep_responses},
          normal_figure(33, ahead, "> 0"),
          normal_figure(34, behind, "< 0"),
          tangential_figure(35, {ahead, pin_ahead}, "case I: T > 0, t0 > 0"),
          tangential_figure(36, {behind, pin_ahead}, "case II: T < 0, t0 > 0",
                            "; its caption repeats that of case IV"),
          tangential_figure(37, {ahead, pin_behind}, "case III: T > 0, t0 < 0",
                            "; its caption repeats that of case I"),
          tangential_figure(38, {behind, pin_behind}, "case IV: T < 0, t0 < 0")};
}

}  // namespace nipref::verify
