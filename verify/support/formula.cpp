#include <cctype>

#include <nipref/verify/support/formula.hpp>
#include <nipref/verify/support/internal/template.hpp>

namespace nipref::verify {
namespace {

const std::map<std::string_view, std::string_view> signs{
    {"alpha", "α"}, {"beta", "β"},  {"gamma", "γ"}, {"delta", "δ"},  {"epsilon", "ε"}, {"eps", "ε"},
    {"eta", "η"},   {"theta", "θ"}, {"kappa", "κ"}, {"lambda", "λ"}, {"mu", "μ"},      {"nu", "ν"},
    {"xi", "ξ"},    {"pi", "π"},    {"rho", "ρ"},   {"sigma", "σ"},  {"tau", "τ"},     {"phi", "φ"},
    {"chi", "χ"},   {"psi", "ψ"},   {"omega", "ω"}, {"Delta", "Δ"},  {"Phi", "Φ"},     {"Psi", "Ψ"},
    {"Omega", "Ω"}, {"inf", "∞"},   {"int", "∫"},   {"sum", "∑"},    {"<=", "≤"},      {">=", "≥"},
    {"+-", "±"},    {"->", "→"},    {"*", "∗"},     {"-", "−"},      {"'", "′"},       {"''", "″"}};

std::string shown(const std::string& name) {
  const auto sign = signs.find(name);
  return sign == signs.end() ? escaped_for_html(name) : std::string(sign->second);
}

std::string element(const std::string& name, const std::string& content) {
  return "<" + name + ">" + content + "</" + name + ">";
}

constexpr double thin = 0.17;  ///< em

/// An upright name between thin blanks.
std::string spaced(const std::string& name, double after) {
  return fmt::format("<mo lspace=\"{}em\" rspace=\"{}em\">{}</mo>", thin, after, name);
}

std::string row(const std::string& content) { return element("mrow", content); }

/// The tokens of a formula: names, indices, numbers, fraction bars and signs. Digits behind a name are its index. So is
/// a sign behind a name if no summand follows: x+ and x- are the ends of a contact.
std::vector<std::string> tokens_of(std::string_view formula) {
  std::vector<std::string> tokens;
  const auto take = [&](std::size_t size) {
    tokens.emplace_back(formula.substr(0, size));
    formula.remove_prefix(size);
  };
  const auto reach = [&](std::string_view of, std::size_t from = 0) {
    return std::min(formula.find_first_not_of(of, from), formula.size());
  };
  constexpr std::string_view digits = "0123456789", pairs[] = {"<=", ">=", "+-", "->", "''"},
                             letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  while (!formula.empty()) {
    if (const std::size_t name = reach(letters); name > 0) {
      take(name);
      const std::string_view sign = formula.substr(0, 2);
      const bool is_end = sign == "+ " || sign == "- " || sign == "+)" || sign == "-)";
      const std::size_t index = is_end ? 1 : reach(digits);
      if (index > 0) tokens.emplace_back("_"), take(index);
    } else if (reach(digits) > 0) {
      const std::size_t end = reach("0123456789."), minus = formula.substr(end, 2) == "e-" ? 2 : 1,
                        power = formula.substr(end, 1) == "e" ? reach(digits, end + minus) : end;
      take(power > end + minus ? power : end);
    } else if (formula.starts_with(" / ")) {
      take(3);
    } else if (formula.front() == ' ') {
      formula.remove_prefix(1);
    } else {
      take(std::ranges::count(pairs, formula.substr(0, 2)) > 0 ? 2 : 1);
    }
  }
  return tokens;
}

/// Reads a formula from its tokens. A sum is a row of products, a product a row of factors.
class Reader {
 public:
  explicit Reader(const std::string& formula) : tokens_(tokens_of(formula)) {}

  /// The whole formula, in pieces between which lines may be broken.
  std::string all() {
    std::string pieces, piece;
    while (at_ < tokens_.size()) {
      if (is_between(next()) && !piece.empty()) {
        pieces += element("math", piece) + " ";
        piece.clear();
      }
      piece += is_between(next()) || is_closing(next()) ? element("mo", shown(take())) : product();
    }
    return pieces + element("math", piece);
  }

