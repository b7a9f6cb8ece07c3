#pragma once
#include <fmt/format.h>

#include <cmath>
#include <string>

#include <nipref/data/material/seed_solids.hpp>
#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/verify/replay/internal/elastic_nip.hpp>
#include <nipref/verify/replay/internal/viscoelastic_nip.hpp>

namespace nipref::verify {

/// A nip of the thesis's tables: of the sheet's material, or of the standard linear solid whose instantaneous response is that
/// material.
struct NipAt {
  double thickness, load;
  double memory = 0;  ///< speed times relaxation time, in; 0: elastic
  data::Friction friction = data::Friction::none;
};

/// The nip without the memory, which differs from row to row.
inline NipAt nip_of_table(const data::Table& table, double load) {
  const bool is_rolling = table.columns.front().name != "W";
  return {table.parameter("B").value, load, 0,
          is_rolling ? data::Friction::none : line_load_table(table.id).friction};
}

inline std::size_t row_of_memory(const data::Table& table, double memory) {
  std::size_t row = 0;
  while (std::fabs(relaxation_length(table, row) / memory - 1) > 1e-6) ++row;
  return row;
}

/// Applies `use` to the continuous contact, a fast::ConvergedElasticNip or a fast::ConvergedViscoelasticNip.
template <class Use>
auto with_contact(const NipAt& nip, double accuracy, const Use& use) {
  const data::ElasticMaterial& at_once = data::seed::sheet_of_the_tables;
  if (nip.memory == 0)
    return use(fast::converged_for_load({data::seed::roller_radius, nip.thickness, at_once}, nip.friction,
                                        nip.load, accuracy));
  const auto solid = data::single_relaxation_time_solid({at_once.theta1(), at_once.theta2()}, nip.memory);
  return use(
      fast::converged_for_load({data::seed::roller_radius, nip.thickness, solid, 1}, nip.load, accuracy));
}

inline std::string load_label(double load) { return fmt::format("W = {:g} lbf/in", load); }
inline std::string memory_label(double memory) { return fmt::format("F0 tau = {:g} in", memory); }
inline std::string thickness_label(double thickness) { return fmt::format("B = {:g} in", thickness); }
inline std::string friction_label(data::Friction friction) {
  return friction == data::Friction::full ? "no slip" : "complete slip";
}

}  // namespace nipref::verify
