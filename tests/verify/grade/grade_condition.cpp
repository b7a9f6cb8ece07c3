#include <doctest/doctest.h>

#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/grade/grade.hpp>

using namespace nipref::verify;

TEST_CASE("the condition number is that of known powers") {
  // I2 is constant; un, of an elastic sheet, is proportional to 1/young, and its Poisson's ratio enters as 1 - nu^2.
  CHECK(condition_number(find_quantity("I2"), {0.7}).value() == 0);
  const Quantity& un = find_quantity("un");
  Point point;
  for (const Argument& argument : un.arguments) point.push_back(argument.name == "poisson" ? 0.25 : 3);
  const double of_kernel = condition_number(find_quantity("I1"), {3}).value();
  const double of_poisson = 2 * 0.25 * 0.25 / (1 - 0.25 * 0.25);
  CHECK(condition_number(un, point).value() == doctest::Approx(of_kernel + 1 + of_poisson).epsilon(1e-8));
}

TEST_CASE("next to a zero the condition number is large, and outside the domain there is none") {
  CHECK(condition_number(find_quantity("I7"), {1.0}).value() < 10);
  CHECK_FALSE(condition_number(find_quantity("I1"), {0.0}).has_value());
}
