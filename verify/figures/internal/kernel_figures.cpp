#include <fmt/format.h>

#include <array>
#include <map>
#include <numbers>

#include <nipref/data/material/seed_solids.hpp>
#include <nipref/fast/sheet/displacements.hpp>
#include <nipref/fast/sheet/kernels.hpp>
#include <nipref/fast/sheet/plain_series.hpp>
#include <nipref/verify/figures/internal/drawings.hpp>

// Displacements of the elastic sheet's surface under line loads. (thesis chapter IV)

namespace nipref::verify {
namespace {

constexpr data::ElasticMaterial stated = data::seed::sheet;
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

}  // namespace

Drawings kernel_drawings() {
  return {{"kernel", kernel}, {"pinned point", functions_of_eta}, {"kernel for pinned points", for_places}};
}

}  // namespace nipref::verify
