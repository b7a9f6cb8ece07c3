#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <nipref/fast/elastic_nip/internal/ladder.hpp>
#include <nipref/fast/elastic_nip/internal/panels.hpp>
#include <nipref/fast/elastic_nip/internal/spectral.hpp>
#include <nipref/fast/nip/internal/length_search.hpp>
#include <nipref/fast/number/internal/tiers.hpp>

namespace nipref::fast {
namespace {

/// Where the global expansion would need more terms than the panels have.
constexpr double longest_spectral = 12;
constexpr int most_levels = 8;
/// Of a solution in double, relative.
constexpr double rounding = 0x1p-48;

/// How `level` resolves a contact of half length about `near`, and the size of what its expansion leaves out.
struct Resolution {
  bool spectral;
  int panels;
  int terms;
  double remainder;
};

int grown(double first_terms, int level) {
  return static_cast<int>(std::ceil(first_terms * std::pow(1.5, level)));
}

Resolution resolution(data::Friction friction, double near, int level) {
  if (friction == data::Friction::none && near <= longest_spectral) {
    const int terms = grown(2 + near / 2, level);
    return {true, 1, terms, std::pow(std::hypot(1, 2 / near) + 2 / near, -2 * terms)};
  }
  // The end panel takes at most about the distance at which the kernels change; on each, the nearest
  // singularity is one panel length away.
  const int panels = 1 + std::max(0, static_cast<int>(std::ceil(std::log2(near / 2.5))));
  const int terms = grown(3, level);
  return {false, panels, terms, std::pow(3 + std::sqrt(8.0), -terms)};
}

}  // namespace

ElasticNipLadder::ElasticNipLadder(data::Friction friction, double poisson, double accuracy)
    : friction_(friction),
      poisson_(poisson),
      tolerance_(std::max(1e-6 * accuracy, 1e-16)),
      kernel_accuracy_(std::max(1e-4 * accuracy, Accuracy::best_rtol)) {}

/// Kernels and quadrature are as good as the expansion, so that the differences between levels tell of them
/// too.
std::unique_ptr<HalfContact> ElasticNipLadder::solve(double half_length, double near, int level) const {
  const Resolution now = resolution(friction_, near, level);
  const double tolerance = std::max(1e-2 * now.remainder, 1e-16);
  CountedKernels kernels(Accuracy(std::max(tolerance, kernel_accuracy_.rtol())), *work_);
  if (now.spectral) return spectral_contact(half_length, now.terms, kernels);
  return panel_contact(half_length, friction_, poisson_, {now.panels, now.terms, tolerance}, kernels);
}

std::unique_ptr<HalfContact> ElasticNipLadder::solve_for_load(double load, double near, int level,
                                                              double enough) {
  for (LengthSearch search(load, near, enough);;) {
    const double half_length = search.half_length();
    // The layout follows large steps only: it makes the load jump.
    if (level == 0 && std::fabs(std::log(half_length / near)) > 0.3) near = half_length;
    auto contact = solve(half_length, near, level);
    if (half_length > longest_sought) return contact;
    const bool settled = search.settled(contact->load);
    load_residual_ = search.residual();
    if (settled) return contact;
  }
}

void ElasticNipLadder::climb(double near, double accuracy, const Step& step) {
  for (int level = 0; level < most_levels; ++level) {
    std::ranges::rotate(solutions_, solutions_.begin() + 1);
    solutions_[2] = step(near, level);
    near = last().half_length;
    if (level < 2) continue;
    relative_error_ = largest_relative_error();
    if (!std::isfinite(relative_error_)) throw std::runtime_error("the contact's expansion broke down");
    if (relative_error_ <= accuracy) return;
  }
}

ElasticNipLadder ElasticNipLadder::at_half_length(double half_length, data::Friction friction, double poisson,
                                                  double accuracy) {
  ElasticNipLadder ladder(friction, poisson, accuracy);
  ladder.climb(half_length, accuracy,
               [&](double near, int level) { return ladder.solve(half_length, near, level); });
  return ladder;
}

ElasticNipLadder ElasticNipLadder::at_load(double load, data::Friction friction, double poisson,
                                           double accuracy) {
  ElasticNipLadder ladder(friction, poisson, accuracy);
  const double enough = std::max(1e-2 * accuracy, 1e-14);
  ladder.climb(half_length_guess(load), accuracy,
               [&](double near, int level) { return ladder.solve_for_load(load, near, level, enough); });
  return ladder;
}

Estimate ElasticNipLadder::own_estimate(const Functional& functional) const {
  std::array<double, 3> values{};
  std::ranges::transform(solutions_, values.begin(),
                         [&](const auto& contact) { return functional(*contact); });
  return estimate_from_levels(values);
}

double ElasticNipLadder::largest_relative_error() const {
  double largest = 0;
  const auto take = [&](const Functional& functional, double scale) {
    const Estimate estimate = own_estimate(functional);
    largest = std::max(largest, estimate.error / std::max(scale, std::fabs(estimate.value)));
  };
  take([](const HalfContact& contact) { return contact.load; }, 0);
  take([](const HalfContact& contact) { return contact.half_length; }, 0);
  take([](const HalfContact& contact) { return contact.edge_displacement; }, std::pow(last().half_length, 2));
  const double peak = last().traction(last().half_length).pressure;
  for (const double part : {0.25, 1.0}) {
    take([&](const HalfContact& contact) { return contact.traction(part * contact.half_length).pressure; },
         peak);
    take([&](const HalfContact& contact) { return contact.traction(part * contact.half_length).shear; },
         0.1 * peak);
  }
  take([](const HalfContact& contact) { return contact.creep; }, 0.1 * last().half_length);
  return largest;
}

Estimate ElasticNipLadder::estimate(const Functional& functional, double scale) const {
  const Estimate own = own_estimate(functional);
  const int tier = kernel_accuracy_.tier();
  // Errors of many kernel values mostly cancel; those of the full tier are rounding.
  const double kernels = tier < internal::full_tier ? 0.03 * internal::tier_works[tier].error : 0;
  const double least = std::max({relative_error_, kernels, 3 * load_residual_, rounding});
  return {own.value, std::max(own.error, least * std::max(scale, std::fabs(own.value)))};
}

}  // namespace nipref::fast
