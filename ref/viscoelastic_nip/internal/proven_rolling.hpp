#pragma once
#include <optional>
#include <vector>

#include <nipref/data/problem/viscoelastic_nip.hpp>
#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/interval.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_material.hpp>

namespace nipref::ref {

/// A term a e^(-r w) of N over its instantaneous part, w the way in half-thicknesses; a > 0, r >= 0.
struct ProvenMemory {
  mpq_class amplitude, rate;
};

/// The terms by rising rate, what they may be off by as a share of each, and the instantaneous part, 1/stress. Nothing
/// unless all rates are real and all amplitudes are positive.
struct ProvenMemories {
  std::vector<ProvenMemory> terms;
  mpq_class error, at_once;
};
std::optional<ProvenMemories> proven_memories(const data::ViscoelasticNip& nip);

/// The steadily rolling frictionless contact of a half length A, in the units of RollingSolution: lengths in
/// half-thicknesses, pressures times 2 R N_0/b, displacements times 2 R/b^2. Proven: ref/viscoelastic_nip/README.md,
/// Rolling contacts.
struct ProvenRolling {
  Interval half_length;
  Interval offset;  ///< of the contact's middle from the line through the centres, towards the leading side
  Interval edge_displacement;  ///< d1
  std::vector<Interval>
      coefficients;  ///< p = 2A sum_m c_m sin(m theta), A cos(theta) from the middle to the leading side
  Interval radius;   ///< sum m |dc_m|, all m

  [[nodiscard]] Interval load() const;   ///< pi A^2 c_1
  [[nodiscard]] Interval lever() const;  ///< of the resultant from the line through the centres
  /// Whether all of these are known to so many digits of their scale.
  [[nodiscard]] bool is_good_to(int digits) const;
  /// Between the ends, at cos(theta).
  [[nodiscard]] Interval pressure(const Interval& cosine) const;
};

/// For all half lengths of an interval, with about so many digits at the working precision; nothing where that takes too
/// many points.
std::optional<ProvenRolling> proven_rolling(const ProvenMemories& memories, const Interval& half_length,
                                            int digits);
/// The same of a load, for a half length about which loads below and above it are proven: near one that is good to some
/// ten digits, with d ln W/d ln A.
std::optional<ProvenRolling> proven_rolling_for_load(const ProvenMemories& memories, const Exact& load,
                                                     const Float& near, const Float& growth, int digits);
/// The digits that are to be the working precision.
int proven_rolling_working_digits(const ProvenMemories& memories, double half_length, int digits);

}  // namespace nipref::ref
