#pragma once
#include <optional>
#include <span>
#include <vector>

#include <nipref/data/problem/elastic_nip.hpp>
#include <nipref/ref/number/enclosure.hpp>

// The elastic nip with its tractions gathered in line loads, the thesis's discrete systems, in
// multiprecision: the same equations as fast/elastic_nip/line_loads, so that what that loses to its kernels and
// to rounding is known. (thesis 5.1-5.13)

namespace nipref::ref {

/// Every number comes with a proven bound, see Enclosure; of the loads the bounds are relative to the largest
/// unknown of the system and not to each.
struct LineLoadSolution {
  Enclosure indentation;              ///< d0, unit of length
  Enclosure edge_displacement;        ///< d1 = d0 - L^2/(8R), unit of length
  Enclosure load;                     ///< W, force per unit width
  std::vector<Enclosure> line_loads;  ///< normal, one side, from the centre outwards
  /// Along Y on the sheet, the side Y > 0, from the centre outwards; empty without friction.
  std::vector<Enclosure> shear_loads;
  double condition;  ///< of the matching matrix, in the largest row sum
};

/// Without friction (the thesis's Case B): m = `elements_per_side`, 1 to 200; contact length L =
/// `contact_length`, unit of length, > 0 and at most 500 sheet thicknesses; digits 16 to 300. The doubles are
/// taken exactly. BadInput otherwise. The bound: the system is solved with an approximate inverse C, and |x -
/// truth| <= |C (b - A x)|/(1 - |1 - C A|) with the errors of the kernels, of A x and of C A added; more
/// digits are taken until it is small enough.
LineLoadSolution line_loads_for_length(const data::ElasticNip& nip, int elements_per_side,
                                       double contact_length, int digits);

/// With full friction at a given creep ratio (Case A), finite. The same otherwise.
LineLoadSolution gripped_line_loads_for_length(const data::ElasticNip& nip, int elements_per_side,
                                               double contact_length, double creep, int digits);

/// Without friction, from given values I1((2q - 1) a/b), q = 1 .. 2m, taken exactly: what a solver that uses
/// these values would find without rounding. Set beside that solver it tells its rounding, beside
/// line_loads_for_length the error of the values. BadInput unless `kernel` has 2m finite values whose system
/// is not singular.
LineLoadSolution line_loads_from_kernel_values(const data::ElasticNip& nip, std::span<const double> kernel,
                                               double contact_length, int digits);

}  // namespace nipref::ref
