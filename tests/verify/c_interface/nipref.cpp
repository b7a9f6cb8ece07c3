// The C interface: every quantity by its name, refusals, digits that are not reached.
#include <nipref/nipref.h>
#include <nipref/verify/catalogue/catalogue.hpp>

#include "support/test.hpp"

TEST_CASE("C: every quantity is found by its name, and says what it takes") {
  for (std::size_t number = 0; number < nipref_quantity_count(); ++number) {
    const nipref_quantity* const entry = nipref_quantity_at(number);
    CAPTURE(nipref_name(entry));
    CHECK(nipref_find(nipref_name(entry)) == entry);
    CHECK(nipref_definition(entry)[0] != 0);
    CHECK(nipref_promise(entry) > 0);
    for (std::size_t i = 0; i < nipref_arity(entry); ++i) CHECK(nipref_argument(entry, i) != nullptr);
  }
  CHECK(nipref_quantity_at(nipref_quantity_count()) == nullptr);
  CHECK(nipref_find("I8") == nullptr);
}

TEST_CASE("C: what is refused writes nothing, of a batch with one bad point as well") {
  const nipref_quantity *const I1 = nipref_find("I1"), *const I3 = nipref_find("I3");
  double points[] = {0.5, 1, 2}, values[] = {-1, -1, -1}, value = -1;
  const double* const columns[] = {points};
  CHECK(nipref_fast_batch(I3, 3, columns, 0, values) == 0);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(nipref_fast(I3, &points[i], 0, &value) == 0);
    CHECK(values[i] == value);
  }
  points[1] = not_a_number;
  values[0] = value = -1;
  const double zero = 0;
  CHECK(nipref_fast_batch(I3, 3, columns, 0, values) == nipref_bad_input);
  CHECK(nipref_fast(nullptr, points, 0, &value) == nipref_bad_input);
  CHECK(nipref_fast(I1, points, 2, &value) == nipref_bad_input);
  CHECK(nipref_fast(I1, &zero, 0, &value) == nipref_bad_input);
  CHECK(values[0] == -1);
  CHECK(value == -1);
  std::array<char, 10> text{"as it was"};
  std::array<char, 40> error{};
  int proven = -1;
  const char* const alpha[] = {"0.73"};
  CHECK(nipref_ref(I1, alpha, 30, text.data(), text.size(), error.data(), error.size(), &proven) ==
        nipref_bad_input);
  CHECK(std::string(text.data()) == "as it was");
}

TEST_CASE("C: digits that are not all there are said, and what is there is written") {
  using namespace nipref;
  // No quantity of the catalogue is known to miss its digits, so this is I1 with another reference.
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
