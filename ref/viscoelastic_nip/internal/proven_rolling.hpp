#pragma once
#include <optional>
#include <vector>

#include <nipref/data/problem/nip.hpp>
#include <nipref/ref/material/exact_material.hpp>
#include <nipref/ref/nip/internal/proven_contact.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

/// The terms a e^(-r w) of N over its instantaneous part by rising rate, w the way in half-thicknesses, a > 0, r >= 0; what
/// they may be off by as a share of each, and the instantaneous part, 1/stress. Nothing unless all rates are real and all
/// amplitudes are positive.
struct ProvenMemories {
  std::vector<ExactFunction::Term> terms;
  mpq_class error, at_once;
};
std::optional<ProvenMemories> proven_memories(const data::ViscoelasticNip& nip);

/// The steadily rolling frictionless contact for all half lengths of an interval, with about so many digits at the working
/// precision; nothing where that takes too many points. Proven: ref/viscoelastic_nip/README.md, Rolling contacts.
std::optional<ProvenContact> proven_rolling(const ProvenMemories& memories, const Interval& half_length,
                                            int digits);
/// The same of a load, for a half length about which loads below and above it are proven: near one that is good to some
/// ten digits, with d ln W/d ln A.
std::optional<ProvenContact> proven_rolling_for_load(const ProvenMemories& memories, const Exact& load,
                                                     const Float& near, const Float& growth, int digits);
/// The digits that are to be the working precision.
int proven_rolling_working_digits(const ProvenMemories& memories, double half_length, int digits);

}  // namespace nipref::ref
