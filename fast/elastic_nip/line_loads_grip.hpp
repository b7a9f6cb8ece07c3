#pragma once
#include <optional>
#include <vector>

#include <nipref/fast/elastic_nip/line_loads.hpp>

// Line loads with full friction, the thesis's Case A: v = creep * Y at the matching points. (thesis 5.5-5.10)
// The creep is not part of the solution here; the thesis chose it by conditions on the tractions. At a given
// creep the loads zigzag more and more as m grows, and their sum goes nowhere; the creep that the conditions
// leave tends to that of the continuous contact like 1/m. Domains and `work` as in line_loads.hpp;
// creep: dimensionless, finite, otherwise BadInput.

namespace nipref::fast {

/// The solution of given length and creep. Evaluates I1, I3 and I6, 2m values each. The matrix is
/// singular at single lengths, such as L/B = 0.3 for m = 2, 0.1 for m = 20, or half an element of 0.8
/// half-thicknesses, and next to them the loads are nonsense: condition_number tells.
LineLoadSolution gripped_line_loads_for_length(const data::ElasticNip& nip, const LineLoadMethod& method,
                                               double contact_length, double creep, Work* work = nullptr);

/// The solution of given load and creep whose length is nearest to that without friction. BadInput if the
/// search leads to loads that are not positive: at a given creep the load need not rise with the length.
LineLoadSolution gripped_line_loads_for_load(const data::ElasticNip& nip, const LineLoadMethod& method,
                                             double load, double creep, const LoadSearch& search = {},
                                             Work* work = nullptr);

/// Creep ratios from `lower` to `upper`, dimensionless.
struct CreepRange {
  double lower;
  double upper;
};

/// Which of the thesis's conditions a creep ratio has to meet.
struct CreepConditions {
  bool monotone_ratio = true;  ///< |Q_k|/P_k does not fall outwards (2.4)
};

/// The creep ratios for which no P_k is negative (2.1), the Q_k of one side have one sign (2.3) and
/// `conditions` are met: disjoint ranges, rising; none if there is no such creep. The loads being affine in
/// the creep, the limits are roots of linear and quadratic functions, found from one factorisation.
std::vector<CreepRange> creep_ranges(const data::ElasticNip& nip, const LineLoadMethod& method,
                                     double contact_length, const CreepConditions& conditions = {},
                                     Work* work = nullptr);

/// The thesis's own creep, of the least size among the ranges, and the range that it is in, of which it is an end
/// unless it is 0. (thesis 5.5, Figure 15)
struct ThesisCreep {
  CreepRange range;
  double chosen;
};

/// Nothing if there is none.
std::optional<ThesisCreep> thesis_creep(const data::ElasticNip& nip, const LineLoadMethod& method,
                                        double contact_length, Work* work = nullptr);

/// The solution of given length and the thesis's own creep: of the least size among the ranges; nothing if
/// there is none. (thesis 5.5)
std::optional<LineLoadSolution> thesis_line_loads_for_length(const data::ElasticNip& nip,
                                                             const LineLoadMethod& method,
                                                             double contact_length, Work* work = nullptr);

/// The same for a given load, sought from the length without friction; nothing if a length on the way has no
/// such creep.
std::optional<LineLoadSolution> thesis_line_loads_for_load(const data::ElasticNip& nip,
                                                           const LineLoadMethod& method, double load,
                                                           const LoadSearch& search = {},
                                                           Work* work = nullptr);

}  // namespace nipref::fast
