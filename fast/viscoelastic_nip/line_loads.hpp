#pragma once
#include <optional>

#include <nipref/data/problem/viscoelastic_nip.hpp>
#include <nipref/fast/nip/line_loads.hpp>

namespace nipref::fast {

/// The thesis's discretisation of the viscoelastic nip: line loads that started, all at once, `approach` before the first
/// matching point came into the nip. (thesis 2.2, 7.2)
struct ViscoelasticLineLoadMethod {
  int leading_elements;  ///< m1, >= 1; at most 500
  /// m2, >= 0; at most 500. Absent: from m1 down the first that leaves no tension under the load; under a given
  /// length m1. (thesis 2.5)
  std::optional<int> trailing_elements;
  double approach;    ///< C_L, half-thicknesses, > 0
  int residue_terms;  ///< of the plain sums, 1 to 500; 0: exact kernels
  /// Of theta1 + theta2 at once, 0 to 1: the plain sum after the load has passed ends with its first term below it.
  double smallest_term = 0;

  /// BadInput unless all are in their domains.
  void check() const;
};

/// (7.6)-(7.11) for a given leading length L1, > 0 and at most the roller's radius; otherwise BadInput. Displacements
/// are those of the points that have come to Y since the loads started: BadInput "y" so far ahead that a point is
/// there before the start.
LineLoadNip line_loads_for_length(const data::ViscoelasticNip& nip, const ViscoelasticLineLoadMethod& method,
                                  double leading_length);

/// The same with the length that carries `load`, found by secants of ln(load) over ln(length) to 1e-10 of the load; > 0,
/// otherwise BadInput.
LineLoadNip line_loads_for_load(const data::ViscoelasticNip& nip, const ViscoelasticLineLoadMethod& method,
                                double load);

}  // namespace nipref::fast
