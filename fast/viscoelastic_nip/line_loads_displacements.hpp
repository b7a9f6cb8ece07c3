#pragma once
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>

namespace nipref::fast {

// The surface under solved line loads. Y is the distance along the sheet from the line through the rollers'
// centres, positive on the leading side, unit of length; `method` is what `loads` were solved with. BadInput
// otherwise, or for loads that are not as many as its elements.

/// P_j over the width of its element, 0 outside the contact, unit of stress; Y finite.
double element_pressure(const ViscoelasticLineLoads& loads, double y);

/// Displacement towards the middle plane of the point that has come to Y since the loads started; not the
/// place of a line load, and not so far ahead that it is there before the start. (thesis 7.3)
double normal_displacement(const data::ViscoelasticNip& nip, const ViscoelasticLineLoads& loads,
                           const ViscoelasticLineLoadMethod& method, double y);

/// Displacement along Y of that point, relative to the surface at Y = 0; Y as above. (thesis 7.16)
double tangential_displacement(const data::ViscoelasticNip& nip, const ViscoelasticLineLoads& loads,
                               const ViscoelasticLineLoadMethod& method, double y);

}  // namespace nipref::fast
