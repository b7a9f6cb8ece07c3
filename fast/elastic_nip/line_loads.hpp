#pragma once
#include <optional>
#include <vector>

#include <nipref/data/problem/elastic_nip.hpp>
#include <nipref/fast/nip/work.hpp>
#include <nipref/fast/number/accuracy.hpp>

// The elastic nip with its tractions gathered in line loads: the contact is cut into 2m equal elements, each
// element's forces act at its centre, and the sheet is held to the cylinder at the ends of the contact and
// midway between the loads. (thesis 5.1-5.16) One symmetric half is solved, from 2m values of each kernel.
//
// This is what the thesis computed, not the converged contact (converged.hpp): without friction the
// scheme's own error falls like ln(m)/m only (contact length at a given load); with friction it does not
// converge at all at a given creep.
//
// Y is the distance along the sheet from the middle of the nip.

namespace nipref::fast {

/// How the line loads are computed.
struct LineLoadMethod {
  int elements_per_side;  ///< m, 1 to 10000, otherwise BadInput
  /// 0: the library's kernels at `accuracy`. N > 0: the first N residues of each kernel as the thesis sums
  /// them, at most most_residue_terms of plain_series.hpp; right only where elements are wide, N a/b > 10.
  int residue_terms;
  Accuracy accuracy;

  /// Implicit, as the number of elements alone says what is usually meant.
  LineLoadMethod(int elements, int residues = 0, Accuracy kernels = {})
      : elements_per_side(elements), residue_terms(residues), accuracy(kernels) {}

  /// Throws BadInput unless the numbers are in their domains.
  void check() const;
};

struct LineLoadSolution {
  double contact_length;           ///< L, unit of length
  double indentation;              ///< d0, approach of cylinder and centre line, unit of length
  double edge_displacement;        ///< d1 = d0 - L^2/(8R), normal displacement at the ends, unit of length
  double load;                     ///< W, force per unit width: the sum of the normal line loads
  double peak_pressure;            ///< largest normal line load over the element width, unit of stress
  std::vector<double> line_loads;  ///< normal, one side, from the centre outwards; the other side mirrors it
  double peak_shear = 0;           ///< the same of the shear loads' sizes
  /// Along Y on the sheet, the side Y > 0, from the centre outwards; opposite on the other side. Empty
  /// without friction.
  std::vector<double> shear_loads = {};
  /// With full friction: the creep ratio it was solved for, dimensionless.
  std::optional<double> gripped_creep = {};

  /// Width 2a of an element, unit of length.
  [[nodiscard]] double element_width() const {
    return contact_length / (2 * static_cast<double>(line_loads.size()));
  }
};

/// How the contact length is sought that carries a load.
struct LoadSearch {
  enum class Iteration {
    fast,   ///< secants of ln W over ln L
    thesis  ///< L <- L (W/W(L))^(1/3) alone (thesis 2.13): a digit takes about two solves
  };
  Iteration iteration = Iteration::fast;
  /// Relative, of the load, as far as rounding allows. 1e-14 to 0.1, otherwise BadInput. The thesis's tables
  /// stopped near 2e-3.
  double tolerance = 0x1p-46;
};

// In what follows, what a call evaluates and solves is added to `work` if that is given.

/// Without friction (the thesis's Case B): the solution whose contact has the given length, finite, > 0 and
/// such that half an element spans at most 300 half-thicknesses, beyond which the kernels underflow; BadInput
/// otherwise. Evaluates I1 only. With half an element wider than about 1.2 half-thicknesses the loads are
/// nonsense: the kernel has changed its sign between one load and the next.
LineLoadSolution line_loads_for_length(const data::ElasticNip& nip, const LineLoadMethod& method,
                                       double contact_length, Work* work = nullptr);

/// The same for a given load per unit width, > 0 and finite; BadInput otherwise, or if the contact length
/// would be out of its domain.
LineLoadSolution line_loads_for_load(const data::ElasticNip& nip, const LineLoadMethod& method, double load,
                                     const LoadSearch& search = {}, Work* work = nullptr);

/// Creep ratio, dimensionless. Without friction (2/L) v(L/2), v the tangential displacement of the surface
/// relative to the middle of the nip, at the cost of 2m values of I3 (thesis 5.16); with friction the one
/// that was solved for.
double creep_ratio(const data::ElasticNip& nip, const LineLoadSolution& solution,
                   const LineLoadMethod& method, Work* work = nullptr);

}  // namespace nipref::fast
