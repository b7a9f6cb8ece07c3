#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <nipref/fast/elastic_nip/internal/functionals.hpp>
#include <nipref/fast/elastic_nip/internal/operator.hpp>
#include <nipref/fast/nip/internal/stretch.hpp>
#include <nipref/fast/number/internal/sampled_maximum.hpp>

namespace nipref::fast {
namespace {

double displacement(const HalfContact& contact, double y, const SurfaceDisplacements& how, Couplings wanted,
                    CountedKernels& kernels) {
  const ElasticNipOperator from(contact.half_length, how.beta, how.tolerance, kernels);
  double sum = 0;
  for (std::size_t i = 1; i < contact.breaks.size(); ++i) {
    for (const Influence& node :
         from.influences(contact.half_length - y, contact.breaks[i - 1], contact.breaks[i], wanted)) {
      const Traction traction = contact.traction(node.e);
      sum += node.weight * ((node.normal_by_pressure + node.tangential_by_pressure) * traction.pressure +
                            (node.normal_by_shear + node.tangential_by_shear) * traction.shear);
    }
  }
  return sum;
}

/// Largest value of `size` over 0 <= e <= A, from a sample that is dense at the end.
template <class Size>
double largest(const HalfContact& contact, Size size) {
  constexpr int samples = 100;
  const auto position = [&](double i) {
    return contact.half_length * std::pow(std::sin(std::numbers::pi / 2 * std::min(i / samples, 1.0)), 2);
  };
  return internal::sampled_maximum([&](double i) { return size(position(i)); }, samples);
}

}  // namespace

double normal_displacement(const HalfContact& contact, double y, const SurfaceDisplacements& how,
                           CountedKernels& kernels) {
  const double e = contact.half_length - y;
  if (e >= 0) return contact.edge_displacement + e * (contact.half_length + y);
  return displacement(contact, y, how, {true, how.friction == data::Friction::full, false, false}, kernels);
}

double tangential_displacement(const HalfContact& contact, double y, const SurfaceDisplacements& how,
                               CountedKernels& kernels) {
  const bool friction = how.friction == data::Friction::full;
  if (friction && y <= contact.half_length) return contact.creep * y;
  if (y == 0) return 0;
  return displacement(contact, y, how, {false, false, true, friction}, kernels);
}

double smooth_strain(const HalfContact& contact, double y, const SurfaceDisplacements& how,
                     CountedKernels& kernels) {
  const ElasticNipOperator from(contact.half_length, how.beta, how.tolerance, kernels);
  double sum = 0;
  for (std::size_t i = 1; i < contact.breaks.size(); ++i) {
    for (const Influence& node : from.influences(contact.half_length - y, contact.breaks[i - 1],
                                                 contact.breaks[i], {false, false, false, false})) {
      const double s = contact.half_length - node.e;
      sum +=
          node.weight * contact.traction(node.e).pressure * (stretch_over_pi(y - s) + stretch_over_pi(y + s));
    }
  }
  return sum;
}

double peak_pressure(const HalfContact& contact) {
  return largest(contact, [&](double e) { return contact.traction(e).pressure; });
}

double peak_shear(const HalfContact& contact) {
  return largest(contact, [&](double e) { return std::fabs(contact.traction(e).shear); });
}

}  // namespace nipref::fast
