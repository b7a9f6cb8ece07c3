#include <boost/math/quadrature/gauss.hpp>

#include <nipref/fast/material/rational_solid.hpp>

#include "support/test.hpp"

using namespace nipref;
using data::DifferentialOperators;
using data::PronySeries;
using fast::RationalSolid;
using fast::Strain;

namespace {

// Two rates, equal rates, a complex pair of G and of the compliances, nothing at once, a fluid, the thesis's solid.
const std::vector<RationalSolid> solids{PronySeries{{1, {0.4, 2}, {0.5, 3}}, {0.3, {0.1, 0.2}, {1.5, 3}}},
                                        PronySeries{{1, {0.4, 0.7}, {2, 2}}, {0.3, {0.1, 0.2}, {2, 2}}},
                                        DifferentialOperators{{4, 4, 1}, {2, 2, 1}, {1, 0.5}, {10, 6}},
                                        DifferentialOperators{{2, 2, 1}, {1.2, 2, 2}, {1}, {10}},
                                        DifferentialOperators{{2, 1}, {1, 2, 0.5}, {1}, {10, 1}},
                                        PronySeries{{0, {0.4}, {2}}, {0, {0.1}, {2}}},
                                        PronySeries{{1, {1, 1}, {0, 2}}, {0.25, {0.25, 0.25}, {0, 2}}},
                                        data::SingleRelaxationTimeSolid{2, 0.75, 0.4, 2}};

/// By panels of at most 1.5, within which nothing here fades or turns much.
template <class Value>
Value integrated(const std::function<Value(double)>& f, double from, double to) {
  const int panels = static_cast<int>(std::ceil((to - from) / 1.5));
  Value sum{};
  for (int i = 0; i < panels; ++i) {
    const double width = (to - from) / panels, left = from + i * width;
    sum += boost::math::quadrature::gauss<double, 15>::integrate(f, left, left + width);
  }
  return sum;
}
using Complex = std::complex<double>;

/// Viscosity of the dashpot that a modulus has beside the rest: its impulse at a step of strain.
double impulse(const RationalSolid& solid, Strain of) {
  const double omega = 1e9;
  return fast::loss(solid, of, omega).value / omega;
}

}  // namespace

TEST_CASE("rational solids: relaxation and creep undo each other, their convolution is t") {
  for (const RationalSolid& solid : solids) {
    for (const Strain of : {Strain::shear, Strain::dilatation}) {
      const double viscosity = impulse(solid, of) > 1e-6 ? impulse(solid, of) : 0;
      for (const double t : {0.1, 2.0}) {
        const double both = integrated<double>(
            [&](double s) {
              return fast::relaxation(solid, of, t - s).value * fast::creep(solid, of, s).value;
            },
            0, t);
        CHECK(both + viscosity * fast::creep(solid, of, t).value == doctest::Approx(t).epsilon(1e-11));
      }
    }
  }
}

TEST_CASE("rational solids: at a frequency a modulus is what its relaxation makes of a swing") {
  for (const RationalSolid& solid : solids) {
    for (const Strain of : {Strain::shear, Strain::dilatation}) {
      const double omega = 0.7, held = fast::relaxation(solid, of, 1e6).value;
      const double viscosity = impulse(solid, of) > 1e-6 ? impulse(solid, of) : 0;
      const Complex swing = integrated<Complex>(
          [&](double t) {
            return (fast::relaxation(solid, of, t).value - held) * std::exp(Complex(0, -omega * t));
          },
          0, 45);
      const Complex modulus = held + Complex(0, omega) * (viscosity + swing);
      CHECK(fast::storage(solid, of, omega).value == doctest::Approx(modulus.real()).epsilon(1e-9));
      CHECK(fast::loss(solid, of, omega).value == doctest::Approx(modulus.imag()).epsilon(1e-9));
    }
  }
}

TEST_CASE("rational solids: theta1 is half of what creep in shear grows by") {
  for (const RationalSolid& solid : solids) {
    const double from = 0.2, to = 3;
    const double grown =
        fast::creep(solid, Strain::shear, to).value - fast::creep(solid, Strain::shear, from).value;
    const double theta = integrated<double>([&](double t) { return fast::theta1(solid, t).value; }, from, to);
    CHECK(2 * theta == doctest::Approx(grown).epsilon(1e-12));
  }
}

