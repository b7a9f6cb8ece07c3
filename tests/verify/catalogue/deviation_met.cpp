// What it means that a value is as accurate as was asked.
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/deviation.hpp>

#include "support/test.hpp"

namespace {

using namespace nipref;

ref::Float decimal(const std::string& text) {
  ref::Float number = ref::zero_of_bits(200);
  mpfr_set_str(ref::raw(number), text.c_str(), 10, MPFR_RNDN);
  return number;
}

/// Of a quantity with this envelope at its argument.
bool is_met_of(const std::string& value, const std::string& error, int digits, double envelope) {
  verify::Quantity quantity = verify::find_quantity("I1");
  quantity.envelope = [=](std::span<const double>) { return envelope; };
  return verify::is_met(quantity, verify::parse_arguments(quantity, {{"alpha", "1"}}),
                        ref::Estimate(decimal(value), decimal(error), digits), digits);
}

}  // namespace

TEST_CASE("the reference's digits are met by an error of no more than that part of the scale") {
  CHECK(is_met_of("91.370172532017530", "4.2e-14", 15, 0));
  CHECK_FALSE(is_met_of("91.370172532017530", "4.2e-14", 16, 0));
  CHECK(is_met_of("-2", "1.999e-16", 16, 0));
  CHECK_FALSE(is_met_of("-2", "2.001e-16", 16, 0));
  // A value that is small beside the size that it might have has the digits of that.
  CHECK_FALSE(is_met_of("7e-9", "2e-20", 16, 0));
  CHECK(is_met_of("7e-9", "2e-20", 16, 0.1));
  CHECK(is_met_of("0", "0", 16, 0));
  CHECK_FALSE(is_met_of("0", "1e-300", 16, 0));
}

TEST_CASE("digits are met or missed beyond the range of doubles, too") {
  CHECK(is_met_of("3e-8686", "2e-8702", 16, 0));
  CHECK_FALSE(is_met_of("3e-8686", "4e-8702", 16, 0));
  CHECK_FALSE(is_met_of("1", "nan", 16, 0));
  CHECK_FALSE(is_met_of("1", "1e-15", 16, std::numeric_limits<double>::infinity()));
  const verify::Quantity& quantity = verify::find_quantity("I1");
  const auto tiny = verify::parse_arguments(quantity, {{"alpha", "1e-400"}});  // no double
  CHECK(verify::is_met(quantity, tiny, quantity.by_ref(tiny.exact, 30), 30));
}

TEST_CASE("nothing is met by an error that is no number") {
  CHECK(verify::is_met(1e-6, 1, 1e-6));
  CHECK_FALSE(verify::is_met(1.1e-6, 1, 1e-6));
  CHECK_FALSE(verify::is_met(std::nan(""), 1, 1e-6));
}
