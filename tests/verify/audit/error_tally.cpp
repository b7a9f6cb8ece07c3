#include <nipref/verify/audit/error_tally.hpp>
#include <nipref/verify/audit/internal/stored.hpp>
#include <nipref/verify/support/random.hpp>

#include "support/test.hpp"

using namespace nipref::verify;

namespace {

ErrorTally tally_of(const std::vector<double>& numbers) {
  ErrorTally tally;
  for (const double number : numbers) tally.add(number);
  return tally;
}

/// Numbers of all sizes, like the errors of a bad kernel.
std::vector<double> some_numbers() {
  Random random("numbers to be tallied");
  std::vector<double> numbers{0, 0x1p-1074, 1, 0x1p-6, std::nextafter(0x1p-6, 1), 1e300};
  for (int i = 0; i < 3000; ++i) numbers.push_back(random.log_uniform(1e-9, 1e18));
  return numbers;
}

}  // namespace

TEST_CASE("a tally is the same whatever the order and the parts in which numbers come") {
  std::vector<double> numbers = some_numbers();
  const ErrorTally all = tally_of(numbers);
  std::ranges::reverse(numbers);
  CHECK(tally_of(numbers) == all);
  for (const std::size_t cut : {std::size_t{0}, std::size_t{1}, std::size_t{1234}, numbers.size()}) {
    const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(cut);
    ErrorTally sum = tally_of({middle, numbers.end()});
    sum.add(tally_of({numbers.begin(), middle}));
    CHECK(sum == all);
    CHECK(sum.mean() == all.mean());
  }
  CHECK(restored<ErrorTally>(Json::parse(stored(all).line())) == all);
}

TEST_CASE("a tally's percentile is never below the exact one, and a thirty-second above it at most") {
  std::vector<double> numbers = some_numbers();
  const ErrorTally tally = tally_of(numbers);
  std::ranges::sort(numbers);
  for (const double share : {1e-9, 0.1, 0.5, 0.9, 0.99, 0.999, 1.0}) {
    const double exact = numbers[static_cast<std::size_t>(
        std::max(0.0, std::ceil(share * static_cast<double>(numbers.size())) - 1))];
    CAPTURE(share);
    CHECK(tally.percentile(share) >= exact);
    CHECK(tally.percentile(share) <= std::max(exact * (1 + 1.0 / 32), 0x1p-6));
  }
  CHECK(tally_of({0.3}).percentile(0.5) == 0.3);  // never above the largest
}

TEST_CASE("a tally's mean is exact to 2^-32, and infinite where a number is or its sum has no double") {
  CHECK(tally_of({1, 2, 6}).mean() == 3);
  CHECK(tally_of({0.1}).mean() >= 0.1);
  CHECK(tally_of({0.1}).mean() - 0.1 < 0x1p-32);
  CHECK(tally_of({1, infinite}).mean() == infinite);
  CHECK(tally_of({1, infinite}).percentile(0.5) == 1);
  CHECK(tally_of({1, infinite}).percentile(1) == infinite);
  CHECK(tally_of({1e305}).mean() == infinite);
  const ErrorTally endless = tally_of({1, infinite});
  CHECK(restored<ErrorTally>(Json::parse(stored(endless).line())) == endless);
}

TEST_CASE("what is no tally is not read as one") {
  for (const char* const text :
       {"{}", "[]", R"({"largest":"0x1p0","sum":"1","bins":[1]})", R"({"largest":1,"sum":"1","bins":[]})",
        R"({"largest":"0x1p0","sum":"-1","bins":[]})", R"({"largest":"0x1p0","sum":"1","bins":[1,-1]})",
        R"({"largest":"","sum":"1","bins":[]})"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(static_cast<void>(restored<ErrorTally>(Json::parse(text))), JsonMisfit);
  }
  CHECK_THROWS_AS(static_cast<void>(Json::parse("{\"torn\":")), JsonMisfit);
}
