#pragma once
#include <nipref/fast/elastic_nip/line_loads.hpp>

// What a solution says of the nip at a distance Y, unit of length, from its middle; any finite Y. The loads
// being concentrated, displacements are infinite at them: such a Y is BadInput.

namespace nipref::fast {

/// u(Y), towards the middle plane, unit of length. Even. Evaluates I1, with friction I3 too.
double normal_displacement(const data::ElasticNip& nip, const LineLoadSolution& solution,
                           const LineLoadMethod& method, double y, Work* work = nullptr);

/// v(Y) relative to the middle of the nip, unit of length. Odd. Evaluates I3, with friction I6 too.
double tangential_displacement(const data::ElasticNip& nip, const LineLoadSolution& solution,
                               const LineLoadMethod& method, double y, Work* work = nullptr);

/// Normal line load over the width of the element that Y lies in, unit of stress; 0 outside the contact.
double element_pressure(const LineLoadSolution& solution, double y);

/// Y > 0 of the centre of the element with the largest normal load, or shear load in size, unit of length.
double place_of_largest_pressure(const LineLoadSolution& solution);
double place_of_largest_shear(const LineLoadSolution& solution);

/// Where shear loads of opposite signs meet, Y >= 0 rising: the middle first, with friction. Unit of length.
std::vector<double> shear_borders(const LineLoadSolution& solution);

/// Shear load, positive along Y on the sheet, likewise.
double element_shear(const LineLoadSolution& solution, double y);

}  // namespace nipref::fast
