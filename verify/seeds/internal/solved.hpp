#pragma once
#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/seeds/propagated.hpp>
#include <nipref/verify/solve/internal/methods.hpp>
#include <nipref/verify/support/internal/formulas.hpp>
#include <nipref/verify/support/internal/toml_table.hpp>

namespace nipref::verify {

/// Besides the functions of Propagated: certain(x), 1 if x is positive beyond its error, otherwise 0; within(e), 0 with the
/// error e; exactly(x), x without its error.
template <>
struct FormulaWords<Propagated> {
  using OfOne = verify::OfOne;
  using OfTwo = verify::OfTwo;
  static Propagated pi() { return Propagated::pi(); }
  static Propagated exact(double value) { return Propagated::exact(value); }
  static double value(const Propagated& x) { return x.value(); }
  static const std::map<std::string, OfOne*> of_one;
  static const std::map<std::string, OfTwo*> of_two;
  static const std::map<std::string, FormulaFunctional<Propagated>> functionals;
};
using StatedFormulas = Formulas<Propagated>;

/// The words of a formula's brackets: names, the kind of number first, and KEY=VALUE.
struct NumberWords {
  std::string text;
  std::vector<std::string> names;
  Assignments given;

  explicit NumberWords(const std::string& words);
  /// Throws BadInput that names the brackets.
  [[noreturn]] void refuse(std::string_view lacking) const;
  [[nodiscard]] const std::string& name(std::size_t i) const;
  [[nodiscard]] const std::string& value(const std::string& key) const;
  [[nodiscard]] const std::string* find(const std::string& key) const;  ///< null if it is not given
  /// The given values as decimal arguments of a quantity; what follows $ is a formula, which `value_of` evaluates.
  [[nodiscard]] Assignments arguments(const std::function<double(const std::string&)>& value_of) const;
};

/// The text with each field {NAME} or {NAME:FORMAT} replaced by written(NAME, ":FORMAT").
std::string with_fields(const std::string& text,
                        const std::function<std::string(const std::string&, const std::string&)>& written);

/// Computes what formulas name in brackets, [KIND NAME KEY=VALUE ...]; the values are formulas without spaces:
///   - ref, fast, printed: a quantity of the catalogue by ref, by fast, or as the seed prints it. Its arguments are decimal
///     texts as on the command line; $x is the value of x;
///   - elastic, rolling: a result of a converged contact by fast. Keys: radius, thickness, load or length, accuracy, `at`
///     for the place of a distribution or the index in a list, and young, poisson, friction or solid, memory, speed; by
///     default as in the thesis. In place of friction an elastic one may have mu, Coulomb's coefficient, and traction;
///   - started: mu_R by the thesis's line loads. Keys: thickness, load, memory, and distance, from which they start;
///   - sliding_sphere: a result of the exact contact of (brock2013 4). Keys: direction from x1, degrees, and speed, in
///     that of the sphere's shear waves;
///   - material: a number of a viscoelastic solid. Keys: solid, memory, p;
///   - table ID COLUMN KEY=VALUE: what the seed's table prints in the row with that value in the column KEY;
///   - computed: one of computed_numbers().
/// Each contact is solved only once, by all copies together.
class SolvedNumbers {
 public:
  Propagated operator()(const std::string& words, StatedFormulas& formulas) const;
  /// The contact of such words, whatever the name of the result.
  [[nodiscard]] const SolvedContact<fast::Estimate>& contact(const std::string& words,
                                                             StatedFormulas& formulas) const;

 private:
  using Contacts = std::map<std::map<std::string, std::string>, SolvedInDouble>;
  std::shared_ptr<Contacts> contacts_ = std::make_shared<Contacts>();
};

/// Numbers that no formula describes, by name.
const std::map<std::string, std::function<Propagated()>>& computed_numbers();

/// The value of a printed formula in double arithmetic without a bound on its rounding: eight of its sixteen digits are
/// trusted, enough to tell it from the truth.
Propagated printed_form(double value);

/// Evaluates the formulas of an entry, with the functions of claims.toml, the definitions of the [[setting]] that it names, then its
/// own in `given`.
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
  StatedFormulas formulas_;
  std::string setting_;
};

using Function = std::function<Propagated(double)>;

// The error of an integral is the sum of the rule's estimate of its truncation error, the integral of the errors of f, and
// the rounding of the sum.

/// int_from^to f, which may be singular at the ends in an integrable way.
Propagated integral(const Function& f, double from, double to);
/// The same for a smooth f.
Propagated smooth_integral(const Function& f, double from, double to);
/// int_0^inf f
Propagated half_line_integral(const Function& f);
/// (1/pi) times the principal value of int_from^to f(t)/(t - x) dt, from < x < to.
Propagated hilbert(const Function& f, double x, double from, double to);

/// f'(x) by central differences with halved steps, extrapolated to 0 (Ridders). Of the extrapolated values the result is the
/// one with the least error, the sum of the change by the last extrapolation and of the propagated errors of f. f must be
/// analytic within several steps.
Propagated derivative(const Function& f, double x, double step);

/// The place where f changes its sign, between two places at which its signs differ. The error reaches to where they are
/// certain.
Propagated sign_change(const Function& f, double lower, double upper);

/// f at a place that has an error; f must be monotonic there.
Propagated monotonic(const Function& f, const Propagated& place);

/// The largest value of f, which rises to it and falls from it, and its place, whose error reaches to where f is certainly
/// smaller.
Propagated largest(const Function& f, double lower, double upper);
Propagated place_of_largest(const Function& f, double lower, double upper);

}  // namespace nipref::verify
