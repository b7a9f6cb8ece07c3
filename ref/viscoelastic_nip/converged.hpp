#pragma once
#include <nipref/data/problem/nip.hpp>
#include <nipref/ref/nip/converged.hpp>

namespace nipref::ref {

/// Contact of a viscoelastic nip in steady frictionless rolling, of the given length: L <= R, 1e-6 <= L/B <= 1000; digits:
/// 16 to 30. What an elastic sheet would do in the contact follows from the known displacement by the inverse compliance,
/// so that the pressure is that of an elastic contact with other right-hand sides (internal/rolling_sheet.cpp). Proven:
/// ref/viscoelastic_nip/README.md, Rolling contacts.
///
/// BadInput otherwise, naming "nip.material" for rates whose imaginary part is more than 10 times the real one, and for
/// relaxation lengths (speed over rate) below 1e-8 contacts or above 1e8 of them, and naming "digits" where 1400 unknowns
/// do not give them.
ConvergedNip converged_for_length(const data::ViscoelasticNip& nip, double contact_length, int digits);

/// Contact that carries `load` per unit width, > 0 and finite, whose length is as above; BadInput otherwise.
ConvergedNip converged_for_load(const data::ViscoelasticNip& nip, double load, int digits);

/// The number of unknowns that the contact of a length is solved for at first; its cost grows with their square. BadInput
/// likewise.
int rolling_unknowns(const data::ViscoelasticNip& nip, double contact_length, int digits);

}  // namespace nipref::ref
