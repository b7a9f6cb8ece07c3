#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include <nipref/fast/half_space/direction.hpp>
#include <nipref/verify/support/internal/double_formulas.hpp>

namespace nipref::verify {
namespace {

using DoubleWords = FormulaWords<double>;
using RealFunction = std::function<double(double)>;
using fast::Direction;

}  // namespace

const std::map<std::string, DoubleWords::OfOne*> DoubleWords::of_one{
    {"floor", std::floor},
    {"fabs", std::fabs},
    {"exp", std::exp},
    {"log", std::log},
    {"expm1", std::expm1},
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

}  // namespace nipref::verify
