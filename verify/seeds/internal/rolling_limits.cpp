#include <algorithm>
#include <cmath>
#include <iterator>

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

/// Orders: of the resistance the term that the limit leaves out would be of order 3 in the memory, since reversing the
/// motion reverses its sign; but over a length of memory at each end, where the pressure is like a root, it is another
/// pressure. There p^2 is of order 1, which makes order 2 in the resistance, 1 in its distance. A long memory leaves out
/// what it forgets within the nip, a part of order 1.
std::vector<LimitRow> memory_limits() {
  return {
      {"limit.short_memory.resistance", "mu_R = F0 tau/(2 R), the solid with one relaxation time",
       "the moment of the first time derivative", "F0 tau/L", 1,
       halved(0.01,
              [](double size) {
                return LimitSample{
                    size, rolling(one_time(size * memory_length), memory_length).rolling_resistance(),
                    Propagated::exact(size) * memory_length / (2 * rolling_radius)};
              })},
      {"limit.short_memory.prony_resistance",
       "mu_R = F0 sum(gamma/lambda^2)/(R N(infinity)), two relaxation times",
       "the moment of the first time derivative", "F0 tau/L", 1,
       halved(0.01,
              [](double size) {
                const auto material = two_times(size * memory_length);
                return LimitSample{size, rolling(material, memory_length).rolling_resistance(),
                                   short_memory_resistance(material)};
              })},
      {"limit.long_memory.resistance", "mu_R = sum(gamma) (d0 - int p Y^2/(2 R W))/(F0 N(0))",
       "the elastic contact's energy, spent once", "L/(F0 tau)", 1,
       halved(0.01,
              [](double size) {
                const auto material = one_time(memory_length / size);
                return LimitSample{size, rolling(material, memory_length).rolling_resistance(),
                                   long_memory_resistance(material, memory_length)};
              })},
  };
}

std::vector<LimitRow> thin_limits() {
  constexpr double memory = 0.45;
  const ThinStandardSolid limit = thin_standard_solid(memory);
  const auto nip = [](double size) {
    const double long_one = 2 / size;
    return rolling(one_time(memory * long_one), long_one);
  };
  constexpr auto source = "springs with memory, in closed form; F0 tau/L = 0.45";
  constexpr double first = 0.02;
  return {
      {"limit.thin_memory.resistance", "mu_R R/L", source, "B/L", 1,
       halved(first,
              [&](double size) {
                return LimitSample{
                    size, Propagated::exact(rolling_radius * size / 2) * nip(size).rolling_resistance(),
                    limit.resistance};
              })},
      {"limit.thin_memory.leading_share", "L1/L", source, "B/L", 1,
       halved(first,
              [&](double size) {
                return LimitSample{size, Propagated::exact(size / 2) * nip(size).leading_length(),
                                   limit.leading_share};
              })},
  };
}

}  // namespace

std::vector<LimitRow> rolling_limits() {
  std::vector<LimitRow> rows = memory_limits();
  std::ranges::move(thin_limits(), std::back_inserter(rows));
  return rows;
}

}  // namespace nipref::verify
