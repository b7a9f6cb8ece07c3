#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include <nipref/data/material/seed_solids.hpp>
#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/fast/memory/moving_load.hpp>
#include <nipref/fast/memory/plain_moving_load.hpp>
#include <nipref/fast/sheet/displacements.hpp>
#include <nipref/fast/sheet/kernels.hpp>
#include <nipref/fast/sheet/plain_series.hpp>
#include <nipref/verify/figures/internal/drawings.hpp>

// Displacements of the sheet's surface under line loads (thesis chapter IV), the thesis's viscoelastic solid, and its sheet
// under one moving load (chapter VI, Appendix III).

namespace nipref::verify {
namespace {

constexpr data::ElasticMaterial stated = data::seed::sheet;
constexpr int residues =
    500;  // as in the thesis's viscoelastic tables; for the elastic ones it gives no number
const std::string true_kernel = "exact kernel", by_residues = "500 residues";

/// The thesis's residue sums at one distance.
struct PlainKernels {
  std::array<double, 1> I1{}, I3{}, I6_alpha_part{};

  explicit PlainKernels(double alpha) {
    const std::array place{alpha};
    fast::plain_series(place, residues, {I1, I3, I6_alpha_part});
  }
};

/// For alpha > 0.
double plain_us(double alpha) {
  return stated.theta2() / 2 - stated.normal_compliance() * PlainKernels(alpha).I3[0] / std::numbers::pi;
}

const FigureAxis distance_axis{"distance from the load alpha = y/b"};

/// A displacement as a function of alpha alone, and the thesis's sums for it.
struct KernelCurves {
  double (*exact)(double);
  double (*plain)(double);
};

const std::map<std::string, KernelCurves> kernel_curves{
    {"un",
     {[](double alpha) { return fast::un(alpha, stated); },
      [](double alpha) {
        return stated.normal_compliance() * PlainKernels(alpha).I1[0] / std::numbers::pi;
      }}},
    {"us", {[](double alpha) { return fast::us(alpha, stated); }, plain_us}},
    {"vn at eta = 0",
     {[](double alpha) { return fast::vn(alpha, 0, stated); },
      [](double alpha) { return -plain_us(alpha); }}},
    {"vs - N F2(eta)",
     {[](double alpha) {
        return fast::vs(alpha, 0, stated) - stated.normal_compliance() * fast::F2(0, stated.poisson);
      },
      [](double alpha) {
        return stated.normal_compliance() * PlainKernels(alpha).I6_alpha_part[0] / std::numbers::pi;
      }}}};

std::vector<Panel> kernel(const FigureSubject& subject) {
  const auto& [exact, plain] = kernel_curves.at(subject.text);
  return {{distance_axis,
           {subject.text + ", 1/psi"},
           {sampled(subject.text, true_kernel, Mark::line, subject.numbers("alpha"), exact),
            sampled(subject.text, by_residues, Mark::points, subject.numbers("sparse"), plain)}}};
}

std::vector<Panel> functions_of_eta(const FigureSubject& subject) {
  const auto curve = [&](const char* name, double (*of_eta)(double, double)) {
    return sampled(name, true_kernel, Mark::line, subject.numbers("eta"),
                   [=](double eta) { return of_eta(eta, stated.poisson); });
  };
  return {{{"distance of the pinned point eta = l/b"},
           {"F1, F2"},
           {curve("F1", [](double eta, double poisson) { return fast::F1(eta, poisson); }),
            curve("F2", [](double eta, double poisson) { return fast::F2(eta, poisson); })}}};
}

/// A displacement against alpha for some places of the pinned point.
std::vector<Panel> for_places(const FigureSubject& subject) {
  Panel panel{distance_axis, {subject.text + ", 1/psi"}, {}};
  for (const double eta : subject.numbers("eta"))
    panel.series.push_back(sampled(
        fmt::format("eta = {:g}", eta), true_kernel, Mark::line, subject.numbers("alpha"), [&](double alpha) {
          return subject.text == "vs" ? fast::vs(alpha, eta, stated) : fast::vn(alpha, eta, stated);
        }));
  return {panel};
}

constexpr double stated_bulk = stated.young, stated_shear = data::thesis_shear_over_bulk * stated_bulk;
constexpr double half_thickness = 0.0025, load_speed = 1;

/// The strain under a constant stress applied at t = 0, over the instantaneous strain.
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

/// T and t0 of the figure's row: the distances, in half-thicknesses, of the point and of the pinned point ahead of the
/// load's start.
std::vector<Panel> under_moving_load(const FigureSubject& subject) {
  const bool is_normal = subject.text == "Un";
  const double point = subject.number("T"), pinned = is_normal ? 0 : subject.number("t0");
  Panel panel{{"way of the load since its start F0 t/b"}, {subject.text + ", 1/psi"}, {}};
  for (const double memory : subject.numbers("memory")) {
    const std::string label = fmt::format("F0 tau = {:g} in", memory);
    const fast::MovingLoad load(data::single_relaxation_time_solid(stated_bulk, stated_shear, memory),
                                load_speed, half_thickness);
    const fast::PlainMovingLoad by_sums(data::misprinted_thesis_solid(stated_bulk, stated_shear, memory),
                                        load_speed, half_thickness, residues);
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

Drawings sheet_drawings() {
  return {{"kernel", kernel},
          {"pinned point", functions_of_eta},
          {"kernel for pinned points", for_places},
          {"creep of the solid", creep_responses},
          {"moving load", under_moving_load}};
}

}  // namespace nipref::verify
