// The C interface says of the reference's digits that they are not all there.
#include <nipref/nipref.h>
#include <nipref/verify/catalogue/catalogue.hpp>

#include "support/test.hpp"

TEST_CASE("C: digits that are not all there are said, and what is there is written") {
  using namespace nipref;
  // No quantity of the catalogue is known to miss its digits: this is I1 with a reference of its own.
  verify::Quantity quantity = verify::find_quantity("I1");
  double relative_error = 0;
  quantity.by_ref = [&](std::span<const ref::Exact>, int digits) {
    return ref::Estimate(ref::Float(2), ref::Float(2 * relative_error), digits);
  };
  const std::array<const char*, 1> arguments{"1"};
  std::array<char, 80> value{}, error{};
  int proven = 1;
  const auto status_of = [&](double its_error) {
    relative_error = its_error;
    return nipref_ref(reinterpret_cast<const nipref_quantity*>(&quantity), arguments.data(), 16, value.data(),
                      value.size(), error.data(), error.size(), &proven);
  };
  CHECK(status_of(0.9e-16) == 0);
  CHECK(status_of(1.1e-16) == nipref_missed);
  CHECK(proven == 0);
  CHECK(std::stod(value.data()) == 2);
  CHECK(std::stod(error.data()) == doctest::Approx(2.2e-16));
}
