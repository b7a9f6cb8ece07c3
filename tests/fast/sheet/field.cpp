#include <nipref/fast/sheet/displacements.hpp>
#include <nipref/fast/sheet/field.hpp>
#include <nipref/fast/sheet/kernels.hpp>

#include "support/test.hpp"

using namespace nipref;
using namespace nipref::fast;
using data::SheetLoad;

TEST_SUITE_BEGIN("fast field inside the sheet");

namespace {

constexpr auto normal = SheetLoad::normal;
constexpr auto shear = SheetLoad::shear;
const std::vector<double> depths{0, 0.3, -0.6, 0.9, 1 - 1e-6, std::nextafter(1.0, 0.0)};

/// Over the whole length of the sheet at a depth: the trapezoidal rule in t, alpha = (1 - |depth|) sinh t.
template <class Stress>
double along_the_sheet(double depth, const Stress& stress) {
  constexpr double step = 1.0 / 16;
  const double distance = 1 - std::fabs(depth), end = std::asinh(25 / distance);
  double sum = 0;
  for (double t = -std::ceil(end / step) * step; t <= end; t += step)
    sum += stress(distance * std::sinh(t)) * distance * std::cosh(t);
  return sum * step;
}

/// Over the thickness, by the trapezoidal rule in t, depth = tanh(sinh t).
template <class Stress>
double over_the_thickness(const Stress& stress) {
  constexpr double step = 1.0 / 64;
  double sum = 0;
  for (double t = -3.75; t <= 3.75; t += step) {
    const double fraction = std::tanh(std::sinh(t));
    sum += stress(fraction) * std::cosh(t) * (1 - fraction * fraction);
  }
  return sum * step;
}

/// Of the fourth order.
template <class Function>
double slope(const Function& f, double x) {
  constexpr double h = 0x1p-9;
  const auto difference = [&](double step) { return (f(x + step) - f(x - step)) / (2 * step); };
  return (4 * difference(h) - difference(2 * h)) / 3;
}

const std::vector<std::pair<double, double>> places{
    {0.2, 0.1}, {-0.7, 0.5}, {1.2, -0.3}, {1.3, 0.6}, {3, -0.8}};

}  // namespace

TEST_CASE(
    "the normal load is carried at every depth: int sigma_x d alpha = -1, the shear load by int tau = depth") {
  double worst = 0;
  for (const double depth : depths) {
    const double carried =
        along_the_sheet(depth, [&](double a) { return sheet_stresses(a, depth, normal).across; });
    const double pulled =
        along_the_sheet(depth, [&](double a) { return sheet_stresses(a, depth, shear).shear; });
    CAPTURE(depth);
    CHECK(std::fabs(carried + 1) < 1e-14);
    // The sheet pulls with half the loads to either side, so that tau over it falls off linearly.
    CHECK(std::fabs(pulled - depth) < 1e-14);
    worst = std::max({worst, std::fabs(carried + 1), std::fabs(pulled - depth)});
  }
  MESSAGE("largest departure of a resultant along the sheet: ", worst);
}

TEST_CASE("resultants over sections: int sigma_y = 0, -sign alpha under shear loads, and int tau = 0") {
  double worst = 0;
  for (const double alpha : {0.3, 1.0, -1.2, 1.3, 5.0, -20.0}) {
    CAPTURE(alpha);
    for (const SheetLoad load : {normal, shear}) {
      const double expected = load == shear ? -std::copysign(1.0, alpha) : 0;
      const double along = over_the_thickness([&](double s) { return sheet_stresses(alpha, s, load).along; });
      const double across =
          over_the_thickness([&](double s) { return sheet_stresses(alpha, s, load).shear; });
      CHECK(std::fabs(along - expected) < 1e-13);
      CHECK(std::fabs(across) < 1e-13);
      worst = std::max({worst, std::fabs(along - expected), std::fabs(across)});
    }
  }
  MESSAGE("largest departure of a resultant over a section: ", worst);
}

TEST_CASE("equilibrium and Hooke's law by differentiation, at any Poisson's ratio") {
  double worst = 0;
  const auto vanishes = [&](double sum) {
    CHECK(std::fabs(sum) < 2e-9);
    worst = std::max(worst, std::fabs(sum));
  };
  for (const auto& [alpha, depth] : places) {
    for (const SheetLoad load : {normal, shear}) {
      const double y = alpha, x = depth;
      const auto at = [&](double a, double s) { return sheet_stresses(a, s, load); };
      const SheetStresses here = at(y, x);
      vanishes(slope([&](double s) { return at(y, s).across; }, x) +
               slope([&](double a) { return at(a, x).shear; }, y));
      vanishes(slope([&](double s) { return at(y, s).shear; }, x) +
               slope([&](double a) { return at(a, x).along; }, y));
      for (const double poisson : {-0.4, 0.3, 0.5}) {
        CAPTURE(poisson);
        // theta1/N and theta2/N.
        const double t1 = 1 / (2 * (1 - poisson)), t2 = 1 - t1;
        const auto u = [&](double a, double s) { return sheet_u(a, s, load, poisson); };
        const auto v = [&](double a, double s) { return sheet_v(a, 0.4, s, load, poisson); };
        const double mean = t2 * (here.across + here.along) / 2, apart = t1 * (here.across - here.along) / 2;
        vanishes(slope([&](double s) { return u(y, s); }, x) - mean - apart);
        vanishes(slope([&](double a) { return v(a, x); }, y) - mean + apart);
        vanishes(slope([&](double a) { return u(a, x); }, y) + slope([&](double s) { return v(y, s); }, x) -
                 2 * t1 * here.shear);
      }
    }
  }
  MESSAGE("largest departure from equilibrium or Hooke's law: ", worst);
}

