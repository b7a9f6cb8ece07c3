#pragma once
#include <nipref/data/problem/nip.hpp>
#include <nipref/ref/nip/line_loads.hpp>

namespace nipref::ref {

/// The viscoelastic nip by line loads, of a contact length L, > 0 and at most the roller's radius, unit of length, or
/// of a load per unit width, finite and > 0. Its doubles are taken exactly; digits: 16 to 30. Proven:
/// ref/viscoelastic_nip/README.md, Rolling line loads. BadInput otherwise, and for rates that are not real, more than
/// 100 elements on a side, a start farther than 500 half-thicknesses ahead, a smallest_term other than 0, or a load for
/// which no length up to the roller's radius is found. Displacements are those of the material points that have come to
/// Y since the loads started; BadInput "y" for a Y ahead of where the leading end started.
LineLoadNip line_loads_for_length(const data::ViscoelasticNip& nip, const data::ViscoelasticLineLoads& method,
                                  double contact_length, int digits);
LineLoadNip line_loads_for_load(const data::ViscoelasticNip& nip, const data::ViscoelasticLineLoads& method,
                                double load, int digits);

}  // namespace nipref::ref
