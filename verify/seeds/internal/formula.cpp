#include <charconv>

#include <nipref/verify/seeds/internal/solved.hpp>

namespace nipref::verify {
namespace {

using Expression = Formulas::Expression;
using Numbers = std::vector<Propagated>;

Propagated truth_of(bool condition) { return Propagated::exact(condition ? 1 : 0); }
bool has_less_value(const Propagated& a, const Propagated& b) { return a.value() < b.value(); }

struct Operator {
  char symbol;
  OfTwo* apply;
};

/// In the order of precedence, the lowest first.
constexpr std::array<std::array<Operator, 2>, 3> operators{
    {{{{'<', [](const Propagated& a, const Propagated& b) { return truth_of(has_less_value(a, b)); }},
       {'>', [](const Propagated& a, const Propagated& b) { return truth_of(has_less_value(b, a)); }}}},
     {{{'+', operator+ }, {'-', operator- } } }, {{{'*', operator* }, {'/', operator/ } } } } };

Propagated certain(const Propagated& x) { return truth_of(x.is_positive()); }
Propagated within(const Propagated& error) { return {0, error.value()}; }
Propagated without_error(const Propagated& x) { return Propagated::exact(x.value()); }

const std::map<std::string, OfOne*> functions_of_one{
    {"fabs", fabs},   {"sqrt", sqrt},       {"exp", exp},       {"expm1", expm1},
    {"log", log},     {"sinh", sinh},       {"cosh", cosh},     {"tanh", tanh},
    {"atanh", atanh}, {"sin", sin},         {"cos", cos},       {"tan", tan},
    {"atan", atan},   {"certain", certain}, {"within", within}, {"exactly", without_error}};
const std::map<std::string, OfTwo*> functions_of_two{{"hypot", hypot}, {"pow", pow}};

template <Propagated (*functional)(const Function&, double, double)>
Propagated of_range(const Function& f, const Numbers& at) {
  return functional(f, at[0].value(), at[1].value());
}

/// A functional of f: so many numbers stand between the variable and f(variable).
struct Functional {
  std::size_t numbers;
  Propagated (*apply)(const Function& f, const Numbers& at);
};
const std::map<std::string, Functional> functionals{
    {"integral", {2, of_range<integral>}},
    {"smooth_integral", {2, of_range<smooth_integral>}},
    {"derivative", {2, of_range<derivative>}},
    {"sign_change", {2, of_range<sign_change>}},
    {"place_of_largest", {2, of_range<place_of_largest>}},
    {"largest", {2, of_range<largest>}},
    {"half_line_integral", {0, [](const Function& f, const Numbers&) { return half_line_integral(f); }}},
    {"hilbert",
     {3, [](const Function& f,
            const Numbers& at) { return hilbert(f, at[0].value(), at[1].value(), at[2].value()); }}},
    {"monotonic", {1, [](const Function& f, const Numbers& at) { return monotonic(f, at[0]); }}}};

}  // namespace

/// A recursive-descent parser: each function removes from the text the part that it parses.
class FormulaParser {
 public:
  FormulaParser(Formulas& formulas, std::string_view text) : formulas_(formulas), text_(text), rest_(text) {}

  Expression whole() {
    Expression all = chain(0);
    if (next() != '\0') fail("an operator");
    return all;
  }

