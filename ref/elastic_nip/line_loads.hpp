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

/// How the line loads are computed.
struct LineLoadMethod {
  int elements_per_side;  ///< m, 1 to 200
  /// 0: the kernels themselves. N > 0: their first N residues, as plain_series.hpp sums them.
  int residue_terms;

  /// Implicit, as the number of elements alone says what is usually meant.
  LineLoadMethod(int elements, int residues = 0) : elements_per_side(elements), residue_terms(residues) {}
};

/// Every number comes with a proven bound, see Enclosure; of the loads the bounds are relative to the largest
/// unknown of the system and not to each.
struct LineLoadSolution {
  Enclosure contact_length;           ///< L, unit of length
  Enclosure indentation;              ///< d0, unit of length
  Enclosure edge_displacement;        ///< d1 = d0 - L^2/(8R), unit of length
  Enclosure load;                     ///< W, force per unit width
  Enclosure peak_pressure;            ///< largest normal line load over the element width, unit of stress
  Enclosure peak_shear;               ///< the same of the shear loads' sizes; 0 without friction
  std::vector<Enclosure> line_loads;  ///< normal, one side, from the centre outwards
  /// Along Y on the sheet, the side Y > 0, from the centre outwards; empty without friction.
  std::vector<Enclosure> shear_loads;
  std::optional<Enclosure> gripped_creep;  ///< with full friction: the creep ratio it was solved for
  double condition;                        ///< of the matching matrix, in the largest row sum
};

/// What the sheet does on the roller: no friction at all (the thesis's Case B), or none of slip (Case A) with a
/// creep ratio, finite, that is given or chosen as the thesis does: of the least size for which no normal load is
/// negative, the shear loads of a side have one sign and their part of the normal load does not fall outwards.
/// (thesis 5.5)
struct Grip {
  enum class Creep { none, given, thesis } kind = Creep::none;
  double creep = 0;
};

/// Contact length L = `contact_length`, unit of length, > 0 and at most 500 sheet thicknesses; digits 16 to 300. The
/// doubles are taken exactly. BadInput otherwise, and where no creep meets the thesis's conditions or the
/// reference cannot tell. The bounds are those of enclosed_system.hpp; more digits are taken until they are
/// small enough.
LineLoadSolution line_loads_for_length(const data::ElasticNip& nip, const LineLoadMethod& method,
                                       double contact_length, int digits, const Grip& grip = {});

/// The same for a `load` per unit width, > 0 and finite, sought by secants from the length without friction.
/// Proven: at the two ends of an interval of lengths the load is smaller and larger than that, and every length
/// between has a system that is not singular (and a creep that goes with the length continuously), so that some
/// length in it carries the load; the bounds of everything hold for all lengths in it. Not proven is that no
/// other interval has one. BadInput where none is found, as where the loads are not positive.
LineLoadSolution line_loads_for_load(const data::ElasticNip& nip, const LineLoadMethod& method, double load,
                                     int digits, const Grip& grip = {});

/// The creep ratio that the thesis chooses for a contact, and the lowest and the highest around it that meet its conditions
/// as well: see Grip. (thesis 5.5, Figure 15)
struct CreepRange {
  Enclosure lower, upper, chosen;
};

/// For the length of a solved contact, as far as that is known; proven. BadInput "contact_length" where there is none, or
/// the bounds cannot tell.
CreepRange creep_range(const data::ElasticNip& nip, const LineLoadSolution& solution,
                       const LineLoadMethod& method, int digits);

/// Without friction, from given values I1((2q - 1) a/b), q = 1 .. 2m, taken exactly: what a solver that uses
/// these values would find without rounding. Set beside that solver it tells its rounding, beside
/// line_loads_for_length the error of the values. BadInput unless `kernel` has 2m finite values whose system
/// is not singular.
LineLoadSolution line_loads_from_kernel_values(const data::ElasticNip& nip, std::span<const double> kernel,
                                               double contact_length, int digits);

}  // namespace nipref::ref
