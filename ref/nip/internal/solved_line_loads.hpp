#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <nipref/ref/nip/internal/length_search.hpp>
#include <nipref/ref/nip/line_loads.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// The creep ratio of Grip::Creep::thesis, and the lowest and the highest of those around it that meet the conditions as
/// well, where the intervals tell these.
struct ThesisCreep {
  Interval chosen;
  std::optional<Interval> lower = {}, upper = {};
};

/// The loads are at_zero + creep per_creep, the normal ones before as many shear loads. Nothing if there is none, or if the
/// intervals do not tell which: otherwise it is proven, and goes with the loads continuously. (thesis, section 5.5)
std::optional<ThesisCreep> thesis_creep(const std::vector<Interval>& at_zero,
                                        const std::vector<Interval>& per_creep);

/// A place Y: a distance, unit of length, and so many half widths of an element from the line through the rollers'
/// centres.
struct LineLoadPlace {
  mpq_class distance;
  long half_elements;
};

/// What the surface of a sheet does under one of the loads of a contact, not at the place of the load: towards the middle plane
/// if `is_normal`, otherwise along Y from a point that is the same for all places.
using UnderLoad = std::function<Interval(const SolvedLineLoads& loads, std::size_t load,
                                         const LineLoadPlace& place, bool is_normal)>;

/// The contacts of all lengths in an interval: what is so for each of them.
struct SolvedLineLoads {
  double roller_radius;
  int leading_elements;
  bool is_symmetric;  ///< about Y = 0
  Interval contact_length;
  Interval indentation;
  std::vector<Interval> normal,
      shear;        ///< force per unit width, from the leading end on; no shear without friction
  Float error;      ///< the largest of an unknown over the largest unknown
  Float condition;  ///< of the matrix
  int unknowns;
  UnderLoad under;
  int systems = 1;
  std::optional<Interval> gripped_creep = {};
  /// With full friction, of one side from the middle outwards, in any unit: the normal loads and then the shear loads
  /// of the creep 0, and what a creep of 1 adds.
  std::vector<Interval> at_zero = {}, per_creep = {};

  [[nodiscard]] int elements() const { return static_cast<int>(normal.size()); }
  /// Half widths of an element from the line through the centres to a load's place, towards the leading side.
  [[nodiscard]] long half_elements_to(std::size_t load) const {
    return 2L * (leading_elements - static_cast<long>(load)) - 1;
  }
  /// So many half widths of an element.
  [[nodiscard]] Interval length(long half_elements) const {
    return half_elements * contact_length / (2L * elements());
  }
  [[nodiscard]] Interval leading_length() const { return length(2L * leading_elements); }
  [[nodiscard]] Interval trailing_length() const { return length(2L * (elements() - leading_elements)); }
  /// d0 - Y^2/(2R)
  [[nodiscard]] Interval on_roller(const Interval& y) const;
  /// Of the loads on the side of this sign.
  [[nodiscard]] Interval moment(int side) const;
  /// From a load's place to another, unit of length.
  [[nodiscard]] Interval distance(std::size_t load, const LineLoadPlace& place) const;
  [[nodiscard]] Interval load() const;
  /// Under all loads.
  [[nodiscard]] Interval displacement(const LineLoadPlace& place, bool is_normal) const;
  /// No normal load is negative; nothing where the bounds do not tell.
  [[nodiscard]] std::optional<bool> presses_everywhere() const;
};

/// Digits beyond those asked for, with which to begin and to end; arithmetic has some more.
struct ExtraDigits {
  int first, most;
};

/// contact_at(digits of influences), with more and more digits until it is `enough`: without that, until the error of the unknowns
/// is small enough for the digits. Nothing where that does not come about.
std::optional<LineLoadNip> solved_to(
    int digits, const ExtraDigits& extra,
    const std::function<std::optional<SolvedLineLoads>(int influence_digits)>& contact_at,
    const std::function<bool(const SolvedLineLoads&)>& enough = {});

}  // namespace nipref::ref
