#pragma once
#include <nipref/data/problem/line_loads.hpp>
#include <nipref/data/problem/viscoelastic_nip.hpp>
#include <nipref/fast/nip/line_loads.hpp>

namespace nipref::fast {

/// (7.6)-(7.11) for a given leading length L1, > 0 and at most the roller's radius, with at most 500 elements on a side,
/// on the other as many unless that is told; otherwise BadInput. Displacements are those of the points that have come to Y
/// since the loads started: BadInput "y" so far ahead that a point is there before the start.
LineLoadNip line_loads_for_length(const data::ViscoelasticNip& nip, const data::ViscoelasticLineLoads& method,
                                  double leading_length);

/// The same with the length that carries `load`, found by secants of ln(load) over ln(length) to 1e-10 of the load; > 0,
/// otherwise BadInput.
LineLoadNip line_loads_for_load(const data::ViscoelasticNip& nip, const data::ViscoelasticLineLoads& method,
                                double load);

}  // namespace nipref::fast
