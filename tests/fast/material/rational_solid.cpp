#include <nipref/fast/material/rational_solid.hpp>

#include "support/test.hpp"

using namespace nipref;
using data::DifferentialOperators;
using data::PronySeries;
using fast::Strain;

TEST_CASE("rational solids: roots that are one, or nearly, cost no digit") {
  // theta1 = (p + 2)^2/(2 (p + 1)^2) has the instantaneous part 1/2 and the memory e^-t (1 + t/2).
  const auto squared = [](double off) {
    return DifferentialOperators{{4, 4, 1}, {1 + off, 2, 1}, {1}, {10}};
  };
  for (const double t : {0.0, 0.7, 30.0, 500.0}) {
    const double truth = std::exp(-t) * (1 + t / 2);
    CHECK(fast::theta1(squared(0), t).value == doctest::Approx(truth).epsilon(4e-16));
    for (const double off : {-1e-16, 3e-16, -1e-12}) {
      CHECK(fast::theta1(squared(off), t).value == doctest::Approx(truth).epsilon(1e-15 + 1e-12 * t * t));
    }
  }
  // Four equal roots: 6K + 2G = 8 (p + 1)^4/((p + 2)^2 (p + 2)^2), so that theta2 is instantaneously 3/8.
  const DifferentialOperators four{{4, 4, 1}, {1, 2, 1}, {4, 4, 1}, {1, 2, 1}};
  const double t = 2;
  CHECK(fast::theta2(four, t).value == doctest::Approx(3.0 / 8 * std::exp(-t) * (2 + t)).epsilon(1e-15));
}

TEST_CASE("rational solids: an elastic one in disguise neither fades nor loses anything, to 40 digits") {
  const DifferentialOperators disguised{{0.1, 0.3, 0.7}, {0.1, 0.3, 0.7}, {0.1, 0.3, 0.7}, {0.2, 0.6, 1.4}};
  CHECK(std::fabs(fast::theta1(disguised, 0.4).value) < 1e-40);
  CHECK(std::fabs(fast::theta2(disguised, 0.4).value) < 1e-40);
  CHECK(fast::relaxation(disguised, Strain::shear, 0.4).value == 1);
  CHECK(fast::creep(disguised, Strain::dilatation, 0.4).value == 0.5);
  CHECK(std::fabs(fast::loss(disguised, Strain::shear, 3).value) < 1e-40);
}

TEST_CASE("rational solids: what is out of the domain is named") {
  const PronySeries good{{1, {0.4, 2}, {0.5, 3}}, {0.3, {0.1, 0.2}, {1.5, 3}}};
  const auto creep_of = [](const fast::RationalSolid& solid) {
    return fast::creep(solid, Strain::dilatation, 1);
  };
  CHECK_REFUSED(creep_of(PronySeries{{1, {1}, {-1}}, {1, {1}, {1}}}), "theta1_rate = -1: must be >= 0");
  CHECK_REFUSED(creep_of(PronySeries{{1, {1}, {1}}, {0, {0, 0}, {1, 1}}}), "theta2 = 0 at all times");
  CHECK_REFUSED(creep_of(PronySeries{{1, {1}, {1}}, {3, {3}, {1}}}), "theta2 = 3 theta1 at all times");
  CHECK_REFUSED(creep_of(DifferentialOperators{{1, 1}, {1}, {1}, {1}}),
                "Q = of degree 0: must be of the degree of P, 1, or of one more");
  CHECK_REFUSED(creep_of(DifferentialOperators{{1}, {1}, {1}, {1, -2}}), "Q_dilatation_1 = -2: must be >= 0");
  CHECK_REFUSED(creep_of(DifferentialOperators{{0, 0}, {1}, {1}, {1}}), "P = 0");
  CHECK_REFUSED(fast::theta1(good, -1), "t = -1");
  CHECK_REFUSED(fast::storage(good, Strain::shear, INFINITY), "omega = inf");
  CHECK_REFUSED(fast::storage(DifferentialOperators{{0, 1}, {1, 1}, {1}, {1}}, Strain::shear, 0),
                "omega = 0: must not be where the modulus is infinite");
  CHECK_REFUSED(fast::theta1(data::SingleRelaxationTimeSolid{1, 1, 0, 2}, 1), "tau = 0");
}