 private:
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
      left = [apply = used->apply, first = left, second = chain(level + 1)] {
        return apply(first(), second());
      };
    }
  }

  Expression signed_power() {
    if (take('-')) return [of = signed_power()] { return -of(); };
    Expression base = atom();
    if (!take('^')) return base;
    const int exponent = static_cast<int>(decimal());
    if (exponent < 1) fail("a whole exponent from 1");
    return [=] {
      const Propagated factor = base();
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
      return [words, &all = formulas_] { return all.solve_(words, all); };
    }
    if (std::isalpha(static_cast<unsigned char>(first)) != 0) return named();
    return [constant = Propagated(decimal())] { return constant; };
  }

  double decimal() {
    next();
    double value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc()) fail("a number, a name or a parenthesis");
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

  std::string name() {
    next();
    const auto end =
        std::ranges::find_if(rest_, [](unsigned char c) { return std::isalnum(c) == 0 && c != '_'; });
    return std::string(take_until(static_cast<std::size_t>(end - rest_.begin())));
  }

  Expression named() {
    const std::string called = name();
    if (!take('(')) return [called, &all = formulas_] { return all.number(called); };
    if (const auto functional = functionals.find(called); functional != functionals.end())
      return applied(functional->second);
    std::vector<Expression> arguments{chain(0)};
    while (take(',')) arguments.push_back(chain(0));
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
    return [=, apply = functional.apply, &all = formulas_] {
      return apply([&](double at) { return all.with({variable}, {Propagated::exact(at)}, body); },
                   values(parts));
    };
  }

  Expression call(const std::string& called, std::vector<Expression> arguments) {
    if (called == "if" && arguments.size() == 3)
      return [=] { return arguments[0]().value() != 0 ? arguments[1]() : arguments[2](); };
    const std::size_t count = arguments.size();
    if (const auto known = functions_of_one.find(called); known != functions_of_one.end() && count == 1)
      return [apply = known->second, of = arguments[0]] { return apply(of()); };
    if (const auto known = functions_of_two.find(called); known != functions_of_two.end() && count == 2)
      return [apply = known->second, arguments] { return apply(arguments[0](), arguments[1]()); };
    if ((called == "min" || called == "max") && count > 1)
      return [is_min = called == "min", arguments] {
        const Numbers all = values(arguments);
        return is_min ? std::ranges::min(all, has_less_value) : std::ranges::max(all, has_less_value);
      };
    const auto defined = formulas_.functions_.find(called);
    if (defined == formulas_.functions_.end() || defined->second.parameters.size() != arguments.size())
      fail(fmt::format("a function of {} arguments instead of '{}' before", arguments.size(), called));
    return [arguments, definition = defined->second, &all = formulas_] {
      return all.with(definition.parameters, values(arguments), definition.body);
    };
  }

  static Numbers values(const std::vector<Expression>& all) {
    return mapped(all, [](const Expression& one) { return one(); });
  }

  Formulas& formulas_;
  std::string_view text_, rest_;
};

Propagated Formulas::number(const std::string& name) const {
  const auto found =
      std::find_if(numbers_.rbegin(), numbers_.rend(), [&](const auto& one) { return one.first == name; });
  if (found != numbers_.rend()) return found->second;
  if (name == "pi") return Propagated::pi();
  throw data::BadInput("formula", name, "must be the name of a number that is defined before");
}

Propagated Formulas::with(const std::vector<std::string>& names, const std::vector<Propagated>& numbers,
                          const Expression& body) {
  const std::size_t before = numbers_.size();
  for (std::size_t i = 0; i < names.size(); ++i) numbers_.emplace_back(names[i], numbers[i]);
  const Propagated result = body();
  numbers_.erase(numbers_.begin() + static_cast<std::ptrdiff_t>(before), numbers_.end());
  return result;
}

Propagated Formulas::value(std::string_view formula) { return FormulaParser(*this, formula).whole()(); }

void Formulas::define(const std::string& name, const Propagated& number) {
  numbers_.emplace_back(name, number);
}

void Formulas::define(const std::string& lines) {
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t equals = line.find(" = ");
    if (equals == std::string::npos) throw data::BadInput("formula", line, "must be NAME = FORMULA");
    std::string head = line.substr(0, equals);
    const std::string_view formula = std::string_view(line).substr(equals + 3);
    const std::size_t parenthesis = head.find('(');
    if (parenthesis == std::string::npos) {
      define(head, value(formula));
      continue;
    }
    Definition function;
    std::istringstream parameters(head.substr(parenthesis + 1, head.find(')') - parenthesis - 1));
    for (std::string name; std::getline(parameters >> std::ws, name, ',');)
      function.parameters.push_back(name);
    function.body = FormulaParser(*this, formula).whole();
    functions_[head.substr(0, parenthesis)] = function;
  }
}

}  // namespace nipref::verify
