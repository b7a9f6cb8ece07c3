#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <nipref/ref/nip/internal/length_search.hpp>
#include <nipref/ref/nip/line_loads.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// The creep ratio that the thesis chooses, and the ends of the range around it that meets its conditions, if known.
struct ThesisCreep {
  Interval chosen;
  std::optional<Interval> lower = {}, upper = {};
};

/// The thesis's creep ratio for the loads at_zero + creep per_creep, first the normal, then as many shear loads. It is
/// proven and continuous in the loads. Nothing if there is none or the intervals do not tell it. (thesis, section 5.5)
std::optional<ThesisCreep> thesis_creep(const std::vector<Interval>& at_zero,
                                        const std::vector<Interval>& per_creep);

/// A place Y, as the sum of a distance, unit of length, and a number of half widths of an element.
struct LineLoadPlace {
  mpq_class distance;
  long half_elements;
};

/// The displacement of the surface by one of the loads of a contact at a place other than the load's: towards the
/// middle plane if `is_normal`, otherwise along Y relative to a point that is the same for all places.
using UnderLoad = std::function<Interval(const SolvedLineLoads& loads, std::size_t load,
                                         const LineLoadPlace& place, bool is_normal)>;

/// The contacts of all lengths in an interval. Every number holds for each of them.
struct SolvedLineLoads {
  double roller_radius;
  int leading_elements;
  bool is_symmetric;  ///< about Y = 0
  Interval contact_length;
  Interval indentation;
  std::vector<Interval> normal,
      shear;        ///< force per unit width, from the leading end on; no shear without friction
  Float error;      ///< largest error of an unknown over the largest unknown
  Float condition;  ///< condition number of the matrix
  int unknowns;
  UnderLoad under;
  int systems = 1;
  std::optional<Interval> gripped_creep = {};
  /// With full friction, in any unit: the normal and then the shear loads of one side, from the middle outwards, at
  /// creep 0, and what a creep of 1 adds.
  std::vector<Interval> at_zero = {}, per_creep = {};

  [[nodiscard]] int elements() const { return static_cast<int>(normal.size()); }
  /// The place of a load in half widths of an element from the line through the centres, positive on the leading side.
  [[nodiscard]] long half_elements_to(std::size_t load) const {
    return 2L * (leading_elements - static_cast<long>(load)) - 1;
  }
  /// The length of a number of half widths of an element.
  [[nodiscard]] Interval length(long half_elements) const {
    return half_elements * contact_length / (2L * elements());
  }
  [[nodiscard]] Interval leading_length() const { return length(2L * leading_elements); }
  [[nodiscard]] Interval trailing_length() const { return length(2L * (elements() - leading_elements)); }
  /// d0 - Y^2/(2R)
  [[nodiscard]] Interval on_roller(const Interval& y) const;
  /// The moment of the loads whose Y has the sign `side`.
  [[nodiscard]] Interval moment(int side) const;
  /// The distance from a load to a place, unit of length.
  [[nodiscard]] Interval distance(std::size_t load, const LineLoadPlace& place) const;
  [[nodiscard]] Interval load() const;
  /// The displacement under all loads.
  [[nodiscard]] Interval displacement(const LineLoadPlace& place, bool is_normal) const;
  /// Whether no normal load is negative; empty if the bounds do not tell.
  [[nodiscard]] std::optional<bool> presses_everywhere() const;
};

/// Extra digits of the influences beyond those of the results: the first and the largest number that is tried.
struct ExtraDigits {
  int first, most;
};

/// Returns contact_at(digits of influences), with the extra digits doubled until `enough` accepts the contact or,
/// without `enough`, until the error of the unknowns is small enough. Nothing if this is not reached.
std::optional<LineLoadNip> solved_to(
    int digits, const ExtraDigits& extra,
    const std::function<std::optional<SolvedLineLoads>(int influence_digits)>& contact_at,
    const std::function<bool(const SolvedLineLoads&)>& enough = {});

}  // namespace nipref::ref
