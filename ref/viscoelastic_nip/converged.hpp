#pragma once
#include <nipref/data/problem/nip.hpp>
#include <nipref/ref/nip/converged.hpp>

namespace nipref::ref {

/// The contact of a viscoelastic nip in steady frictionless rolling, of the given length: L <= R, 1e-6 <= L/B <= 1000;
/// digits: 16 to 30. The inverse compliance turns the known displacement in the contact into that of an elastic sheet.
/// So the pressure is that of an elastic contact with other right-hand sides (internal/rolling_sheet.cpp). Proven:
/// ref/viscoelastic_nip/README.md, Rolling contacts.
///
/// BadInput otherwise, naming "nip.material" for rates whose imaginary part is more than 10 times the real one and for
/// relaxation lengths (speed over rate) below 1e-8 or above 1e8 contacts, "digits" if 1400 unknowns do not give them.
ConvergedNip converged_for_length(const data::ViscoelasticNip& nip, double contact_length, int digits);

/// The contact that carries `load` per unit width, > 0 and finite, with a length as above; BadInput otherwise.
ConvergedNip converged_for_load(const data::ViscoelasticNip& nip, double load, int digits);

/// The number of unknowns of the first solution of a contact; the time grows with its square. BadInput as above.
int rolling_unknowns(const data::ViscoelasticNip& nip, double contact_length, int digits);

}  // namespace nipref::ref
