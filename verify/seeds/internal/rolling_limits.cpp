#include <cmath>

#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/verify/seeds/internal/limit_rows.hpp>
#include <nipref/verify/seeds/internal/thin_standard_solid.hpp>

namespace nipref::verify {
namespace {

constexpr double rolling_radius = 4096, rolling_accuracy = 1e-12;
constexpr double solid_bulk = 1, solid_shear = 0.375;  // Poisson's ratio is 1/3

/// Rolling with speed 1 on a contact of length L on a sheet of half-thickness 1.
fast::ConvergedViscoelasticNip rolling(const data::ViscoelasticMaterial& material, double length) {
  return fast::converged_for_length({rolling_radius, 2, material, 1}, length, rolling_accuracy);
}

data::ViscoelasticMaterial one_time(double relaxation_time) {
  return data::single_relaxation_time_solid(solid_bulk, solid_shear, relaxation_time);
}

/// Two times and unequal parts in shear and dilatation; `scale` stretches both times.
data::ViscoelasticMaterial two_times(double scale) {
  return data::prony_solid({1.3, {0.4 / scale, 0.9 / scale}, {1 / scale, 3 / scale}},
                           {0.5, {0.1 / scale, 0.3 / scale}, {1 / scale, 3 / scale}});
}

/// What the material's own functions are rounded by: sums of a few products.
Propagated of_material(double value) { return {value, 0x1p-48 * std::fabs(value)}; }

/// F0 sum(gamma/lambda^2)/(R N(infinity)): what a short memory leaves of the resistance.
Propagated short_memory_resistance(const data::ViscoelasticMaterial& material) {
  const data::MaterialFunction n = material.functions()->normal_compliance();
  Propagated sum = 0;
  for (const data::RelaxationTerm& term : n.terms)
    sum = sum + of_material((term.amplitude / (term.rate * term.rate)).real());
  return sum / (rolling_radius * of_material(n.long_time()));
}

/// mu_R of a long memory: the elastic contact of the compliance at once, over all of which the amplitudes act: sum(gamma)
/// (d0 - int p Y^2/(2 R W))/(F0 N(0)).
Propagated long_memory_resistance(const data::ViscoelasticMaterial& material, double length) {
  const data::MaterialFunction n = material.functions()->normal_compliance();
  const data::ElasticNip nip{rolling_radius, 2, {2 / n.instantaneous, 0}};
  const auto contact = fast::converged_for_length(nip, data::Friction::none, length, rolling_accuracy);
  constexpr int nodes = 200;
  const Propagated half = Propagated::exact(length / 2), step = Propagated::pi() / (nodes + 1);
  Propagated second_moment = 0;
  for (int i = 1; i <= nodes; ++i) {  // Gauss's rule for the ends' square roots
    const Propagated angle = i * step, t = cos(angle);
    second_moment = second_moment + contact.pressure((half * t).value()) * square(t) * sin(angle);
  }
  second_moment = second_moment * half * square(half) * step;
  Propagated amplitudes = 0;
  for (const data::RelaxationTerm& term : n.terms)
    amplitudes = amplitudes + of_material(term.amplitude.real());
  const Propagated lost = contact.indentation() - second_moment / (2 * rolling_radius * contact.load());
  return amplitudes * lost / of_material(n.instantaneous);
}

constexpr double memory_length = 2;  // L/B = 1

}  // namespace

LimitSamples rolling_limits() {
  constexpr double memory = 0.45;
  const ThinStandardSolid thin_limit = thin_standard_solid(memory);
  const auto thin_nip = [](double size) {
    const double length = 2 / size;
    return rolling(one_time(memory * length), length);
  };
  const auto resistance = [](const data::ViscoelasticMaterial& material) {
    return rolling(material, memory_length).rolling_resistance();
  };
  return {
      {"limit.short_memory.resistance",
       limit([=](double size) { return resistance(one_time(size * memory_length)); },
             [](const Propagated& size) { return size * memory_length / (2 * rolling_radius); })},
      {"limit.short_memory.prony_resistance",
       limit([=](double size) { return resistance(two_times(size * memory_length)); },
             [](const Propagated& size) {
               return short_memory_resistance(two_times(size.value() * memory_length));
             })},
      {"limit.long_memory.resistance",
       limit([=](double size) { return resistance(one_time(memory_length / size)); },
             [](const Propagated& size) {
               return long_memory_resistance(one_time(memory_length / size.value()), memory_length);
             })},
      {"limit.thin_memory.resistance", limit(
                                           [=](double size) {
                                             return Propagated::exact(rolling_radius * size / 2) *
                                                    thin_nip(size).rolling_resistance();
                                           },
                                           [=](const Propagated&) { return thin_limit.resistance; })},
      {"limit.thin_memory.leading_share",
       limit([=](double size) { return Propagated::exact(size / 2) * thin_nip(size).leading_length(); },
             [=](const Propagated&) { return thin_limit.leading_share; })},
  };
}

}  // namespace nipref::verify
