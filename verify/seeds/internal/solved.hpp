#pragma once
#include <functional>
#include <map>
#include <string>

#include <nipref/verify/seeds/internal/formula.hpp>
#include <nipref/verify/seeds/propagated.hpp>
#include <nipref/verify/support/internal/statement.hpp>

namespace nipref::verify {

/// Computes what formulas name in brackets, [KIND NAME KEY=VALUE ...]; the values are formulas without spaces:
///   - ref, fast, printed: a quantity of the catalogue by ref, by fast, or as the seed prints it. Its arguments are decimal
///     texts as on the command line; $x is the value of x;
///   - elastic, rolling: a result of a converged contact by fast. Keys: radius, thickness, load or length, accuracy, `at`
///     for the place of a distribution, and young, poisson, friction or solid, memory; the nip of the thesis is default;
///   - material: a number of a viscoelastic solid. Keys: solid, memory, p;
///   - thin_solid: leading_share or resistance of thin_standard_solid(). Key: memory;
///   - table ID COLUMN KEY=VALUE: what the seed's table prints in the row with that value in the column KEY;
///   - computed: one of computed_numbers().
/// Each contact is solved only once.
[[nodiscard]] Formulas::Solve solved_numbers();

/// A very thin frictionless sheet of the solid with one relaxation time tau that ends up twice as compliant as it
/// begins: springs with N p + (N/tau) int e^(-t/tau) p = 2 u/b, in closed form.
struct ThinStandardSolid {
  Propagated leading_share;  ///< L1/L
  Propagated resistance;     ///< mu_R R/L
};

/// memory: F0 tau/L, > 0.
ThinStandardSolid thin_standard_solid(double memory);

/// Numbers that no formula describes, by name.
const std::map<std::string, std::function<Propagated()>>& computed_numbers();

/// The value of a printed formula in double arithmetic without a bound on its rounding: eight of its sixteen digits are
/// trusted, enough to tell it from the truth.
Propagated printed_form(double value);

/// Evaluates the formulas of an entry, with the definitions of the [[setting]] that it names, then with its own in `given`.
class StatementFormulas {
 public:
  StatementFormulas(const Statement& file, const Statement& entry);
  /// Throws BadInput that names the entry's line.
  [[nodiscard]] Propagated value(const std::string& formula);
  [[nodiscard]] bool is_true(const std::string& formula) { return value(formula).value() != 0; }
  void define(const std::string& name, const Propagated& number) { formulas_.define(name, number); }
  /// The text `at` of the setting, which ends the description of what is computed; may be empty.
  [[nodiscard]] const std::string& setting() const { return setting_; }

 private:
  const Statement& entry_;
  Formulas formulas_;
  std::string setting_;
};

}  // namespace nipref::verify
