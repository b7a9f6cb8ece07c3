
#include <nipref/fast/sheet/kernels.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/grade/grade.hpp>

#include "support/test.hpp"

using namespace nipref;
using namespace nipref::verify;

namespace {

verify::AuditOptions few_points() {
  verify::AuditOptions options;
  options.points = 2000;
  return options;
}

Grade grade_I3(double (*kernel)(double)) {
  return verify::grade(verify::find_quantity("I3"), kernel, few_points());
}

}  // namespace

TEST_CASE("fast graded as somebody else's code has the numbers of its audit") {
  const verify::Quantity& quantity = verify::find_quantity("I3");
  const auto audited = verify::audit(quantity, few_points());
  const auto by_point = [](std::span<const double> arguments) { return fast::I3(arguments[0]); };
  for (const Grade& grade : {grade_I3([](double alpha) { return fast::I3(alpha); }),
                             verify::grade(quantity, by_point, few_points())}) {
    CHECK(grade.found.kept());
    CHECK(grade.found.max_error_ulp == audited.max_error_ulp);
    CHECK(grade.found.errors == audited.errors);
    CHECK(grade.found.worst == audited.worst);
    CHECK(grade.condition.has_value());
  }
}

TEST_CASE("a wrong sign is wrong everywhere, and a wrong limit where it is") {
  const Grade sign = grade_I3([](double alpha) { return -fast::I3(alpha); });
  CHECK_FALSE(sign.found.kept());
  REQUIRE(sign.found.spread.wrong.has_value());
  CHECK(sign.found.spread.wrong->lower[0] < -100);
  CHECK(sign.found.spread.wrong->upper[0] > 100);
  CHECK(sign.found.max_relative_error == doctest::Approx(2));

  const Grade tiny =
      grade_I3([](double alpha) { return fast::I3(alpha) * (std::fabs(alpha) < 1e-6 ? 1.01 : 1); });
  CHECK_FALSE(tiny.found.kept());
  REQUIRE(tiny.found.spread.wrong.has_value());
  CHECK(tiny.found.spread.wrong->upper[0] < 1e-6);
  CHECK(tiny.found.spread.wrong->lower[0] > -1e-6);
  CHECK(tiny.found.spread.wrong->upper[0] > 1e-8);
  verify::Json row = verify::grade_json(tiny);
  row.append({{"_kernel", false},
              {"own", nullptr},
              {"promise", "2 ulp"},
              {"baseline", nullptr},
              {"remarks", std::vector<verify::Json>{}}});
  CHECK(contains(verify::text_of("grade.txt", row), "above the promise at"));
}

TEST_CASE("single precision is seen, but for the points that it can hold") {
  const Grade single =
      grade_I3([](double alpha) { return static_cast<double>(static_cast<float>(fast::I3(alpha))); });
  CHECK_FALSE(single.found.kept());
  CHECK(single.found.errors.percentile(0.5) > 1e6);
}

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
