#pragma once
#include <nipref/data/problem/line_loads.hpp>
#include <nipref/data/problem/viscoelastic_nip.hpp>
#include <nipref/ref/nip/line_loads.hpp>

namespace nipref::ref {

/// Of the exact values of the doubles that describe the nip; the material must have real rates. Proven:
/// ref/viscoelastic_nip/README.md, Rolling line loads. digits: 16 to 30, otherwise BadInput, as for more than 100
/// elements on a side, a start farther than 500 half-thicknesses ahead, a smallest_term, a length or load out of its
/// domain, or a load that no length up to the roller's radius is found to carry. Displacements are those of the points
/// that have come to Y since the loads started: BadInput "y" so far ahead that a point is there before.
LineLoadNip line_loads_for_length(const data::ViscoelasticNip& nip, const data::ViscoelasticLineLoads& method,
                                  double contact_length, int digits);
LineLoadNip line_loads_for_load(const data::ViscoelasticNip& nip, const data::ViscoelasticLineLoads& method,
                                double load, int digits);

}  // namespace nipref::ref
