#pragma once
#include <vector>

#include <nipref/ref/elastic_nip/line_loads.hpp>
#include <nipref/ref/nip/line_load_field.hpp>

namespace nipref::ref {

// What solved line loads do to the surface; all proven. `method`: what they were solved with. Y: along the sheet from
// the middle of the nip, known exactly, unit of length. Bounds are 10^-digits of what is summed, about.

/// Towards the middle plane; BadInput "y" at the place of a line load.
Enclosure normal_displacement(const data::ElasticNip& nip, const LineLoadSolution& solution,
                              const LineLoadMethod& method, double y, int digits);

/// Along Y, against the middle of the nip; the same otherwise.
Enclosure tangential_displacement(const data::ElasticNip& nip, const LineLoadSolution& solution,
                                  const LineLoadMethod& method, double y, int digits);

/// Without friction (2/L) v(L/2) (thesis 5.16); with it the one that was solved for.
Enclosure creep_ratio(const data::ElasticNip& nip, const LineLoadSolution& solution,
                      const LineLoadMethod& method, int digits);

/// The normal, or shear, load of the element around Y over its width, 0 outside the contact; the shear's sign is
/// that along Y. A place within 1e-15 of a border counts to the outer element, but at the end to the last.
Enclosure element_pressure(const LineLoadSolution& solution, double y, int digits);
Enclosure element_shear(const LineLoadSolution& solution, double y, int digits);

/// Y > 0 of the centre of the element with the largest normal load, or shear load in size; from the first to the last
/// that may have it, where the bounds cannot tell.
Enclosure place_of_largest_pressure(const LineLoadSolution& solution, int digits);
Enclosure place_of_largest_shear(const LineLoadSolution& solution, int digits);

/// What the loads are, a pair of both sides after the other from the middle outwards: for the fields inside the sheet, see
/// ref/nip/line_load_field.hpp.
std::vector<FaceLoad> face_loads(const LineLoadSolution& solution, int digits);

/// Where shear loads of opposite signs meet, Y >= 0 rising: the middle first, with friction. Loads whose sign the
/// bounds do not tell are passed over, and the border lies somewhere between the others.
std::vector<Enclosure> shear_borders(const LineLoadSolution& solution, int digits);

}  // namespace nipref::ref
