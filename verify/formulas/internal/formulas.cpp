#include <cctype>
#include <charconv>

#include <nipref/verify/formulas/internal/formulas.hpp>

namespace nipref::verify {
namespace {

/// The texts before and behind the equals sign of each line.
std::vector<std::pair<std::string, std::string>> halves_of(const std::string& lines) {
  std::vector<std::pair<std::string, std::string>> halves;
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line.starts_with('#')) continue;
    const std::size_t equals = line.find(" =");
    if (line.starts_with(' ') && !halves.empty()) {
      halves.back().second += line;
    } else if (equals == std::string::npos) {
      throw data::BadInput("formula", line, "must be NAME = FORMULA");
    } else {
      halves.emplace_back(line.substr(0, equals), line.substr(equals + 2));
    }
  }
  return halves;
}

}  // namespace

/// A recursive-descent parser: each function removes from the text the part that it parses.
class Formulas::Parser {
 public:
  Parser(const Formulas& formulas, std::string_view text) : formulas_(formulas), text_(text), rest_(text) {}

  Expression whole() {
    std::vector<std::pair<std::string, Expression>> locals;
    for (std::string called = assigned(); !called.empty(); called = assigned()) {
      locals.emplace_back(called, chain(0));
      demand(';');
    }
    Expression last = chain(0);
    if (next() != '\0') fail("an operator");
    if (locals.empty()) return last;
    return [=](Formulas& scope) {
      const std::size_t before = scope.numbers_.size();
      for (const auto& [called, of] : locals) scope.define(called, of(scope));
      return scope.and_forget(before, last);
    };
  }

 private:
  struct Operator {
    char symbol;
    OfTwo* apply;
  };
  static Propagated truth_of(bool condition) { return Propagated::exact(condition ? 1 : 0); }
  static bool has_less_value(const Propagated& a, const Propagated& b) { return a.value() < b.value(); }
  /// In the order of precedence, the lowest first.
  static constexpr std::array<std::array<Operator, 2>, 3> operators{
      {{{{'<', [](const auto& a, const auto& b) { return truth_of(has_less_value(a, b)); }},
         {'>', [](const auto& a, const auto& b) { return truth_of(has_less_value(b, a)); }}}},
       {{{'+', [](const auto& a, const auto& b) { return a + b; }},
         {'-', [](const auto& a, const auto& b) { return a - b; }}}},
       {{{'*', [](const auto& a, const auto& b) { return a * b; }},
         {'/', [](const auto& a, const auto& b) { return a / b; }}}}}};

