#pragma once
#include <nipref/verify/seeds/internal/formula.hpp>

namespace nipref::verify {

/// Computes what formulas name in brackets, [KIND NAME KEY=VALUE ...]; the values are formulas without spaces:
///   - ref, fast, printed: a quantity of the catalogue by ref, by fast, or as the seed prints it. Its arguments are decimal
///     texts as on the command line; $x is the value of x;
///   - elastic, rolling: a result of a converged contact by fast. Keys: radius, thickness, load or length, accuracy, `at`
///     for the place of a distribution, and young, poisson, friction or solid, memory; the nip of the thesis is default;
///   - material: a number of a viscoelastic solid. Keys: solid, memory, p;
///   - thin_solid: leading_share or resistance of computed.hpp. Key: memory;
///   - table ID COLUMN KEY=VALUE: what the seed's table prints in the row with that value in the column KEY;
///   - computed: what has code of its own.
/// A contact is solved once for all of its results.
[[nodiscard]] Formulas::Solve solved_numbers();

}  // namespace nipref::verify
