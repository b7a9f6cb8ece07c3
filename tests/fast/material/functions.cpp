// Compliances of materials whose rates are roots of polynomials.
#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/fast/material/functions.hpp>

#include "support/test.hpp"

using namespace nipref;
using Complex = std::complex<double>;

namespace {

data::MaterialFunctions factored(const data::DifferentialOperators& operators) {
  return fast::material_functions(data::operator_solid(operators));
}

const Complex places[]{{0, 0}, {0, 0.3}, {0, 1}, {0, 40}, {2, 5}, {1e6, 0}, {0.01, -0.2}};

void check_equal(Complex a, Complex b, double tolerance) {
  CAPTURE(a.real(), b.real());
  CHECK(std::abs(a - b) <= tolerance * std::abs(b));
}

}  // namespace

TEST_CASE("operators: of a double root that both sides have once, the other stays") {
  // 1/(2G) = 1/(2 (1 + p)), theta2 = 3 (2 + p)/((1 + p) (10 + 2 p))
  const auto material =
      factored({.p = {1, 1}, .q = {1, 2, 1}, .p_dilatation = {2, 1}, .q_dilatation = {1, 1}});
  REQUIRE(material.theta2.terms.size() == 2);
  for (const Complex p : places) {
    check_equal(material.theta1.transform(p), 1.0 / (2.0 * (1.0 + p)), 1e-13);
    check_equal(material.theta2.transform(p), 3.0 * (2.0 + p) / ((1.0 + p) * (10.0 + 2.0 * p)), 1e-13);
  }
}

TEST_CASE("operators: rates and amplitudes of roots 1e-5 apart are good to a double's last places") {
  // Q = (1 + p) (1 + 2^-17 + p), exactly.
  const auto theta1 =
      factored(
          {.p = {2, 1, 0.25}, .q = {1 + 0x1p-17, 2 + 0x1p-17, 1}, .p_dilatation = {1}, .q_dilatation = {8}})
          .theta1;
  REQUIRE(theta1.terms.size() == 2);
  double slow = theta1.terms[0].rate.real(), fast = theta1.terms[1].rate.real();
  if (slow > fast) std::swap(slow, fast);
  CHECK(slow == 1);
  CHECK(fast == 1 + 0x1p-17);
  // -0.125 (p^2 + 4 p + 8)/(p + other rate) at each root, where p + other rate is 2^-17 in size.
  for (const auto& [amplitude, rate] : theta1.terms) {
    const double r = rate.real(), above = 0.125 * (r * r - 4 * r + 8);
    CHECK(amplitude.real() == doctest::Approx((r == 1 ? 1 : -1) * above * 0x1p17).epsilon(4e-16));
  }
}

TEST_CASE("operators: a fluid has a rate that is 0, no -0, and a dashpot beside a spring nothing at once") {
  // P/Q = 1 + 0.8/p + 0.5/(p + 1) + 0.3/(p + 2) + 0.2/(p + 3): one rate is 0, and an iteration finds the others.
  const auto fluid = factored({{4.8, 19.1, 20.1, 7.8, 1}, {0, 6, 11, 6, 1}, {1}, {7}});
  CHECK(fluid.theta1.is_fluid());
  CHECK(fluid.theta1.terms.size() == 4);
  CHECK_FALSE(fluid.theta2.is_fluid());
  const auto flow = std::ranges::find(fluid.theta1.terms, 0.0, &data::RelaxationTerm::rate);
  CHECK_FALSE(std::signbit(flow->rate.real()));
  check_equal(flow->amplitude, 0.4, 1e-13);
  // K = 2 + 3 p: theta2 = 3/(14 + 18 p).
  const auto voigt = factored({{1}, {1}, {1}, {2, 3}});
  CHECK(voigt.theta1.instantaneous == 0.5);
  CHECK(voigt.theta2.instantaneous == 0);
  REQUIRE(voigt.theta2.terms.size() == 1);
  check_equal(voigt.theta2.terms[0].rate, 14.0 / 18, 1e-15);
  check_equal(voigt.theta2.terms[0].amplitude, 3.0 / 18, 1e-15);
}

TEST_CASE("operators: what is no material is refused by the operator or the function that is wrong") {
  const auto refused = [](const data::DifferentialOperators& operators) -> std::string {
    try {
      (void)factored(operators);
    } catch (const data::NoMaterial& error) {
      return error.key() + " = " + error.value();
    }
    return "(accepted)";
  };
  CHECK(refused({{1, 2, 1}, {4, 4, 1}, {1}, {7}}) == "material.Q = -2");
  CHECK(refused({{1, 1, 1}, {1, 1}, {1}, {7}}) == "material.Q = of degree 1");
  CHECK(refused({{1}, {3}, {1}, {-1}}) == "material.Q_dilatation = 0");
  CHECK(refused({{2, 1}, {-1, 1}, {1}, {7}}) == "material.theta1 rate = -1");
  // This solid stiffens under a lasting load.
  CHECK(refused({{1, 1}, {2, 1}, {1}, {7}}).starts_with("material.shear loss = "));
}
