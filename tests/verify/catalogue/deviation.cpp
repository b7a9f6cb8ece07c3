#include <nipref/ref/number/enclosure.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/deviation.hpp>

#include "support/test.hpp"

using namespace nipref;

namespace {

ref::Float decimal(const std::string& text) {
  ref::Float number = ref::zero_of_bits(200);
  mpfr_set_str(ref::raw(number), text.c_str(), 0, MPFR_RNDN);
  return number;
}

/// The deviation of a value by fast from the reference's value with this bound.
verify::Deviation deviation_of(double value, const std::string& truth, const std::string& bound,
                               double envelope) {
  return verify::deviation(value, ref::Enclosure{decimal(truth), decimal(bound), 16}, envelope);
}

/// Whether a value of a quantity with this envelope at its argument has these digits.
bool is_met_of(const std::string& value, const std::string& error, int digits, double envelope) {
  verify::Quantity quantity = verify::find_quantity("I1");
  quantity.envelope = [=](std::span<const double>) { return envelope; };
  return verify::is_met(quantity, verify::parse_arguments(quantity, {{"alpha", "1"}}),
                        ref::Estimate(decimal(value), decimal(error), digits), digits);
}

constexpr double epsilon = std::numeric_limits<double>::epsilon();

}  // namespace

TEST_CASE("a deviation counts ulps of the value or the envelope, and adds the reference's bound") {
  const verify::Deviation found = deviation_of(1 + 3 * epsilon, "1", "0", 0);
  CHECK(found.ulps == 3);
  CHECK(found.relative == 3 * epsilon);
  CHECK(found.scale == 1);
  const verify::Deviation near_zero = deviation_of(3 * 0x1p-54, "0x1p-54", "0", 4);
  CHECK(near_zero.ulps == 0x1p-53 / (4 * epsilon));
  CHECK(near_zero.relative == 2);
  CHECK(near_zero.of_scale == 0x1p-55);
  CHECK(deviation_of(1, "1", "0x1p-52", 0).ulps == 1);
  CHECK(deviation_of(1 + epsilon, "1", "0x1p-52", 0).ulps == 2);
  CHECK(deviation_of(0, "0x1p-1075", "0", 0).ulps == 0.5);  // half of the smallest double
  CHECK(deviation_of(0, "0", "0", 0).ulps == 0);
  CHECK(deviation_of(0, "0", "0", 0).relative == 0);
  for (const double value : {not_a_number, infinite}) {
    const verify::Deviation without = deviation_of(value, "1", "0", 1);
    for (const double each : {without.ulps, without.relative, without.of_scale}) CHECK(std::isinf(each));
  }
}

TEST_CASE("an ulp is the distance to the next larger double, never below the smallest") {
  for (const double scale : {1.0, 1.5, 0x1.fffffffffffffp0, 2.0, 1e-300, 1e300, 0x1p-1022, 0x1p-1074, 0.0}) {
    CAPTURE(scale);
    CHECK(verify::ulp_of(scale) == std::nextafter(scale, infinite) - scale);
    CHECK(verify::ulp_of(-scale) == verify::ulp_of(scale));
  }
  for (const double none : {not_a_number, infinite}) CHECK_THROWS_AS(verify::ulp_of(none), data::BadInput);
}

TEST_CASE("the reference's digits are met by an error of no more than that part of the scale") {
  CHECK(is_met_of("91.370172532017530", "4.2e-14", 15, 0));
  CHECK_FALSE(is_met_of("91.370172532017530", "4.2e-14", 16, 0));
  CHECK(is_met_of("-2", "1.999e-16", 16, 0));
  CHECK_FALSE(is_met_of("-2", "2.001e-16", 16, 0));
  // If the value is small beside the envelope, the digits are those of the envelope.
  CHECK_FALSE(is_met_of("7e-9", "2e-20", 16, 0));
  CHECK(is_met_of("7e-9", "2e-20", 16, 0.1));
  CHECK(is_met_of("0", "0", 16, 0));
  CHECK_FALSE(is_met_of("0", "1e-300", 16, 0));
  // The same holds beyond the range of doubles.
  CHECK(is_met_of("3e-8686", "2e-8702", 16, 0));
  CHECK_FALSE(is_met_of("3e-8686", "4e-8702", 16, 0));
  CHECK_FALSE(is_met_of("1", "nan", 16, 0));
  CHECK_FALSE(is_met_of("1", "1e-15", 16, infinite));
  const verify::Quantity& quantity = verify::find_quantity("I1");
  const auto tiny = verify::parse_arguments(quantity, {{"alpha", "1e-400"}});  // no double
  CHECK(verify::is_met(quantity, tiny, quantity.by_ref(tiny.exact, 30), 30));
  CHECK(verify::is_met(1e-6, 1, 1e-6));
  CHECK_FALSE(verify::is_met(1.1e-6, 1, 1e-6));
  CHECK_FALSE(verify::is_met(not_a_number, 1, 1e-6));
}
