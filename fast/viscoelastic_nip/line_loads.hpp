#pragma once
#include <nipref/data/problem/nip.hpp>
#include <nipref/fast/nip/line_loads.hpp>

namespace nipref::fast {

/// The viscoelastic nip by line loads (thesis 7.6-7.11) of a given leading length L1 (not contact length), unit of
/// length, > 0 and at most the roller's radius, with 1 to 500 leading and 0 to 500 trailing elements; otherwise
/// BadInput. If no number of trailing elements is given, it is that of the leading ones. Displacements are those of the
/// points that have come to Y since the loads started; BadInput "y" if a point is there before the start.
LineLoadNip line_loads_for_length(const data::ViscoelasticNip& nip, const data::ViscoelasticLineLoads& method,
                                  double leading_length);

/// That nip of the length that carries `load` per unit width, finite and > 0, found to 1e-10 of the load by secants of
/// ln(load) over ln(length). If no number of trailing elements is given, it is the first from that of the leading ones
/// down that leaves no tension. BadInput also for a load for which no length up to the roller's radius is found.
LineLoadNip line_loads_for_load(const data::ViscoelasticNip& nip, const data::ViscoelasticLineLoads& method,
                                double load);

}  // namespace nipref::fast
