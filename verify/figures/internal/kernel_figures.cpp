#include <fmt/format.h>

#include <array>
#include <map>
#include <numbers>
#include <utility>

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

/// A displacement as a function of alpha alone, and the thesis's sums for it.
struct KernelCurves {
  double first;  ///< the least alpha of the exact curve
  double (*exact)(double);
  double (*plain)(double);
};

std::vector<Panel> kernel(const FigureSubject& subject) {
  static const std::map<std::string, KernelCurves> known{{"un", {0.02, un, plain_un}},
                                                         {"us", {0.001, us, plain_us}},
                                                         {"vn at eta = 0", {0.001, vn_part, plain_vn_part}},
                                                         {"vs - N F2(eta)", {0.02, vs_part, plain_vs_part}}};
  const std::string& quantity = subject.text;
  const KernelCurves& curves = known.at(quantity);
  return {{distance_axis,
           {quantity + ", 1/psi"},
           {sampled(quantity, true_kernel, Mark::line, evenly(curves.first, 5, 250), curves.exact),
            sampled(quantity, by_residues, Mark::points, evenly(0.2, 5, 25), curves.plain)}}};
}

std::vector<Panel> functions_of_eta(const FigureSubject&) {
  const std::vector<double> eta = evenly(-5, 5, 251);
  return {
      {{"distance of the pinned point eta = l/b"},
       {"F1, F2"},
       {sampled("F1", true_kernel, Mark::line, eta, [](double at) { return fast::F1(at, stated_poisson); }),
        sampled("F2", true_kernel, Mark::line, eta,
                [](double at) { return fast::F2(at, stated_poisson); })}}};
}

/// A displacement against alpha for some places of the pinned point; vs is infinite at the load.
std::vector<Panel> for_places(const FigureSubject& subject) {
  const bool is_shear = subject.text == "vs";
  std::vector<double> alpha = evenly(-5, 5, 401);
  if (is_shear) alpha = without(std::move(alpha), {0});
  Panel panel{distance_axis, {subject.text + ", 1/psi"}, {}};
  for (const double eta : {0.0, 0.5, 1.0, 2.0, 4.0})
    panel.series.push_back(
        sampled(fmt::format("eta = {:g}", eta), true_kernel, Mark::line, alpha,
                [&](double at) { return is_shear ? fast::vs(at, eta, stated) : fast::vn(at, eta, stated); }));
  return {panel};
}

}  // namespace

Drawings kernel_drawings() {
  return {{"kernel", kernel}, {"pinned point", functions_of_eta}, {"kernel for pinned points", for_places}};
}

}  // namespace nipref::verify
