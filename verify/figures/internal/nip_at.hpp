#pragma once
#include <fmt/format.h>

#include <cmath>
#include <string>

#include <nipref/data/material/seed_solids.hpp>
#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/verify/replay/internal/elastic_nip.hpp>
#include <nipref/verify/replay/internal/viscoelastic_nip.hpp>
#include <nipref/verify/solve/internal/methods.hpp>

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

/// The continuous contact.
inline SolvedInDouble contact_of(const NipAt& nip, double accuracy) {
  const data::ElasticMaterial& at_once = data::seed::sheet_of_the_tables;
  if (nip.memory == 0)
    return solve_converged(data::ElasticNipProblem{.nip = {data::seed::roller_radius, nip.thickness, at_once},
                                                   .given = data::GivenLoad{nip.load},
                                                   .friction = nip.friction,
                                                   .creep_ratio = {},
                                                   .method = {},
                                                   .profile = {}},
                           accuracy);
  const auto solid = data::single_relaxation_time_solid({at_once.theta1(), at_once.theta2()}, nip.memory);
  return solve_converged(
      data::ViscoelasticNipProblem{.nip = {data::seed::roller_radius, nip.thickness, solid, 1},
                                   .given = data::GivenLoad{nip.load},
                                   .method = {},
                                   .profile = {}},
      accuracy);
}

inline std::string load_label(double load) { return fmt::format("W = {:g} lbf/in", load); }
inline std::string memory_label(double memory) { return fmt::format("F0 tau = {:g} in", memory); }
inline std::string thickness_label(double thickness) { return fmt::format("B = {:g} in", thickness); }
inline std::string friction_label(data::Friction friction) {
  return friction == data::Friction::full ? "no slip" : "complete slip";
}

}  // namespace nipref::verify
