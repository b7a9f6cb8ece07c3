#pragma once
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nipref/verify/seeds/propagated.hpp>

namespace nipref::verify {

/// Evaluates formulas of data/statements; every number has its error (see Propagated). A formula is made of
///   - decimal numbers, pi and names that were defined,
///   - + - * / ^ (the exponent is a whole number), parentheses, and x < y and x > y, which compare values and are 1 or 0,
///   - sqrt(x) and the other functions of Propagated, min(x, ...) and max(x, ...) by value,
///   - certain(x): 1 if x is positive beyond its error, otherwise 0; within(e): 0 with the error e; exactly(x): x without
///     its error; if(condition, x, y), of which only one is evaluated,
///   - integral(t, a, b, f(t)) and the other functions of numerics.hpp, whose first argument names the variable,
///   - [WORDS]: a number that the program computes, as solved.hpp describes.
class Formulas {
 public:
  using Solve = std::function<Propagated(const std::string& words, Formulas& formulas)>;
  using Expression = std::function<Propagated()>;

  explicit Formulas(Solve solve) : solve_(std::move(solve)) {}
  Formulas(const Formulas&) = delete;
  Formulas& operator=(const Formulas&) = delete;

  /// Lines "name = formula", evaluated in their order, or "name(argument, ...) = formula".
  void define(const std::string& lines);
  void define(const std::string& name, const Propagated& number);
  /// BadInput that names the formula if it cannot be understood, or a name in it is not defined.
  [[nodiscard]] Propagated value(std::string_view formula);

 private:
  friend class FormulaParser;
  struct Definition {
    std::vector<std::string> parameters;
    Expression body;
  };
  [[nodiscard]] Propagated number(const std::string& name) const;
  /// Evaluates a body with additional numbers, which hide others of the same names.
  [[nodiscard]] Propagated with(const std::vector<std::string>& names, const std::vector<Propagated>& numbers,
                                const Expression& body);

  Solve solve_;
  std::vector<std::pair<std::string, Propagated>> numbers_;
  std::map<std::string, Definition> functions_;
};

}  // namespace nipref::verify
