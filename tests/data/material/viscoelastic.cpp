#include <nipref/data/material/viscoelastic.hpp>

#include "support/test.hpp"

using namespace nipref;
using Complex = std::complex<double>;

TEST_CASE("one relaxation time doubles the compliance, the thesis's wrong rate makes it 1.875 times") {
  const double shear = 3.0 / 8;  // Poisson's ratio 1/3 with bulk 1
  const auto right = data::single_relaxation_time_solid(1, shear, 0.1).functions()->normal_compliance();
  CHECK(right.long_time() / right.instantaneous == doctest::Approx(2).epsilon(1e-14));
  const auto wrong = data::single_relaxation_time_solid(1, shear, 0.1, data::misprinted_rate_factor);
  const auto normal = wrong.functions()->normal_compliance();
  CHECK(normal.long_time() / normal.instantaneous == doctest::Approx(1.875).epsilon(1e-14));
  CHECK(wrong.functions()->theta1.instantaneous == doctest::Approx(4.0 / 3).epsilon(1e-15));
  CHECK(wrong.functions()->theta2.instantaneous == doctest::Approx(4.0 / 9).epsilon(1e-15));
}

TEST_CASE("an elastic solid forgets nothing because it has no memory") {
  const data::ElasticMaterial steel{2, 0.25};
  const auto solid = data::elastic_solid(steel);
  CHECK(solid.functions()->theta1.terms.empty());
  CHECK(solid.functions()->normal_compliance().long_time() ==
        doctest::Approx(steel.normal_compliance()).epsilon(1e-15));
}

TEST_CASE("a gain of energy in a narrow band is found, whatever its place") {
  for (const double resonance : {0.31, 1.0137, 7.7}) {
    for (const double width : {1e-2, 1e-4, 1e-7}) {
      // A resonance with the peak compliance 1/100. With one sign it loses energy at its peak and is physical, with the
      // other it is not.
      const auto with = [&](double sign) {
        const Complex rate(width, resonance), amplitude(0, sign * width / 100);
        const data::MaterialFunction shear{
            1, {{0.001, 1}, {amplitude, rate}, {std::conj(amplitude), std::conj(rate)}}};
        const data::MaterialFunction plane{
            0.3, {{0.0003, 1}, {0.3 * amplitude, rate}, {0.3 * std::conj(amplitude), std::conj(rate)}}};
        return refusal_of([&] { (void)data::ViscoelasticMaterial(shear, plane); });
      };
      CAPTURE(width);
      const bool one_refused = with(1).starts_with("material shear loss");
      const bool other_refused = with(-1).starts_with("material shear loss");
      CHECK(one_refused != other_refused);
    }
  }
}

TEST_CASE("a Kelvin-Voigt solid, rigid at once, and a Maxwell fluid, which flows for ever, are materials") {
  CHECK_FALSE(data::prony_solid({0, {1}, {2}}, {0, {0.25}, {2}}).functions()->theta1.is_fluid());
  const auto maxwell = data::prony_solid({1, {3}, {0}}, {0.25, {0.75}, {0}});
  CHECK(maxwell.functions()->theta1.is_fluid());
  CHECK(std::abs(maxwell.functions()->theta1.transform({0, 0.5}) - Complex(1, -6)) < 1e-14);
  // These solids would give back energy for ever, or in dilatation at some frequency.
  CHECK_REFUSED(data::prony_solid({1, {-3}, {0}}, {0.25, {0.75}, {0}}), "theta1 rate = 0");
  CHECK_REFUSED(data::prony_solid({1, {3}, {0}}, {0.25, {0.01}, {0}}), "material dilatation loss");
  CHECK_REFUSED(data::ViscoelasticMaterial({0, {}}, {1, {}}), "theta1 instantaneous = 0");
}

TEST_CASE("what is no material is refused by the name of what is wrong") {
  const auto with_theta1 = [](const data::PronyList& theta1) {
    return data::prony_solid(theta1, {0.3, {0.1}, {1}});
  };
  CHECK_REFUSED(data::single_relaxation_time_solid(1, 1, 0), "relaxation_time = 0: ");
  CHECK_REFUSED(data::single_relaxation_time_solid(1, 1, -2), "relaxation_time = -2: ");
  CHECK_REFUSED(data::single_relaxation_time_solid(0, 1, 1), "bulk = 0: ");
  CHECK_REFUSED(data::single_relaxation_time_solid(1, 1, 0, data::misprinted_rate_factor),
                "relaxation_time = 0: ");
  CHECK_REFUSED(data::standard_linear_solid({1, 1, 1, 1, 0, 1}), "shear_viscosity = 0: ");
  CHECK_REFUSED(data::operator_solid({{1}, {0, 0}, {1}, {7}}), "Q = 0: ");
  CHECK_REFUSED(with_theta1({1, {}, {}}), "theta1_amplitudes = []");
  CHECK_REFUSED(with_theta1({1, {1}, {1, 2}}), "theta1_rates = 2");
  CHECK_REFUSED(with_theta1({1, {1}, {-1}}), "theta1 rate = -1");
  CHECK_REFUSED(with_theta1({1, {1, 1}, {2, 2}}), "theta1 rate = 2: must not occur twice");
  CHECK_REFUSED(with_theta1({1, {-0.5}, {1}}), "material shear loss");
  CHECK_REFUSED(with_theta1({1, {-2}, {1}}), "theta1 long-time compliance");
  // The plane compliance creeps far less than the shear, so that the bulk modulus would have to gain energy.
  CHECK_REFUSED(data::prony_solid({1, {1}, {1}}, {0.3, {0.001}, {1}}), "material dilatation loss");
}