 private:
  static bool is_between(const std::string& token) {
    static const std::set<std::string> between{"+", "-", "+-", "=", "<", ">", "<=", ">=", "->", ","};
    return between.contains(token);
  }
  static bool is_closing(const std::string& token) { return token == ")" || token == "]"; }

  [[nodiscard]] std::string next() const { return at_ < tokens_.size() ? tokens_[at_] : ""; }
  std::string take() { return at_ < tokens_.size() ? tokens_[at_++] : ""; }

  /// The sum up to its closing bracket, or to the end.
  std::string sum() {
    std::string content;
    while (at_ < tokens_.size() && !is_closing(next()))
      content += is_between(next()) ? element("mo", shown(take())) : product();
    return content;
  }

  std::string product() {
    std::string before, factors;  // `before`: all up to the last integral or sum sign, outside numerators
    while (at_ < tokens_.size() && !is_between(next()) && !is_closing(next())) {
      if (next() == " / ") {
        take();
        const std::string denominator = factor(true);
        factors = element("mfrac", row(factors) + row(denominator));
      } else if (next() == "int" || next() == "sum") {
        before += factors + factor(false);
        factors.clear();
      } else {
        factors += factor(false);
      }
    }
    return before + factors;
  }

  /// A name, a number or a bracket, with its indices. With `bare` an outer bracket is left out.
  std::string factor(bool bare) {
    std::string base = atom(bare), below, above;
    for (bool more = true; more;) {
      more = false;
      for (auto& [sign, index] : {std::pair<const char*, std::string*>("_", &below), {"^", &above}}) {
        if (next() != sign) continue;
        take();
        *index = this->index(*sign == '_');
        more = true;
      }
      if (next() == "'" || next() == "''") {
        above += element("mo", shown(take()));
        more = true;
      }
    }
    if (!below.empty() && !above.empty()) return element("msubsup", base + row(below) + row(above));
    if (!below.empty()) return element("msub", base + row(below));
    return above.empty() ? base : element("msup", base + row(above));
  }

  /// An index. A lower index that begins with a sign is this sign alone.
  std::string index(bool below) {
    const bool is_signed = next() == "-" || next() == "+";
    const std::string sign = is_signed ? element("mo", shown(take())) : "";
    return is_signed && below ? sign : sign + atom(true);
  }

  std::string atom(bool bare) {
    const std::string token = take();
    if (token == "(" || token == "[") {
      const std::string content = sum(), closing = take();
      return bare ? row(content) : row(element("mo", token) + content + element("mo", closing));
    }
    if (token == "sqrt") return element("msqrt", atom(true));
    if (std::isdigit(static_cast<unsigned char>(token[0])) != 0) return number(token);
    if (std::isalpha(static_cast<unsigned char>(token[0])) == 0 || token == "int" || token == "sum")
      return element("mo", token == " / " ? "/" : shown(token));
    const std::string of = token.substr(1);
    if (token[0] == 'd' && (of.size() == 1 || signs.contains(of)))
      return row(spaced("d", 0) + element("mi", shown(of)));
    return token.size() == 1 || signs.contains(token) ? element("mi", shown(token)) : spaced(token, thin);
  }

  /// 1e-4 as a power of ten.
  static std::string number(const std::string& token) {
    const std::size_t e = token.find('e');
    if (e == std::string::npos) return element("mn", token);
    const std::string factor = token.substr(0, e), power = token.substr(e + 1);
    return row((factor == "1" ? "" : element("mn", factor) + element("mo", "·")) +
               element("msup", element("mn", "10") + element("mn", power)));
  }

  std::vector<std::string> tokens_;
  std::size_t at_ = 0;
};

}  // namespace

std::string without_marks(std::string text) {
  std::erase(text, '`');
  return text;
}

std::string with_mathml(const std::string& text) {
  std::string markup;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = text.find('`', at), close = text.find('`', open + 1);
    if (open == std::string::npos || close == std::string::npos)
      return markup + escaped_for_html(text.substr(at));
    markup +=
        escaped_for_html(text.substr(at, open - at)) + Reader(text.substr(open + 1, close - open - 1)).all();
    at = close + 1;
  }
  return markup;
}

}  // namespace nipref::verify
