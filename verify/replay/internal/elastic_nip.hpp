#pragma once
#include <span>
#include <string>

#include <nipref/data/problem/elastic_nip.hpp>
#include <nipref/data/problem/friction.hpp>
#include <nipref/verify/replay/replay.hpp>

namespace nipref::verify {

/// The method by which a table of the elastic nip was computed.
struct LineLoadTable {
  std::string_view id;
  data::Friction friction;
  int elements_per_side;  ///< the number that reproduces the table; the thesis does not state it
};

/// Thesis III to X.
std::span<const LineLoadTable> line_load_tables();

/// The method of one table. BadInput if `id` is none of them.
const LineLoadTable& line_load_table(const std::string& id);

/// Replays a table of the elastic nip (thesis III-X) by `elements_per_side` line loads on each side. The inputs of a
/// row are its printed contact length and, with full friction (III-VI), its printed creep. A length that is not
/// printed follows from L/B. The material constants are those that reproduce the tables.
Replay replay_line_loads(data::Table table, data::Friction friction, int elements_per_side);

/// The nip of such a table with these constants, seed::sheet_of_the_tables.
data::ElasticNip nip_of_the_tables(const data::Table& table);

}  // namespace nipref::verify
