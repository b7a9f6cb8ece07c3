#include <nipref/fast/sheet/field.hpp>
#include <nipref/fast/sheet/roots.hpp>

#include "support/test.hpp"

using namespace nipref;
using namespace nipref::fast;
using enum data::SheetLoad;

TEST_CASE("what is odd in alpha stays proportional to it down to the smallest double") {
  // The factor is a power of two, so that only the range of doubles makes a difference.
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

TEST_CASE("far from the load the field is one wave down to the subnormal numbers") {
  // Re(a e^(i z alpha)) at three places a step h apart: f(alpha + h) = 2 e^(-d h) cos(w h) f(alpha) - e^(-2 d h)
  // f(alpha - h), with z = w + i d.
  const double h = 10, fall = std::exp(-h * sheet_root(1).imag()), turn = h * sheet_root(1).real();
  const auto check = [&](const auto& f) {
    const double nearest = f(320.0), near = f(330.0),
                 size = fall * (std::fabs(near) + fall * std::fabs(nearest));
    CHECK(std::fabs(f(340.0) - fall * (2 * std::cos(turn) * near - fall * nearest)) <=
          1e-12 * size + 0x1p-1071);
  };
  check([](double alpha) { return un_slope(alpha, data::Derivative::first); });
  check([](double alpha) { return vn_slope(alpha, data::Derivative::first); });
  check([](double alpha) { return sheet_u(alpha, 0.3, normal, 0.5); });
}

TEST_CASE("beside the loads the faces are free of stress, exactly") {
  for (const double alpha : {1e-6, 0.4, -1.2, 6.0}) {
    for (const double face : {-1.0, 1.0}) {
      for (const data::SheetLoad load : {normal, shear}) {
        CHECK(sheet_stresses(alpha, face, load).across == 0);
        CHECK(sheet_stresses(alpha, face, load).shear == 0);
      }
    }
  }
}

TEST_CASE("bad places are refused by name") {
  CHECK_REFUSED(sheet_stresses(not_a_number, 0, normal), "alpha = ");
  CHECK_REFUSED(sheet_stresses(1, not_a_number, normal), "depth = ");
  CHECK_REFUSED(sheet_stresses(1, std::nextafter(1.0, 2.0), normal), "depth = ");
  CHECK_REFUSED(sheet_stresses(1, -1.5, normal), "depth = ");
  CHECK_REFUSED(sheet_stresses(0, 1, normal), "alpha = ");
  CHECK_REFUSED(sheet_stresses(1e-301, -1, normal), "alpha = ");
  CHECK_NOTHROW((void)sheet_stresses(0, std::nextafter(1.0, 0.0), normal));
  CHECK_THROWS_AS(sheet_u(1, 0, normal, 0.6), data::BadInput);
  CHECK_THROWS_AS(sheet_v(1, not_a_number, 0, normal, 0.3), data::BadInput);
}
