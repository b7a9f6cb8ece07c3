#include <algorithm>
#include <cmath>

#include <nipref/fast/nip/internal/expansion_tail.hpp>
#include <nipref/fast/viscoelastic_nip/internal/functionals.hpp>
#include <nipref/fast/viscoelastic_nip/internal/levels.hpp>

namespace nipref::fast {
namespace {

/// The compliance with which the contact acts over its whole length, over the instantaneous one.
double compliance_over(double half_length, const ViscoelasticCompliances& material) {
  double sum = 1;
  for (const MemoryTerm& term : material.normal)
    sum += (term.amplitude / (term.rate + 1 / half_length)).real();
  return sum;
}

}  // namespace

/// The panels at the ends take at most the distance in which the sheet's kernel changes, and twice that in which a
/// memory takes over: waves e^(ikd) meet the compliance 1 + amplitude/(rate + ik), which is 0 where -ik is rate +
/// amplitude, so that pressure that sets in settles by that much a half-thickness. They resolve none that is too
/// short to matter. On each the nearest singularity is one panel length away.
ViscoelasticNipLevels::Resolution ViscoelasticNipLevels::resolution(double near, int level) const {
  double longest = widest_felt;
  for (const MemoryTerm& term : material_.normal)
    longest = std::min(longest, 2 / (std::abs(term.rate) + std::abs(term.amplitude)));
  const int panels = 1 + std::clamp(static_cast<int>(std::ceil(std::log2(near / longest))), 0, 36);
  const int terms = static_cast<int>(std::ceil(4 * std::pow(1.5, level)));
  return {panels, terms, std::pow(fastest_on_panels(near), -terms)};
}

std::unique_ptr<ViscoelasticPressure> ViscoelasticNipLevels::solve(double half_length,
                                                                   const Resolution& resolution,
                                                                   double tolerance,
                                                                   CountedKernels& kernels) const {
  return std::make_unique<ViscoelasticPressure>(
      ViscoelasticLayout(half_length, resolution.panels, resolution.terms), material_, tolerance, kernels);
}

std::vector<Judged<ViscoelasticPressure>> ViscoelasticNipLevels::judged(const ViscoelasticPressure& last,
                                                                        double accuracy) const {
  const double half_length = last.half_length(), peak = last.pressure({Half::leading, half_length});
  const auto pressure = [](Half half, double part) {
    return [=](const ViscoelasticPressure& contact) {
      return contact.pressure({half, part * contact.half_length()});
    };
  };
  return {{&ViscoelasticPressure::load},
          {&ViscoelasticPressure::half_length},
          {&ViscoelasticPressure::edge_displacement, half_length * half_length},
          {&ViscoelasticPressure::offset, 0.1 * half_length},
          // Relative to its own size, however small that is, as far as rounding lets.
          {eccentricity, half_length * std::min(1.0, 1e-14 / accuracy), half_length, Rate::own},
          {pressure(Half::leading, 0.25), peak},
          {pressure(Half::trailing, 0.25), peak},
          {pressure(Half::leading, 1)}};
}

double ViscoelasticNipLevels::half_length_guess(double load) const {
  const double stiff = fast::half_length_guess(load);
  return fast::half_length_guess(load * compliance_over(stiff, material_));
}

}  // namespace nipref::fast
