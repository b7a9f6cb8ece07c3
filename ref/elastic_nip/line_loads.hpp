#pragma once
#include <span>
#include <vector>

#include <nipref/data/problem/nip.hpp>
#include <nipref/ref/nip/line_loads.hpp>

// The elastic nip by 2m line loads, one symmetric half of which is solved. (thesis 5.1-5.13)

namespace nipref::ref {

/// How the line loads are computed.
struct LineLoadMethod {
  int elements_per_side;  ///< m, 1 to 200
  /// 0: the kernels themselves. N > 0: their first N residues, as plain_series.hpp sums them.
  int residue_terms;

  /// Implicit, so that a number of elements alone is a method.
  LineLoadMethod(int elements, int residues = 0) : elements_per_side(elements), residue_terms(residues) {}
};

/// Contact length L = `contact_length`, unit of length, > 0 and at most 500 sheet thicknesses; digits 16 to 300. The
/// doubles are taken exactly. BadInput otherwise, and where no creep meets the thesis's conditions or the
/// reference cannot tell. The bounds are those of number/internal/linear_algebra.hpp.
LineLoadNip line_loads_for_length(const data::ElasticNip& nip, const LineLoadMethod& method,
                                  double contact_length, int digits,
                                  const data::LineLoadFriction& friction = {});

/// The same for a `load` per unit width, > 0 and finite. It is proven that some length within the bounds carries it,
/// not that no other does: ref/elastic_nip/README.md. BadInput if none is found, for example if loads are not positive.
LineLoadNip line_loads_for_load(const data::ElasticNip& nip, const LineLoadMethod& method, double load,
                                int digits, const data::LineLoadFriction& friction = {});

/// The contact without friction from given values I1((2q - 1) a/b), q = 1 .. 2m, taken exactly: what a solver that uses
/// these values would find without rounding. The difference from that solver is its rounding error; the difference from
/// line_loads_for_length is due to the errors of the values. BadInput unless `kernel` has 2m finite values whose system
/// is not singular.
LineLoadNip line_loads_from_kernel_values(const data::ElasticNip& nip, std::span<const double> kernel,
                                          double contact_length, int digits);

}  // namespace nipref::ref