  [[noreturn]] void fail(std::string_view expected) const {
    refuse("formula", text_, "must have {} at character {}", expected, text_.size() - rest_.size() + 1);
  }
  char next() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \n"), rest_.size()));
    return rest_.empty() ? '\0' : rest_.front();
  }
  bool take(char symbol) {
    if (next() != symbol) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void demand(char symbol) {
    if (!take(symbol)) fail(std::string_view(&symbol, 1));
  }
  std::string_view take_until(std::size_t end) {
    const std::string_view taken = rest_.substr(0, end);
    rest_.remove_prefix(taken.size());
    return taken;
  }

  Expression chain(std::size_t level) {
    if (level == operators.size()) return signed_power();
    Expression left = chain(level + 1);
    while (true) {
      const auto used = std::ranges::find(operators[level], next(), &Operator::symbol);
      if (used == operators[level].end()) return left;
      demand(used->symbol);
      left = [apply = used->apply, of_left = left, of_right = chain(level + 1)](Formulas& scope) {
        const Propagated first = of_left(scope);
        return apply(first, of_right(scope));
      };
    }
  }

  Expression signed_power() {
    if (take('-')) return [of = signed_power()](Formulas& scope) { return -of(scope); };
    Expression base = atom();
    if (!take('^')) return base;
    const int exponent = static_cast<int>(decimal());
    if (exponent < 1) fail("a whole exponent from 1");
    return [=](Formulas& scope) {
      const Propagated factor = base(scope);
      Propagated power = factor;
      for (int i = 1; i < exponent; ++i) power = power * factor;
      return power;
    };
  }

  Expression atom() {
    const char first = next();
    if (take('(')) {
      Expression inner = chain(0);
      demand(')');
      return inner;
    }
    if (take('[')) {
      const std::string words(take_until(rest_.find(']')));
      demand(']');
      return [words](Formulas& scope) { return scope.solve_(words, scope); };
    }
    if (std::isalpha(static_cast<unsigned char>(first)) != 0) return named();
    return [constant = Propagated(decimal())](Formulas&) { return constant; };
  }

  double decimal() {
    next();
    double value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc()) fail("a number, a name or a parenthesis");
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

  /// The name before an equals sign if the rest of the text begins with these two, otherwise empty.
  std::string assigned() {
    const std::string_view start = rest_;
    std::string called = name();
    if (!called.empty() && take('=')) return called;
    rest_ = start;
    return "";
  }

  std::string name() {
    next();
    const auto end =
        std::ranges::find_if(rest_, [](unsigned char c) { return std::isalnum(c) == 0 && c != '_'; });
    return std::string(take_until(static_cast<std::size_t>(end - rest_.begin())));
  }

  Expression named() {
    const std::string called = name();
    if (!take('(')) return [called](Formulas& scope) { return scope.number(called); };
    if (const auto functional = FormulaWords::functionals.find(called);
        functional != FormulaWords::functionals.end())
      return applied(functional->second);
    std::vector<Expression> arguments;
    while (next() != ')' && (arguments.empty() || take(','))) arguments.push_back(chain(0));
    demand(')');
    return call(called, std::move(arguments));
  }

  Expression applied(const Functional& functional) {
    const std::string variable = name();
    std::vector<Expression> parts;
    while (take(',')) parts.push_back(chain(0));
    demand(')');
    if (parts.size() != functional.numbers + 1)
      fail(fmt::format("a variable, {} numbers and a function of it before", functional.numbers));
    const Expression body = parts.back();
    parts.pop_back();
    return [=, apply = functional.apply](Formulas& scope) {
      return apply([&](double at) { return scope.with({variable}, {Propagated::exact(at)}, body); },
                   values(parts, scope));
    };
  }

  Expression call(const std::string& called, std::vector<Expression> arguments) {
    if (called == "if" && arguments.size() == 3)
      return [=](Formulas& scope) { return arguments[arguments[0](scope).value() != 0 ? 1 : 2](scope); };
    const std::size_t count = arguments.size();
    if (const auto defined = formulas_.functions_.find(called);
        defined != formulas_.functions_.end() && defined->second->parameters.size() == count)
      return [arguments, definition = defined->second](Formulas& scope) {
        return scope.with(definition->parameters, values(arguments, scope), definition->body);
      };
    if (const auto known = FormulaWords::of_one.find(called);
        known != FormulaWords::of_one.end() && count == 1)
      return [apply = known->second, of = arguments[0]](Formulas& scope) { return apply(of(scope)); };
    if (const auto known = FormulaWords::of_two.find(called);
        known != FormulaWords::of_two.end() && count == 2)
      return [apply = known->second, arguments](Formulas& scope) {
        const Numbers both = values(arguments, scope);
        return apply(both[0], both[1]);
      };
    if ((called == "min" || called == "max") && count > 1)
      return [is_min = called == "min", arguments](Formulas& scope) {
        const Numbers all = values(arguments, scope);
        return is_min ? std::ranges::min(all, has_less_value) : std::ranges::max(all, has_less_value);
      };
    fail(fmt::format("a function of {} arguments instead of '{}' before", count, called));
  }

  static Numbers values(const std::vector<Expression>& all, Formulas& scope) {
    return mapped(all, [&](const Expression& one) { return one(scope); });
  }

  const Formulas& formulas_;
  std::string_view text_, rest_;
};

void Formulas::define(const std::string& lines) {
  for (const auto& [head, formula] : halves_of(lines)) {
    const std::size_t parenthesis = head.find('(');
    if (parenthesis == std::string::npos) {
      define(head, value(formula));
      continue;
    }
    std::vector<std::string> parameters;
    std::istringstream stream(head.substr(parenthesis + 1, head.find(')') - parenthesis - 1));
    for (std::string name; std::getline(stream >> std::ws, name, ',');) parameters.push_back(name);
    functions_[head.substr(0, parenthesis)] =
        std::make_shared<const Definition>(Definition{parameters, compiled(formula)});
  }
}

std::vector<std::pair<std::string, Formulas::Expression>> Formulas::compiled_lines(
    const std::string& lines) const {
  return mapped(halves_of(lines),
                [&](const auto& line) { return std::pair(line.first, compiled(line.second)); });
}

Formulas::Expression Formulas::compiled(std::string_view formula) const {
  return Parser(*this, formula).whole();
}

Propagated Formulas::number(const std::string& name) const {
  const auto found =
      std::find_if(numbers_.rbegin(), numbers_.rend(), [&](const auto& one) { return one.first == name; });
  if (found != numbers_.rend()) return found->second;
  if (name == "pi") return Propagated::pi();
  throw data::BadInput("formula", name, "must be the name of a number that is defined before");
}

Propagated Formulas::with(const std::vector<std::string>& names, const Numbers& numbers,
                          const Expression& body) {
  const std::size_t before = numbers_.size();
  for (std::size_t i = 0; i < names.size(); ++i) numbers_.emplace_back(names[i], numbers[i]);
  return and_forget(before, body);
}

Propagated Formulas::and_forget(std::size_t before, const Expression& body) {
  const Propagated result = body(*this);
  numbers_.erase(numbers_.begin() + static_cast<std::ptrdiff_t>(before), numbers_.end());
  return result;
}

}  // namespace nipref::verify
