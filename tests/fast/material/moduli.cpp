#include <nipref/fast/material/moduli.hpp>

#include "support/test.hpp"

using namespace nipref;
using data::SpringModel;
using fast::Modulus;

TEST_CASE("what gives way for ever, or not at once, has its functions of time: Maxwell, Kelvin and Voigt") {
  const Modulus shear{SpringModel::maxwell, 2, 0, 5}, bulk{SpringModel::maxwell, 3, 0, 4};
  // At long times this is a fluid: theta1 tends to 1/(2 x 5), theta2 to 3/(6 x 4 + 2 x 5).
  CHECK(fast::theta1(shear, 1e300).value == 0.1);
  CHECK(fast::theta2(shear, bulk, 1e3).value == doctest::Approx(3.0 / 34).epsilon(1e-14));
  CHECK(fast::creep(shear, 1e10) == doctest::Approx(2e9).epsilon(1e-9));
  const Modulus soft{SpringModel::kelvin_voigt, 2, 0, 5}, stiff{SpringModel::kelvin_voigt, 3, 0, 4};
  CHECK(fast::theta1(soft, 0).value == 0.1);
  CHECK(fast::theta2(soft, stiff, 0).value == doctest::Approx(3.0 / 34).epsilon(1e-15));
  CHECK(fast::creep(soft, 0) == 0);
  CHECK(fast::creep(soft, 1e-300) == 1e-300 / 5);
}

TEST_CASE("moduli: what is out of the domain is named") {
  constexpr Modulus good{SpringModel::standard_linear, 2, 3, 5};
  CHECK_THROWS_WITH_AS(fast::relaxation(good, -1), "t = -1: must be finite and >= 0", data::BadInput);
  CHECK_THROWS_WITH_AS(fast::loss(good, INFINITY), "omega = inf: must be finite and >= 0", data::BadInput);
  const Modulus wrong{SpringModel::standard_linear, 1, -1, 1};
  CHECK_REFUSED(wrong.check("shear"), "shear_2 = -1");
}
