#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/golden/make.hpp>

#include "support/test.hpp"

using namespace nipref;
using verify::Quantity;

namespace {

const verify::Provenance nowhere{"0", "a compiler", "4", std::string(40, 'a'), true};

/// The quantity with the reference's value changed by this relative part. The bound is not changed.
Quantity with_wrong_reference(Quantity quantity, double part) {
  quantity.by_ref = [by_ref = quantity.by_ref, part](std::span<const ref::Exact> arguments, int digits) {
    ref::Estimate reference = by_ref(arguments, digits);
    ref::Float moved = ref::zero_of_bits(ref::bits_of(reference.value));
    mpfr_mul_d(ref::raw(moved), ref::raw(reference.value), part, MPFR_RNDN);
    mpfr_add(ref::raw(reference.value), ref::raw(reference.value), ref::raw(moved), MPFR_RNDN);
    return reference;
  };
  return quantity;
}

}  // namespace

TEST_CASE("golden values made for a kernel are confirmed, of all origins, and the same when made again") {
  const Quantity& quantity = verify::find_quantity("I4");
  const verify::GoldenOptions options{20, 40, "7"};
  const verify::MadeGolden made = verify::make_golden(quantity, options, nowhere);
  CHECK(made.refused.empty());
  REQUIRE(made.file.rows.size() == 20);
  CHECK(made.file.entry("command") == "nipref golden make I4 --points 20 --digits 40 --seed 7");
  CHECK(made.file.entry("tree") == "clean");
  for (const char* origin : {"hard", "worst:fast@aaaaaaaaaaaa", "dense"})
    CHECK(std::ranges::count(made.file.rows, std::string(origin), &verify::GoldenRow::origin) > 0);
  for (const verify::GoldenRow& row : made.file.rows) {
    CHECK(row.proven);
    CHECK(row.confirmed_by.starts_with("integral along the real axis"));
    CHECK(mpfr_cmp_d(ref::raw(row.number().error), 1e-40 * std::max(row.scale, 1e-200)) <= 0);
  }
  CHECK(verify::golden_text(made.file) ==
        verify::golden_text(verify::make_golden(quantity, options, nowhere).file));
}

TEST_CASE("a value that no second method confirms is not taken, however little it is off") {
  for (const char* const name : {"I1", "J2", "halfspace.compliance"}) {
    CAPTURE(name);
    const Quantity wrong = with_wrong_reference(verify::find_quantity(name), 1e-35);
    const verify::MadeGolden made = verify::make_golden(wrong, {10, 40}, nowhere);
    CHECK(made.refused.size() >= 5);
    for (const verify::GoldenRow& row : made.file.rows) CHECK(row.number().to_double() == 0);
    for (const verify::RefusedRow& row : made.refused) CHECK(contains(row.reason, "differs by"));
  }
}

TEST_CASE("a quantity without a second method has no golden values") {
  Quantity unknown = verify::find_quantity("I1");
  unknown.name = "I9";
  CHECK_THROWS_AS(verify::make_golden(unknown, {5, 30}, nowhere), data::BadInput);
}
