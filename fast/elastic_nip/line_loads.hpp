#pragma once
#include <optional>
#include <span>

#include <nipref/data/problem/nip.hpp>
#include <nipref/fast/nip/line_loads.hpp>
#include <nipref/fast/number/accuracy.hpp>

// The elastic nip by 2m line loads. (thesis 5.1-5.16) One symmetric half is solved, from 2m values of each kernel: I1
// alone without friction (the thesis's Case B), I1, I3 and I6 with full friction, v = creep Y at the matching points
// (Case A). Results that are asked for later take 2m values for each place.
//
// This is what the thesis computed, not the converged contact (converged.hpp). Without friction the discretisation
// error falls only like ln(m)/m (contact length at a given load). With friction the scheme does not converge at a given
// creep: the loads zigzag more and more as m grows, and their sum does not converge. The creep that meets the thesis's
// conditions tends to that of the continuous contact like 1/m.

namespace nipref::fast {

/// How the line loads are computed.
struct LineLoadMethod {
  int elements_per_side;  ///< m, 1 to 10000, otherwise BadInput
  /// 0: the library's kernels at `accuracy`. N > 0: the first N residues of each kernel as the thesis sums
  /// them, at most most_residue_terms of plain_series.hpp; right only where elements are wide, N a/b > 10.
  int residue_terms;
  Accuracy accuracy;

  /// Implicit, because the number of elements alone usually suffices.
  LineLoadMethod(int elements, int residues = 0, Accuracy kernels = {})
      : elements_per_side(elements), residue_terms(residues), accuracy(kernels) {}

  /// Throws BadInput unless the numbers are in their domains.
  void check() const;
};

/// The search for the contact length that carries a load.
struct LoadSearch {
  enum class Iteration {
    fast,   ///< secants of ln W over ln L
    thesis  ///< L <- L (W/W(L))^(1/3) alone (thesis 2.13): a digit takes about two solves
  };
  Iteration iteration = Iteration::fast;
  /// Relative, of the load, if rounding allows it; 1e-14 to 0.1, otherwise BadInput. The thesis stopped near 2e-3.
  double tolerance = 0x1p-46;
};

/// The line loads whose contact has the given length, finite, > 0 and such that half an element spans at most 300
/// half-thicknesses, beyond which the kernels underflow; BadInput otherwise, and where no creep meets the thesis's
/// conditions. With half an element wider than about 1.2 half-thicknesses the loads without friction are nonsense:
/// the kernel has changed its sign between one load and the next. With full friction the matrix is singular at single
/// lengths, such as L/B = 0.3 for m = 2, 0.1 for m = 20, or half an element of 0.8 half-thicknesses, and next to them
/// the loads are nonsense; condition_number shows it. The loads are affine in the creep, so that the limits of its
/// ranges are roots of linear and quadratic functions, found from one factorisation. (thesis 5.5-5.11)
LineLoadNip line_loads_for_length(const data::ElasticNip& nip, const LineLoadMethod& method,
                                  double contact_length, const data::LineLoadFriction& friction = {});

/// The line loads whose contact carries `load` per unit width, > 0 and finite; BadInput otherwise, or if the contact
/// length would be out of its domain. With full friction the search starts from the length without friction; BadInput
/// if the search leads to loads that are not positive (at a given creep the load need not rise with the length), or to
/// a length without a creep that the thesis would choose.
LineLoadNip line_loads_for_load(const data::ElasticNip& nip, const LineLoadMethod& method, double load,
                                const data::LineLoadFriction& friction = {}, const LoadSearch& search = {});

/// The creep that the thesis chooses, the one of least magnitude in the ranges, and its range. The creep is an end of
/// the range unless it is 0. (thesis, section 5.5, Figure 15)
struct ThesisCreep {
  CreepRange range;
  double chosen;
};

/// Nothing if there is no range.
std::optional<ThesisCreep> thesis_creep(std::span<const CreepRange> ranges);

/// Condition number of the matching matrix in the 1-norm, estimated from its factors: infinite if it is singular. In
/// the matrix d0 and the loads times N/pi are lengths, as it is solved. Domains as for line_loads_for_length.
double condition_number(const data::ElasticNip& nip, const LineLoadMethod& method, double contact_length,
                        data::Friction friction);

/// How much a row of loads zigzags: the sum of the sizes of its second differences over the sum of its sizes.
/// About (h/l)^2 for a smooth function of length scale l in steps h, up to 4 if every load pulls against the
/// next; 0 if there are fewer than three, or all are 0.
double oscillation(std::span<const double> loads);

}  // namespace nipref::fast
