#pragma once
#include <vector>

#include <nipref/data/problem/viscoelastic_nip.hpp>
#include <nipref/ref/memory/moving_load.hpp>
#include <nipref/ref/number/internal/float_interval.hpp>

namespace nipref::ref {

/// A nip, known exactly, its method with the number of trailing elements.
struct RollingLoads {
  data::ViscoelasticNip nip;
  ExactMaterial material;
  int leading, trailing;
  mpq_class approach;
  int residue_terms, digits;

  [[nodiscard]] int loads() const { return leading + trailing; }
  [[nodiscard]] mpq_class half_thickness() const { return mpq_class(nip.sheet_thickness) / 2; }
  [[nodiscard]] Float instantaneous() const { return to_float(Exact(material.normal().instantaneous)); }
  /// In which the sheet moves by a distance in half-thicknesses.
  [[nodiscard]] Exact time(const mpq_class& distance) const {
    return Exact(mpq_class(distance * half_thickness() / mpq_class(nip.speed)));
  }
};

/// Lengths in half-thicknesses. (thesis 7.11)
struct RollingGrid {
  mpq_class element;  ///< half the width of an element
  mpq_class approach;
  int leading;

  [[nodiscard]] mpq_class t(int i) const { return 2 * i * element + approach; }
  [[nodiscard]] mpq_class T(int j) const { return (2 * j + 1) * element + approach; }
  /// Of a load from the line through the centres, towards the leading side.
  [[nodiscard]] mpq_class position(int j) const { return (2 * leading - 1 - 2 * j) * element; }
};

/// The contact of one leading length.
struct LoadsOnLength {
  Float leading_length;
  RollingGrid grid;
  Interval indentation;         ///< over b
  std::vector<Interval> loads;  ///< times the instantaneous compliance over b
};

/// Displacement over the instantaneous compliance of a unit load that is under the point at T, seen at t; the tangential
/// one since t0. (thesis 6.26, 6.27)
Interval normal_at(const RollingLoads& problem, const mpq_class& t, const mpq_class& T);
Interval tangential_at(const RollingLoads& problem, const mpq_class& t, const mpq_class& T,
                       const mpq_class& t0);

/// BadInput if its system is too near to singular.
LoadsOnLength solve_loads(const RollingLoads& problem, const Float& leading_length);

Interval half_thickness_of(const RollingLoads& problem);

/// Force per unit width of what counts as LoadsOnLength::loads do.
Interval force_unit(const RollingLoads& problem);

Interval load_of(const RollingLoads& problem, const LoadsOnLength& contact);

bool presses_everywhere(const LoadsOnLength& contact);

/// Two lengths next to the one that carries a load, and how far the last is from it.
struct FoundLength {
  LoadsOnLength last, before;
  Float missing;
  int systems;
};

/// By secants of ln W over ln L1 from `length` until W is within 10^-digits of the load. BadInput if no length below the
/// roller's radius carries it.
FoundLength search_length(const RollingLoads& problem, Float length, double load, int digits);

}  // namespace nipref::ref
