#pragma once
#include <optional>
#include <vector>

#include <nipref/data/problem/nip.hpp>
#include <nipref/ref/material/exact_material.hpp>
#include <nipref/ref/nip/internal/proven_contact.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

/// The terms a e^(-r w) of N over its instantaneous part, by rising rates, with a > 0, r >= 0 and w the distance
/// travelled in half-thicknesses; the largest relative error of a and r; and the instantaneous part, 1/stress. Nothing
/// unless all rates are real and all amplitudes are positive.
struct ProvenMemories {
  std::vector<ExactFunction::Term> terms;
  mpq_class error, at_once;
};
std::optional<ProvenMemories> proven_memories(const data::ViscoelasticNip& nip);

/// The frictionless contact in steady rolling for all half lengths of an interval, to about `digits` digits at the
/// working precision. Nothing if that takes too many points. Proven: ref/viscoelastic_nip/README.md, Rolling contacts.
std::optional<ProvenContact> proven_rolling(const ProvenMemories& memories, const Interval& half_length,
                                            int digits);
/// The contact that carries a load: contacts a little shorter and longer are proven to carry less and more. `near` is
/// the half length to some ten digits, `growth` is d ln W/d ln A.
std::optional<ProvenContact> proven_rolling_for_load(const ProvenMemories& memories, const Exact& load,
                                                     const Float& near, const Float& growth, int digits);
/// The working precision that these proofs need, in digits.
int proven_rolling_working_digits(const ProvenMemories& memories, double half_length, int digits);

}  // namespace nipref::ref
