#pragma once
#include <span>
#include <string>

#include <nipref/data/problem/elastic_nip.hpp>
#include <nipref/data/problem/friction.hpp>
#include <nipref/verify/replay/replay.hpp>

namespace nipref::verify {

/// What a table of the elastic nip was computed with.
struct LineLoadTable {
  std::string_view id;
  data::Friction friction;
  int elements_per_side;  ///< the thesis does not state it: the number that reproduces the table
};

/// Thesis III to X.
std::span<const LineLoadTable> line_load_tables();

/// BadInput if it is none of them.
const LineLoadTable& line_load_table(const std::string& id);

/// Replays a table of the elastic nip (thesis III-X): each row from its printed contact length, with full
/// friction (III-VI) from its printed creep too, with `elements_per_side` line loads a side, at the material
/// constants that reproduce the tables. A length that is not printed is taken from L/B.
Replay replay_line_loads(data::Table table, data::Friction friction, int elements_per_side);

/// The nip of such a table at those constants, seed::sheet_of_the_tables.
data::ElasticNip nip_of_the_tables(const data::Table& table);

}  // namespace nipref::verify
