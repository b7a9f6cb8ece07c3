#pragma once
#include <optional>
#include <vector>

#include <nipref/data/problem/nip.hpp>
#include <nipref/ref/memory/moving_load.hpp>
#include <nipref/ref/nip/internal/solved_line_loads.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// A nip, known exactly, and its method with the number of trailing elements. `digits` are those of the influences.
struct RollingLoads {
  data::ViscoelasticNip nip;
  MovingLoad moving_load;
  mpq_class memory_error;  ///< relative error of its memory
  int leading, trailing;
  mpq_class approach;
  int digits;

  [[nodiscard]] int loads() const { return leading + trailing; }
  [[nodiscard]] mpq_class half_thickness() const { return mpq_class(nip.sheet_thickness) / 2; }
  /// Half the width of an element of this contact length, in half-thicknesses.
  [[nodiscard]] mpq_class half_element(const mpq_class& contact_length) const {
    return contact_length / (2 * loads() * half_thickness());
  }
  [[nodiscard]] Float instantaneous() const { return to_float(moving_load.normal().instantaneous); }
  /// The time in which the sheet moves by a distance in half-thicknesses.
  [[nodiscard]] Exact time(const mpq_class& distance) const {
    return Exact(mpq_class(distance * half_thickness() / mpq_class(nip.speed)));
  }
};

/// All contacts whose elements have a half width within `spread` of `half_element`, in half-thicknesses. (thesis 7.11)
struct RollingGrid {
  mpq_class half_element, spread;

  /// The length of a number of half widths, in half-thicknesses.
  [[nodiscard]] Interval length(long half_elements) const;
};

/// Nothing if the digits do not suffice to prove that no system of the grid is singular.
std::optional<SolvedLineLoads> solve_loads(const RollingLoads& problem, const RollingGrid& grid);

}  // namespace nipref::ref
