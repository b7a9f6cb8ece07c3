#pragma once
#include <nipref/data/problem/nip.hpp>
#include <nipref/fast/nip/line_loads.hpp>

namespace nipref::fast {

/// The viscoelastic nip by line loads (thesis 7.6-7.11) of a given leading length L1, not contact length, unit of length,
/// > 0 and at most the roller's radius; with 1 to 500 leading and 0 to 500 trailing elements, without a number as many
/// trailing as leading ones. Otherwise BadInput. Displacements are those of the points that have come to Y since the loads
/// started: BadInput "y" so far ahead that a point is there before the start.
LineLoadNip line_loads_for_length(const data::ViscoelasticNip& nip, const data::ViscoelasticLineLoads& method,
                                  double leading_length);

/// The same of the length that carries `load` per unit width, finite and > 0, found to 1e-10 of the load by secants of
/// ln(load) over ln(length). Without a number of trailing elements it is the first from the leading ones' down that leaves
/// no tension. BadInput also for a load that no length up to the roller's radius is found to carry.
LineLoadNip line_loads_for_load(const data::ViscoelasticNip& nip, const data::ViscoelasticLineLoads& method,
                                double load);

}  // namespace nipref::fast
