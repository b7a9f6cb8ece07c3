#include <fmt/format.h>

#include <array>
#include <numbers>

#include <nipref/data/material/seed_solids.hpp>
#include <nipref/fast/sheet/displacements.hpp>
#include <nipref/fast/sheet/kernels.hpp>
#include <nipref/fast/sheet/plain_series.hpp>
#include <nipref/verify/figures/internal/groups.hpp>
#include <nipref/verify/figures/internal/series.hpp>

// Displacements of the elastic sheet's surface under line loads. (thesis chapter IV)

namespace nipref::verify {
namespace {

constexpr data::ElasticMaterial stated = data::seed::sheet;
constexpr auto stated_poisson = stated.poisson;
constexpr int residues = 500;  // as in the thesis's viscoelastic tables; of the elastic ones it says nothing
const std::string true_kernel = "exact kernel", by_residues = "500 residues";

/// The thesis's sums at one distance.
struct PlainKernels {
  std::array<double, 1> I1{}, I3{}, I6_alpha_part{};

  explicit PlainKernels(double alpha) {
    const std::array place{alpha};
    fast::plain_series(place, residues, {I1, I3, I6_alpha_part});
  }
};

double un(double alpha) { return fast::un(alpha, stated); }
double us(double alpha) { return fast::us(alpha, stated); }
double vn_part(double alpha) { return fast::vn(alpha, 0, stated); }
double vs_part(double alpha) {
  return fast::vs(alpha, 0, stated) - stated.normal_compliance() * fast::F2(0, stated_poisson);
}

double plain_un(double alpha) {
  return stated.normal_compliance() * PlainKernels(alpha).I1[0] / std::numbers::pi;
}
/// For alpha > 0.
double plain_us(double alpha) {
  return stated.theta2() / 2 - stated.normal_compliance() * PlainKernels(alpha).I3[0] / std::numbers::pi;
}
double plain_vn_part(double alpha) { return -plain_us(alpha); }
double plain_vs_part(double alpha) {
  return stated.normal_compliance() * PlainKernels(alpha).I6_alpha_part[0] / std::numbers::pi;
}

const FigureAxis distance_axis{"distance from the load alpha = y/b"};

/// Of one function of alpha, and the thesis's sums for alpha > 0.
FigurePlan alone(int number, const std::string& title, const std::string& quantity, double first,
                 const Curve& exact, const Curve& plain) {
  return {fmt::format("thesis-{}", number), title, "E = 1.45e5 psi, nu = 1/3", [=] {
            return std::vector<Panel>{
                {distance_axis,
                 {quantity + ", 1/psi"},
                 {sampled(quantity, true_kernel, Mark::line, evenly(first, 5, 250), exact),
                  sampled(quantity, by_residues, Mark::points, evenly(0.2, 5, 25), plain)}}};
          }};
}

std::vector<Panel> functions_of_eta() {
  const std::vector<double> eta = evenly(-5, 5, 251);
  return {
      {{"distance of the pinned point eta = l/b"},
       {"F1, F2"},
       {sampled("F1", true_kernel, Mark::line, eta, [](double at) { return fast::F1(at, stated_poisson); }),
        sampled("F2", true_kernel, Mark::line, eta,
                [](double at) { return fast::F2(at, stated_poisson); })}}};
}

/// A displacement against alpha for some places of the pinned point.
FigurePlan for_places(int number, const std::string& title, const std::string& quantity,
                      const std::vector<double>& alpha, double (*displacement)(double, double)) {
  return {fmt::format("thesis-{}", number), title, "E = 1.45e5 psi, nu = 1/3, pinned point at eta = l/b",
          [=] {
            Panel panel{distance_axis, {quantity + ", 1/psi"}, {}};
            for (const double eta : {0.0, 0.5, 1.0, 2.0, 4.0})
              panel.series.push_back(sampled(fmt::format("eta = {:g}", eta), true_kernel, Mark::line, alpha,
                                             [&](double at) { return displacement(at, eta); }));
            return std::vector<Panel>{panel};
          }};
}

}  // namespace

std::vector<FigurePlan> kernel_figures() {
  return {
      alone(7, "Normal displacement of an elastic sheet's surface under a normal line load", "un", 0.02, un,
            plain_un),
      alone(8, "Normal displacement of an elastic sheet's surface under a shear line load", "us", 0.001, us,
            plain_us),
      {"thesis-9", "What the pinned point adds to tangential displacements: F1 and F2", "nu = 1/3",
       functions_of_eta},
      alone(10, "The part of the tangential displacement under a normal load that depends on alpha",
            "vn at eta = 0", 0.001, vn_part, plain_vn_part),
      alone(11, "The part of the tangential displacement under a shear load that depends on alpha",
            "vs - N F2(eta)", 0.02, vs_part, plain_vs_part),
      for_places(12, "Tangential displacement of an elastic sheet's surface under a normal line load", "vn",
                 evenly(-5, 5, 401), [](double at, double eta) { return fast::vn(at, eta, stated); }),
      for_places(13, "Tangential displacement of an elastic sheet's surface under a shear line load", "vs",
                 without(evenly(-5, 5, 401), {0}),
                 [](double at, double eta) { return fast::vs(at, eta, stated); })};
}

}  // namespace nipref::verify
