#include <algorithm>
#include <cmath>

#include <nipref/fast/elastic_nip/internal/levels.hpp>
#include <nipref/fast/elastic_nip/internal/panels.hpp>
#include <nipref/fast/elastic_nip/internal/spectral.hpp>
#include <nipref/fast/nip/internal/expansion_tail.hpp>

namespace nipref::fast {
namespace {

/// Longer contacts would need more terms in one expansion than in panels.
constexpr double longest_spectral = 12;

int grown(double first_terms, int level) {
  return static_cast<int>(std::ceil(first_terms * std::pow(1.5, level)));
}

}  // namespace

ElasticNipLevels::Resolution ElasticNipLevels::resolution(double near, int level) const {
  if (friction_ == data::Friction::none && near <= longest_spectral) {
    const int terms = grown(2 + near / 2, level);
    // The half width of the strip around the contact in which kernel and pressure are effectively analytic. The
    // kernel's singularities are at 2, but they matter less the longer the contact is (measured: 1.9 at A = 0.3, 2.3 at
    // 1, 3.3 at 4, 4.3 at 9).
    const double strip = 2 + std::min(near / 4, 2.0);
    return {true, 1, terms, std::pow(std::hypot(1, strip / near) + strip / near, -2 * terms)};
  }
  // The end panel is at most about as wide as the length scale of the kernels; on each panel the nearest singularity is
  // one panel width away.
  const int panels = 1 + std::max(0, static_cast<int>(std::ceil(std::log2(near / widest_felt))));
  const int terms = grown(3, level);
  return {false, panels, terms, std::pow(fastest_on_panels(near), -terms)};
}

std::unique_ptr<HalfContact> ElasticNipLevels::solve(double half_length, const Resolution& resolution,
                                                     double tolerance, CountedKernels& kernels) const {
  if (resolution.spectral) return spectral_contact(half_length, resolution.terms, kernels);
  return panel_contact(half_length, friction_, poisson_, {resolution.panels, resolution.terms, tolerance},
                       kernels);
}

std::vector<AccuracyTarget<HalfContact>> ElasticNipLevels::accuracy_targets(const HalfContact& last,
                                                                            double) const {
  const double half_length = last.half_length, peak = last.traction(half_length).pressure;
  std::vector<AccuracyTarget<HalfContact>> all{
      {[](const HalfContact& contact) { return contact.load; }},
      {[](const HalfContact& contact) { return contact.half_length; }},
      {[](const HalfContact& contact) { return contact.edge_displacement; }, half_length * half_length},
      // The creep of a long contact is determined by the ends alone, far less well than the other numbers.
      {[](const HalfContact& contact) { return contact.creep; }, 0.1 * half_length,
       std::pow(half_length, 3)}};
  for (const double part : {0.25, 1.0}) {
    const auto traction = [part](const HalfContact& contact) {
      return contact.traction(part * contact.half_length);
    };
    all.push_back({[=](const HalfContact& contact) { return traction(contact).pressure; }, peak});
    all.push_back({[=](const HalfContact& contact) { return traction(contact).shear; }, 0.1 * peak});
  }
  return all;
}

}  // namespace nipref::fast
