// The sheet's compliances in the rolling contact, for every description of a material.
#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_sheet.hpp>

#include "support/test.hpp"

using namespace nipref;
using namespace nipref::ref;

namespace {

RollingMaterial rolled(const data::ViscoelasticMaterial& material) {
  return rolling_material({6, 0.25, material, 0.5});
}

/// The largest relative difference of the constants.
double apart(const RollingMaterial& x, const RollingMaterial& y) {
  Float most = abs(x.compliance / y.compliance - 1);
  const auto take = [&](const Float& a, const Float& b) { most = std::max(most, Float(abs(a / b - 1))); };
  take(x.theta2_at_once, y.theta2_at_once);
  for (const auto& [a, b] : {std::pair(&x.normal, &y.normal), std::pair(&x.theta2, &y.theta2)}) {
    REQUIRE(a->size() == b->size());
    for (std::size_t i = 0; i < a->size(); ++i) {
      take((*a)[i].rate.re, (*b)[i].rate.re);
      take((*a)[i].amplitude.re, (*b)[i].amplitude.re);
    }
  }
  return static_cast<double>(most);
}

}  // namespace

TEST_CASE("rolling material: one solid in several words is one, to every digit") {
  const WorkingDigits working(40);
  // 1/0.375 is no double, but the products of the other solids' constants are.
  const auto single = rolled(data::single_relaxation_time_solid(3, 0.75, 0.375));
  CHECK(apart(rolled(data::standard_linear_solid({0.75, 0.75, 3, 3, 0.75 * 0.375, 3 * 0.375})), single) <
        1e-38);
  CHECK(apart(rolled(data::operator_solid({{2, 0.375}, {0.75, 0.75 * 0.375}, {2, 0.375}, {3, 3 * 0.375}})),
              single) < 1e-38);
  REQUIRE(single.normal.size() == 1);
  CHECK(abs(single.normal[0].rate.re * 0.375 * 4 - 1) < 1e-38);  // b/speed is 1/4
  CHECK(abs(single.normal[0].amplitude.re * 0.375 * 4 - 1) < 1e-38);
}

TEST_CASE("rolling material: an elastic one is by its constants, and functions are as they are") {
  const WorkingDigits working(40);
  const auto elastic = rolled(data::elastic_solid({3, 0.1}));
  const Float poisson = 0.1;
  CHECK(abs(elastic.compliance / (2 * (1 - poisson * poisson) / 3) - 1) < 1e-38);
  CHECK(abs(elastic.theta2_at_once / ((1 - 2 * poisson) / (2 * (1 - poisson))) - 1) < 1e-38);
  const auto functions = rolled(data::prony_solid({1, {0.3, 0.2}, {0.7, 2}}, {0.25, {0.1}, {2}}));
  REQUIRE(functions.normal.size() == 2);
  CHECK(functions.compliance == 1.25);
  for (const RollingMemory& term : functions.normal) {
    const bool shared = term.rate.re == 0.5;
    CHECK(term.rate.re == Float(shared ? 2.0 : 0.7) / 4);
    CHECK(abs(term.amplitude.re * 5 - (shared ? Float(0.2) + 0.1 : Float(0.3))) < 1e-38);
  }
}

TEST_CASE("rolling material: both of two conjugate terms stand, and none without amplitude") {
  const WorkingDigits working(40);
  const auto pair = [](double size) -> data::MaterialFunction {
    const std::complex<double> amplitude{size / 16, size / 8};
    return {size, {{amplitude, {1, 2}}, {std::conj(amplitude), {1, -2}}, {0, 7}}};
  };
  const auto material = rolled({pair(1), pair(0.25)});
  REQUIRE(material.normal.size() == 2);
  CHECK(material.normal[0].rate.im == 0.5);
  CHECK(material.normal[0].amplitude.re == 1.0 / 16 / 4);
  CHECK(material.normal[0].amplitude.im == 1.0 / 8 / 4);
  CHECK(material.normal[1].rate.im == -0.5);
  CHECK(material.normal[1].amplitude.im == -1.0 / 8 / 4);
  REQUIRE(material.theta2.size() == 3);
  CHECK(abs(material.theta2[0].amplitude.re * 5 - material.normal[0].amplitude.re) < 1e-38);
}