TEST_CASE("rational solids: at a frequency theta2 is 3/(6K + 2G)") {
  for (const RationalSolid& solid : solids) {
    const double omega = 0.7;
    const auto stiffness = [&](double w) {
      const auto of = [&](Strain strain) {
        return Complex(fast::storage(solid, strain, w).value, fast::loss(solid, strain, w).value);
      };
      return 6.0 * of(Strain::dilatation) + 2.0 * of(Strain::shear);
    };
    const double at_once = (3.0 / stiffness(1e12)).real(), held = fast::theta2(solid, 1e3).value;
    const Complex swing = integrated<Complex>(
        [&](double t) { return (fast::theta2(solid, t).value - held) * std::exp(Complex(0, -omega * t)); }, 0,
        60);
    const Complex truth = 3.0 / stiffness(omega), found = at_once + held / Complex(0, omega) + swing;
    CHECK(std::abs(found - truth) <= 1e-9 * std::abs(truth));
  }
}

TEST_CASE("rational solids: what springs and dashpots make is the same by operators and by a series") {
  // G = 2 and 3 | 5 p, K = 7 and 4 | 0.6 p
  const fast::Modulus shear{data::SpringModel::standard_linear, 2, 3, 5},
      bulk{data::SpringModel::standard_linear, 7, 4, 0.6};
  const DifferentialOperators operators{{5, 5}, {6, 10}, {11, 0.6}, {28, 4.2}};
  const PronySeries series{{0.25, {0.1}, {0.6}}, {0.1, {0.04}, {0.6}}};  // 1/(2G) = 1/4 + 1/10/(p + 3/5)
  for (const double t : {0.0, 1e-9, 0.3, 40.0}) {
    const double theta1 = fast::theta1(shear, t).value;
    CHECK(fast::theta1(operators, t).value == doctest::Approx(theta1).epsilon(1e-15));
    CHECK(fast::theta1(series, t).value == doctest::Approx(theta1).epsilon(1e-15));
    CHECK(fast::theta2(operators, t).value ==
          doctest::Approx(fast::theta2(shear, bulk, t).value).epsilon(1e-14));
    CHECK(fast::relaxation(operators, Strain::dilatation, t).value ==
          doctest::Approx(fast::relaxation(bulk, t).value).epsilon(1e-15));
  }
}

TEST_CASE("rational solids: roots that are one, or nearly, cost no digit") {
  // theta1 = (p + 2)^2/(2 (p + 1)^2): 1/2 and e^-t (1 + t/2)
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
  // Four equal roots: 6K + 2G = 8 (p + 1)^4/((p + 2)^2 (p + 2)^2) has 3/8 at once.
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
  const auto creep_of = [](const RationalSolid& solid) { return fast::creep(solid, Strain::dilatation, 1); };
  CHECK_THROWS_WITH_AS(creep_of(PronySeries{{1, {1}, {-1}}, {1, {1}, {1}}}), "theta1_rate = -1: must be >= 0",
                       data::BadInput);
  CHECK_THROWS_WITH_AS(creep_of(PronySeries{{1, {1}, {1}}, {0, {0, 0}, {1, 1}}}),
                       doctest::Contains("theta2 = 0 at all times"), data::BadInput);
  CHECK_THROWS_WITH_AS(creep_of(PronySeries{{1, {1}, {1}}, {3, {3}, {1}}}),
                       doctest::Contains("theta2 = 3 theta1 at all times"), data::BadInput);
  CHECK_THROWS_WITH_AS(creep_of(DifferentialOperators{{1, 1}, {1}, {1}, {1}}),
                       doctest::Contains("Q = of degree 0: must be of the degree of P, 1, or of one more"),
                       data::BadInput);
  CHECK_THROWS_WITH_AS(creep_of(DifferentialOperators{{1}, {1}, {1}, {1, -2}}),
                       "Q_dilatation_1 = -2: must be >= 0", data::BadInput);
  CHECK_THROWS_WITH_AS(creep_of(DifferentialOperators{{0, 0}, {1}, {1}, {1}}), doctest::Contains("P = 0"),
                       data::BadInput);
  CHECK_THROWS_WITH_AS(fast::theta1(solids[0], -1), doctest::Contains("t = -1"), data::BadInput);
  CHECK_THROWS_WITH_AS(fast::storage(solids[0], Strain::shear, INFINITY), doctest::Contains("omega = inf"),
                       data::BadInput);
  CHECK_THROWS_WITH_AS(fast::storage(DifferentialOperators{{0, 1}, {1, 1}, {1}, {1}}, Strain::shear, 0),
                       "omega = 0: must not be where the modulus is infinite", data::BadInput);
  CHECK_THROWS_WITH_AS(fast::theta1(data::SingleRelaxationTimeSolid{1, 1, 0, 2}, 1),
                       doctest::Contains("tau = 0"), data::BadInput);
}
