#pragma once
#include <nipref/verify/formulas/propagated.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

/// Evaluates formulas of numbers with their errors. A formula is made of
///   - decimal numbers, pi and names that were defined,
///   - + - * / ^ (whole exponents), parentheses, and x < y and x > y, which compare values and are 1 or 0,
///   - sqrt(x) and others of words.cpp, min(x, ...) and max(x, ...) by value, and defined ones, found first,
///   - if(condition, x, y), which evaluates x or y alone,
///   - integral(t, a, b, f(t)) and the other functionals of words.cpp, whose first argument names the variable,
///   - [WORDS]: a number that the program computes,
///   - name = formula; any number of times before the last formula, which is the value: defines the name from there on.
class Formulas {
 public:
  using Numbers = std::vector<Propagated>;
  using Named = std::vector<std::pair<std::string, double>>;
  using Solve = std::function<Propagated(const std::string& words, Formulas& scope)>;
  /// A compiled formula. Several threads may evaluate it at the same time, each with its own scope.
  using Expression = std::function<Propagated(Formulas& scope)>;
  using Function = std::function<Propagated(double)>;

  explicit Formulas(Solve solve = {}, const std::string& lines = "") : solve_(std::move(solve)) {
    define(lines);
  }
  /// Defines these numbers as constants.
  explicit Formulas(const Named& numbers) { define(numbers); }
  Formulas(const Formulas&) = delete;
  Formulas& operator=(const Formulas&) = delete;

  void define(const std::string& name, const Propagated& number) { numbers_.emplace_back(name, number); }
  void define(const Named& all) { numbers_.insert(numbers_.end(), all.begin(), all.end()); }
  /// Lines "name = formula", evaluated in their order, or "name(argument, ...) = formula". A line that is indented
  /// continues the line before; a line that begins with # is a comment.
  void define(const std::string& lines);
  /// Compiles such lines, which define no functions, without evaluating them.
  [[nodiscard]] std::vector<std::pair<std::string, Expression>> compiled_lines(
      const std::string& lines) const;
  /// BadInput that names the formula if it cannot be understood. The expression throws BadInput for an unknown number.
  [[nodiscard]] Expression compiled(std::string_view formula) const;
  [[nodiscard]] Propagated value(std::string_view formula) { return compiled(formula)(*this); }
  /// The value of a function that was defined, for these numbers, with the other numbers of a scope.
  [[nodiscard]] Propagated value_of(const std::string& function, const Numbers& numbers,
                                    Formulas& scope) const {
    const Definition& definition = *functions_.at(function);
    return scope.with(definition.parameters, numbers, definition.body);
  }
  /// The number that was defined last by that name. Throws BadInput if there is none.
  [[nodiscard]] Propagated number(const std::string& name) const;

 private:
  class Parser;
  struct Definition {
    std::vector<std::string> parameters;
    Expression body;
  };

  /// Evaluates a body with additional numbers, which hide others of the same names.
  [[nodiscard]] Propagated with(const std::vector<std::string>& names, const Numbers& numbers,
                                const Expression& body);
  Propagated and_forget(std::size_t before, const Expression& body);

  Solve solve_;
  std::vector<std::pair<std::string, Propagated>> numbers_;
  std::map<std::string, std::shared_ptr<const Definition>> functions_;
};

/// A function of a function, such as an integral: so many numbers stand between the variable and f(variable).
struct Functional {
  std::size_t numbers;
  Propagated (*apply)(const Formulas::Function& f, const Formulas::Numbers& at);
};

/// The functions and the functionals of formulas, by name.
struct FormulaWords {
  static const std::map<std::string, OfOne*> of_one;
  static const std::map<std::string, OfTwo*> of_two;
  static const std::map<std::string, Functional> functionals;
};

/// Numbers by the names that formulas have for them.
using GivenNumbers = Formulas::Named;

}  // namespace nipref::verify
