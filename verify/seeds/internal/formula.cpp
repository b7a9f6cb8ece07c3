#include <nipref/verify/seeds/internal/solved.hpp>

namespace nipref::verify {
namespace {

using StatedWords = FormulaWords<Propagated>;
using Numbers = std::vector<Propagated>;

Propagated certain(const Propagated& x) { return StatedWords::exact(x.is_positive() ? 1 : 0); }
Propagated within(const Propagated& error) { return {0, error.value()}; }
Propagated without_error(const Propagated& x) { return Propagated::exact(x.value()); }

template <Propagated (*functional)(const Function&, double, double)>
Propagated of_range(const Function& f, const Numbers& at) {
  return functional(f, at[0].value(), at[1].value());
}

}  // namespace

const std::map<std::string, OfOne*> StatedWords::of_one{
    {"fabs", fabs},   {"sqrt", sqrt},       {"exp", exp},       {"expm1", expm1},
    {"log", log},     {"sinh", sinh},       {"cosh", cosh},     {"tanh", tanh},
    {"atanh", atanh}, {"sin", sin},         {"cos", cos},       {"tan", tan},
    {"atan", atan},   {"certain", certain}, {"within", within}, {"exactly", without_error}};
const std::map<std::string, OfTwo*> StatedWords::of_two{{"hypot", hypot}, {"pow", pow}};
const std::map<std::string, FormulaFunctional<Propagated>> StatedWords::functionals{
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

}  // namespace nipref::verify