TEST_CASE("at the faces the displacements are un, vn, us, vs, and the stresses those of a free surface") {
  const data::ElasticMaterial material{2.5, 0.3};
  const double N = material.normal_compliance();
  for (const double alpha : {1e-6, 0.4, -1.2, 1.3, 6.0}) {
    CAPTURE(alpha);
    const auto same = [](double value, double expected) {
      CHECK(value == doctest::Approx(expected).epsilon(4e-15).scale(1));
    };
    same(N * sheet_u(alpha, -1, normal, 0.3), un(alpha, material));
    same(N * sheet_u(alpha, 1, normal, 0.3), -un(alpha, material));
    same(N * sheet_u(alpha, -1, shear, 0.3), us(alpha, material));
    for (const double face : {-1.0, 1.0}) {
      same(N * sheet_v(alpha, 2, face, normal, 0.3), vn(alpha, 2, material));
      same(N * sheet_v(alpha, 2, face, shear, 0.3), vs(alpha, 2, material));
      for (const SheetLoad load : {normal, shear}) {
        CHECK(sheet_stresses(alpha, face, load).across == 0);
        CHECK(sheet_stresses(alpha, face, load).shear == 0);
      }
    }
    CHECK(sheet_v(alpha, alpha, 0, normal, 0.3) == doctest::Approx(0).scale(1).epsilon(1e-15));
  }
}

TEST_CASE("on the middle plane sigma_x under a normal load is -(I7 + I5')/pi") {
  CHECK(sheet_stresses(0, 0, normal).across == doctest::Approx(-0.919491007).epsilon(1e-9));
  CHECK(sheet_stresses(0.7, 0, normal).across == doctest::Approx(-0.289894557).epsilon(2e-9));
  for (const double alpha : {0.0, 0.7, 1.24, 1.26, 4.0}) {
    const double slope_I5 = slope([](double a) { return I5(a); }, alpha);
    CHECK(sheet_stresses(alpha, 0, normal).across ==
          doctest::Approx(-(I7(alpha) + slope_I5) * std::numbers::inv_pi).epsilon(1e-9).scale(0.01));
  }
}

TEST_CASE("towards the load the field is the half-plane's along any line") {
  for (const double distance : {1e-4, 1e-9, 1e-14}) {
    for (const double angle : {0.1, 0.8, 1.5}) {
      const double depth = 1 - distance * std::cos(angle), d = 1 - depth, a = distance * std::sin(angle);
      const double r = std::hypot(d, a), ray = 2 * std::numbers::inv_pi * d / (r * r);
      const SheetStresses at = sheet_stresses(a, depth, normal);
      const auto share = [&](double value) { return value / ray; };
      CHECK(share(at.across) == doctest::Approx(-d * d / (r * r)).epsilon(3 * distance + 1e-15).scale(10));
      CHECK(share(at.along) == doctest::Approx(-a * a / (r * r)).epsilon(3 * distance + 1e-15).scale(10));
      CHECK(share(at.shear) == doctest::Approx(a * d / (r * r)).epsilon(3 * distance + 1e-15).scale(10));
    }
  }
}

TEST_CASE("what is odd in alpha stays proportional to it down to the smallest double") {
  // By a power of two, so that nothing but the range of doubles is between them.
  const double small = 0x1p-900, least = 0x1p-1074, factor = 0x1p-174;
  for (const double depth : {std::nextafter(1.0, 0.0), 1 - 1e-9, 0.9}) {
    const auto check = [&](double here, double there) {
      CHECK(std::fabs(there * factor - here) <= 1e-15 * std::fabs(here) + 2 * least);
    };
    check(sheet_stresses(least, depth, normal).shear, sheet_stresses(small, depth, normal).shear);
    check(sheet_stresses(least, depth, shear).across, sheet_stresses(small, depth, shear).across);
    check(sheet_stresses(least, depth, shear).along, sheet_stresses(small, depth, shear).along);
    check(sheet_u(-least, depth, shear, 0.3), sheet_u(-small, depth, shear, 0.3));
    check(sheet_v(least, 0, depth, normal, 0.3), sheet_v(small, 0, depth, normal, 0.3));
  }
}

TEST_CASE("bad places are refused by name") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto argument_refused = [](double alpha, double depth) {
    try {
      sheet_stresses(alpha, depth, normal);
    } catch (const data::BadInput& error) {
      return error.argument();
    }
    return std::string("nothing");
  };
  CHECK(argument_refused(nan, 0) == "alpha");
  CHECK(argument_refused(1, nan) == "depth");
  CHECK(argument_refused(1, std::nextafter(1.0, 2.0)) == "depth");
  CHECK(argument_refused(1, -1.5) == "depth");
  CHECK(argument_refused(0, 1) == "alpha");
  CHECK(argument_refused(1e-301, -1) == "alpha");
  CHECK(argument_refused(0, std::nextafter(1.0, 0.0)) == "nothing");
  CHECK_THROWS_AS(sheet_u(1, 0, normal, 0.6), data::BadInput);
  CHECK_THROWS_AS(sheet_v(1, nan, 0, normal, 0.3), data::BadInput);
}

TEST_SUITE_END();
