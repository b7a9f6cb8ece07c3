#pragma once
#include <vector>

#include "data/elastic_nip.hpp"
#include "fast/accuracy.hpp"

namespace nipref::fast {

/// Frictionless elastic nip (Case B) with the pressure gathered in line loads: the contact is cut into 2m
/// equal elements, each element's force acts at its centre, and the sheet follows the cylinder at the ends of
/// the contact and midway between the loads. (thesis 5.1-5.4, 5.11-5.13)
///
/// The scheme's own error falls like ln(m)/m only (contact length at a given load): this is what the thesis
/// computed, not the converged contact.
struct LineLoadSolution {
  double contact_length;           ///< L, unit of length
  double indentation;              ///< d0, approach of cylinder and centre line, unit of length
  double edge_displacement;        ///< d1 = d0 - L^2/(8R), normal displacement at the ends, unit of length
  double load;                     ///< W, force per unit width: the sum of the line loads
  double peak_pressure;            ///< largest line load over the element width, unit of stress
  std::vector<double> line_loads;  ///< one side, from the centre outwards; the other side mirrors it
};

/// The solution whose contact has the given length. One symmetric half is solved: m + 1 unknowns, 2m kernel
/// values. `elements_per_side` is m, 1 to 10000; `contact_length` > 0 and finite; `accuracy` that of the
/// kernels. data::BadInput otherwise.
LineLoadSolution line_loads_for_length(const data::ElasticNip& nip, int elements_per_side,
                                       double contact_length, Accuracy accuracy = {});

/// The solution that carries `load` per unit width, > 0 and finite (same errors as above). The length is
/// found from W(L), which rises, by bracketing from the estimate L (W/W_0)^(1/3) of (thesis 2.13), to 2^-48
/// relatively.
LineLoadSolution line_loads_for_load(const data::ElasticNip& nip, int elements_per_side, double load,
                                     Accuracy accuracy = {});

/// Creep ratio (2/L) v(L/2) of a frictionless solution, v the tangential displacement of the surface relative
/// to the middle of the nip; dimensionless. The only function here that evaluates tangential kernels.
/// (thesis 5.16)
double creep_ratio(const data::ElasticNip& nip, const LineLoadSolution& solution, Accuracy accuracy = {});

}  // namespace nipref::fast
