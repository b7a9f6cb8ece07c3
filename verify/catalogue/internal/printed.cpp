#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include <nipref/fast/half_space/direction.hpp>
#include <nipref/verify/catalogue/internal/printed.hpp>

namespace nipref::verify {
namespace {

using DoubleWords = FormulaWords<double>;
using RealFunction = std::function<double(double)>;
using fast::Direction;

/// The text of printed.txt, put here by the build.
const Formulas<double>& printed_formulas() {
  static const Formulas<double> all({},
#include <nipref_printed.inc>
  );
  return all;
}

void define_all(Formulas<double>& scope, const GivenNumbers& given) {
  for (const auto& [name, number] : given) scope.define(name, number);
}

}  // namespace

const std::map<std::string, DoubleWords::OfOne*> DoubleWords::of_one{
    {"floor", std::floor},
    {"fabs", std::fabs},
    {"exp", std::exp},
    {"log", std::log},
    {"log1p", std::log1p},
    {"cosh", std::cosh},
    {"sinh", std::sinh},
    {"sqrt", std::sqrt},
    {"round", std::round},
    {"atan", std::atan},
    {"cos", std::cos},
    {"sin", std::sin},
    {"cosine", [](double degrees) { return Direction::of_degrees(degrees).cosine; }},
    {"sine", [](double degrees) { return Direction::of_degrees(degrees).sine; }}};
const std::map<std::string, DoubleWords::OfTwo*> DoubleWords::of_two{
    {"hypot", std::hypot},
    {"atan2", std::atan2},
    {"pow", std::pow},
    {"nextafter", std::nextafter},
    {"turned_cosine",
     [](double psi, double degrees) {
       return Direction::of_angle(psi).turned(Direction::of_degrees(degrees)).cosine;
     }},
    {"turned_sine", [](double psi, double degrees) {
       return Direction::of_angle(psi).turned(Direction::of_degrees(degrees)).sine;
     }}};
const std::map<std::string, FormulaFunctional<double>> DoubleWords::functionals{
    {"integral",
     {2,
      [](const RealFunction& f, const std::vector<double>& ends) {
        return boost::math::quadrature::tanh_sinh<double>().integrate(f, ends[0], ends[1]);
      }}},
    {"smooth_integral", {2, [](const RealFunction& f, const std::vector<double>& ends) {
                           return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
                               f, ends[0], ends[1], 10, 1e-10);
                         }}}};

double printed(const std::string& function, const std::vector<double>& numbers, const GivenNumbers& given) {
  Formulas<double> scope;
  define_all(scope, given);
  return printed_formulas().value_of(function, numbers, scope);
}

double printed_value(const std::string& formula, const GivenNumbers& given) {
  Formulas<double> scope;
  define_all(scope, given);
  return printed_formulas().compiled(formula)(scope);
}

GivenNumbers scaled_moduli(const data::TransverselyIsotropicSolid& half_space,
                           const data::IsotropicSolid& sphere) {
  const double mu = sphere.shear, poisson = sphere.poisson;
  return {{"c11", half_space.c11 / mu},
          {"c33", half_space.c33 / mu},
          {"c13", half_space.c13 / mu},
          {"c44", half_space.c44 / mu},
          {"c66", half_space.c66 / mu},
          {"scale", std::sqrt(half_space.density / sphere.density)},
          {"c_D", std::sqrt((2 - 2 * poisson) / (1 - 2 * poisson))}};
}

}  // namespace nipref::verify
