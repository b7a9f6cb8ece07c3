// A rolling sheet's compliance and its inverse.
#include <nipref/ref/viscoelastic_nip/internal/rolling_sheet.hpp>

#include "support/test.hpp"

using namespace nipref::ref;

namespace {

RollingMaterial material_of(std::vector<RollingMemory> normal) { return {1, std::move(normal), 0, {}}; }

/// 1 + sum amplitude/(D + rate)
ComplexFloat response(const std::vector<RollingMemory>& terms, const ComplexFloat& D) {
  ComplexFloat sum(1);
  for (const RollingMemory& term : terms) sum = sum + term.amplitude / (D + term.rate);
  return sum;
}

}  // namespace

TEST_CASE("ref: a rolling sheet's compliance times its inverse is 1, whatever the rates") {
  const WorkingDigits working(40);
  const ComplexFloat one(1);
  const std::vector<std::vector<RollingMemory>> materials{
      {},
      {{one, ComplexFloat(2)}},
      {{one, ComplexFloat(2)},
       {ComplexFloat(1e-6), ComplexFloat(2.001)},
       {ComplexFloat(0.3), ComplexFloat(1e5)}},
      {{ComplexFloat(5), ComplexFloat()}, {one, ComplexFloat(0.1)}},
      {{ComplexFloat(0.2, -0.1), ComplexFloat(1, 3)},
       {ComplexFloat(0.2, 0.1), ComplexFloat(1, -3)},
       {one, ComplexFloat(0.5)}},
  };
  for (const auto& terms : materials) {
    const RollingSheet sheet(material_of(terms));
    CHECK(terms.size() == sheet.inverse.size());
    for (const ComplexFloat& D : {ComplexFloat(0.7), ComplexFloat(3, -2), ComplexFloat(1e4)}) {
      const ComplexFloat product = response(terms, D) * response(sheet.inverse, D);
      CHECK(abs(product - one) < 1e-30);
    }
    for (const RollingMemory& term : sheet.inverse) CHECK(term.rate.re > 0);
  }
}

TEST_CASE("ref: panels are as narrow as memories are short, and digits are lost as they soften") {
  const WorkingDigits working(30);
  const auto sheet = [](double amplitude, double rate) {
    return RollingSheet(material_of({{ComplexFloat(amplitude), ComplexFloat(rate)}}));
  };
  CHECK(sheet(0.01, 0.02).resolution().first == 1);
  CHECK(sheet(500, 1000).resolution().first == doctest::Approx(1.5 / 1500));
  CHECK(sheet(1, 1).lost_digits() == 0);
  CHECK(sheet(2e6, 2).lost_digits() == 6);
  CHECK(sheet(1e4, 0).lost_digits() == 4);
}
