#pragma once
#include <optional>

#include <nipref/data/problem/viscoelastic_nip.hpp>
#include <nipref/ref/nip/line_loads.hpp>

namespace nipref::ref {

/// The thesis's discretisation of the viscoelastic nip, line loads that started, all at once, `approach` before the first
/// matching point came into the nip. (thesis 2.2, 7.2)
struct ViscoelasticLineLoadMethod {
  int leading_elements;  ///< m1, 1 to 100
  std::optional<int>
      trailing_elements;  ///< m2, 0 to 100; absent: searched for as the thesis does (section 2.5)
  double approach;        ///< C_L, half-thicknesses, > 0; at most 500 with the contact
  int residue_terms;      ///< of the plain sums, 1 to 500; 0: exact kernels
};

/// Of the exact values of the doubles that describe the nip; the material must have real rates. Proven:
/// ref/viscoelastic_nip/README.md, Rolling line loads. digits: 16 to 30, otherwise BadInput, as for a method, length or
/// load out of its domain, or a load that no length up to the roller's radius is found to carry. Displacements are those
/// of the points that have come to Y since the loads started: BadInput "y" so far ahead that a point is there before.
LineLoadNip line_loads_for_length(const data::ViscoelasticNip& nip, const ViscoelasticLineLoadMethod& method,
                                  double contact_length, int digits);
LineLoadNip line_loads_for_load(const data::ViscoelasticNip& nip, const ViscoelasticLineLoadMethod& method,
                                double load, int digits);

}  // namespace nipref::ref
