#pragma once
#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/formulas/internal/formulas.hpp>
#include <nipref/verify/formulas/propagated.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>
#include <nipref/verify/support/internal/toml_table.hpp>

namespace nipref::verify {

/// The words in the brackets of a formula, [KIND NAME ... KEY=VALUE ...]. The values are formulas of the same scope.
struct Brackets {
  std::string text;
  Formulas& formulas;
  std::vector<std::string> names = {};  ///< the kind first
  Assignments given = {};

  Brackets(const std::string& words, Formulas& scope);
  /// Throws BadInput that names the brackets.
  [[noreturn]] void refuse(std::string_view lacking) const;
  [[nodiscard]] const std::string& name(std::size_t i) const;
  /// text_of() is the text of a key and number() its value as a formula. Without `otherwise` the key must be given.
  [[nodiscard]] std::string text_of(const std::string& key, const std::string& otherwise) const;
  [[nodiscard]] double number(const std::string& key, std::optional<double> otherwise = {}) const;
  /// The given values as decimal arguments of a quantity. A value that begins with $ is a formula.
  [[nodiscard]] Assignments arguments() const;
};

/// The result of the contact that the last of the names names.
Propagated result_of(const Brackets& brackets, const SolvedContact<fast::Estimate>& contact);

/// The text with each field {NAME} or {NAME:FORMAT} replaced by written(NAME, ":FORMAT").
std::string with_fields(const std::string& text,
                        const std::function<std::string(const std::string&, const std::string&)>& written);

/// Computes what formulas name in brackets, [KIND NAME KEY=VALUE ...]; the values are formulas without spaces:
///   - ref, fast, printed, double: a quantity of the catalogue by ref, by fast, as the seed prints it, or by fast
///     without an error. Its arguments are decimal texts as on the command line; $x is the value of x;
///   - elastic, rolling: a result of a converged contact by fast. Keys: radius, thickness, load or length, accuracy,
///     `at` for the place of a distribution or the index in a list, and young, poisson, friction or solid, memory,
///     speed. The defaults are the thesis's. Elastic may have mu, Coulomb's coefficient, and traction for friction;
///   - started: mu_R by the thesis's line loads. Keys: thickness, load, memory, and distance, from which they start;
///   - sliding_sphere: a result of the exact contact of (brock2013 4). Keys: direction from x1, degrees, and speed over
///     that of the sphere's shear waves;
///   - material: theta1 or theta2 of a viscoelastic solid at p in the Laplace plane. Keys: solid, memory, p;
///   - table ID COLUMN KEY=VALUE: the number that the seed's table prints in the row with that value in the column KEY;
///   - computed: one of computed_numbers().
/// Copies share their contacts: each contact is solved only once.
class SolvedNumbers {
 public:
  Propagated operator()(const std::string& words, Formulas& formulas) const;
  /// The contact that is asked for, whatever the name of the result.
  [[nodiscard]] const SolvedContact<fast::Estimate>& contact(const Brackets& brackets) const;

 private:
  using Contacts = std::map<std::map<std::string, std::string>, SolvedInDouble>;
  std::shared_ptr<Contacts> contacts_ = std::make_shared<Contacts>();
};

/// Numbers that no formula describes, by name.
const std::map<std::string, std::function<Propagated()>>& computed_numbers();

/// The value of a printed formula in double arithmetic, whose rounding error is not bounded: eight of its sixteen
/// digits are trusted, which is enough to tell it from the truth.
Propagated printed_form(double value);

/// Evaluates the formulas of an entry with the functions of claims.toml, then the definitions of the [[setting]] that
/// the entry names, then its own in `given`.
class StatementFormulas {
 public:
  StatementFormulas(const TomlTable& file, const TomlTable& entry);
  /// Throws BadInput that names the entry's line.
  [[nodiscard]] Propagated value(const std::string& formula);
  [[nodiscard]] bool is_true(const std::string& formula) { return value(formula).value() != 0; }
  void define(const std::string& name, const Propagated& number) { formulas_.define(name, number); }
  /// The text `at` of the setting, which ends the description of what is computed; may be empty.
  [[nodiscard]] const std::string& setting() const { return setting_; }

 private:
  const TomlTable& entry_;
  Formulas formulas_;
  std::string setting_;
};

}  // namespace nipref::verify
