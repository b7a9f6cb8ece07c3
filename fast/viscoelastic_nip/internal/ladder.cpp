#include <cmath>
#include <stdexcept>

#include <nipref/fast/nip/internal/length_search.hpp>
#include <nipref/fast/viscoelastic_nip/internal/functionals.hpp>
#include <nipref/fast/viscoelastic_nip/internal/ladder.hpp>

namespace nipref::fast {
namespace {

constexpr int most_levels = 7;
/// Of a solution in double, relative.
constexpr double rounding = 0x1p-48;

/// The panels at the ends take at most the distance in which the sheet's kernel changes, and twice the
/// shortest relaxation length, but resolve none that is too short to matter.
int panels_for(double half_length, const ViscoelasticMaterial& material) {
  double longest = 2.5;
  for (const MemoryTerm& term : material.normal) longest = std::min(longest, 2 / std::abs(term.rate));
  return 1 + std::clamp(static_cast<int>(std::ceil(std::log2(half_length / longest))), 0, 36);
}

int terms_at(int level) { return static_cast<int>(std::ceil(4 * std::pow(1.5, level))); }

/// The compliance with which the contact acts over its whole length, over the instantaneous one.
double compliance_over(double half_length, const ViscoelasticMaterial& material) {
  double sum = 1;
  for (const MemoryTerm& term : material.normal)
    sum += (term.amplitude / (term.rate + 1 / half_length)).real();
  return sum;
}

}  // namespace

ViscoelasticLadder::ViscoelasticLadder(const ViscoelasticMaterial& material, double accuracy)
    : material_(material), accuracy_(accuracy), tolerance_(std::max(1e-6 * accuracy, 1e-16)) {}

/// Kernels and quadrature are as good as the expansion, so that the differences between levels tell of them
/// too.
std::unique_ptr<ViscoelasticPressure> ViscoelasticLadder::solve(double half_length, double near,
                                                                int level) const {
  const int terms = terms_at(level);
  // On each panel the nearest singularity is one panel length away.
  const double tolerance = std::max(1e-2 * std::pow(3 + std::sqrt(8.0), -terms), 1e-16);
  CountedKernels kernels(Accuracy(std::max({tolerance, 1e-4 * accuracy_, Accuracy::best_rtol})), *work_);
  return std::make_unique<ViscoelasticPressure>(
      ViscoelasticLayout(half_length, panels_for(near, material_), terms), material_, tolerance, kernels);
}

std::unique_ptr<ViscoelasticPressure> ViscoelasticLadder::solve_for_load(double load, double near,
                                                                         int level) {
  // The first level is only compared with the next: it need not meet the load better than it meets the pressure.
  const double enough = std::max(1e-2 * accuracy_, level == 0 ? 1e-5 : 1e-14);
  for (LengthSearch search(load, near, enough, slope_);;) {
    const double half_length = search.half_length();
    // The layout follows large steps only: it makes the load jump.
    if (level == 0 && std::fabs(std::log(half_length / near)) > 0.3) near = half_length;
    auto contact = solve(half_length, near, level);
    if (half_length > longest_sought) return contact;
    const bool settled = search.settled(contact->load());
    load_residual_ = search.residual();
    slope_ = search.slope();
    if (settled) return contact;
  }
}

void ViscoelasticLadder::climb(double near, const Step& step) {
  for (int level = 0; level < most_levels; ++level) {
    std::ranges::rotate(solutions_, solutions_.begin() + 1);
    solutions_[2] = step(near, level);
    near = last().half_length();
    if (level < 2) continue;
    relative_error_ = largest_relative_error();
    if (!std::isfinite(relative_error_)) throw std::runtime_error("the contact's expansion broke down");
    if (relative_error_ <= accuracy_) return;
  }
}

ViscoelasticLadder ViscoelasticLadder::at_half_length(double half_length,
                                                      const ViscoelasticMaterial& material, double accuracy) {
  ViscoelasticLadder ladder(material, accuracy);
  ladder.climb(half_length, [&](double near, int level) { return ladder.solve(half_length, near, level); });
  return ladder;
}

ViscoelasticLadder ViscoelasticLadder::at_load(double load, const ViscoelasticMaterial& material,
                                               double accuracy) {
  ViscoelasticLadder ladder(material, accuracy);
  const double stiff = half_length_guess(load);
  ladder.climb(half_length_guess(load * compliance_over(stiff, material)),
               [&](double near, int level) { return ladder.solve_for_load(load, near, level); });
  return ladder;
}

Estimate ViscoelasticLadder::own_estimate(const Functional& functional) const {
  std::array<double, 3> values{};
  std::ranges::transform(solutions_, values.begin(),
                         [&](const auto& contact) { return functional(*contact); });
  return estimate_from_levels(values);
}

double ViscoelasticLadder::largest_relative_error() const {
  double largest = 0;
  const auto take = [&](const Functional& functional, double scale) {
    const Estimate estimate = own_estimate(functional);
    largest = std::max(largest, estimate.error / std::max(scale, std::fabs(estimate.value)));
  };
  const double half_length = last().half_length();
  take([](const ViscoelasticPressure& contact) { return contact.load(); }, 0);
  take([](const ViscoelasticPressure& contact) { return contact.half_length(); }, 0);
  take([](const ViscoelasticPressure& contact) { return contact.edge_displacement(); },
       half_length * half_length);
  take([](const ViscoelasticPressure& contact) { return contact.offset(); }, 0.1 * half_length);
  // Relative to its own size, however small that is, as far as rounding lets.
  take(eccentricity, half_length * std::min(1.0, 1e-14 / accuracy_));
  const double peak = last().pressure({Half::leading, half_length});
  for (const Half half : {Half::leading, Half::trailing}) {
    take(
        [&](const ViscoelasticPressure& contact) {
          return contact.pressure({half, 0.25 * contact.half_length()});
        },
        peak);
  }
  take(
      [](const ViscoelasticPressure& contact) {
        return contact.pressure({Half::leading, contact.half_length()});
      },
      0);
  return largest;
}

Estimate ViscoelasticLadder::estimate(const Functional& functional, double scale) const {
  const Estimate own = own_estimate(functional);
  const double least = std::max({0.1 * relative_error_, 1e-5 * accuracy_, 3 * load_residual_, rounding});
  return {own.value, std::max(own.error, least * std::max(scale, std::fabs(own.value)))};
}

Estimate ViscoelasticLadder::estimate_down_to_rounding(const Functional& functional) const {
  const Estimate relative = estimate(functional);
  return {relative.value, std::max(relative.error, rounding * last().half_length())};
}

}  // namespace nipref::fast
