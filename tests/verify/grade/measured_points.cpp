#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/grade/measured_points.hpp>

#include "support/scratch.hpp"

using namespace nipref;
using verify::MeasuredPoints;

namespace {

MeasuredPoints read(const std::string& csv, const std::optional<std::string>& quantity = std::nullopt,
                    const std::optional<std::string>& column = std::nullopt) {
  const ScratchFile file(csv);
  return verify::read_measured_points(file.path(), quantity, column).front();
}

/// The words with which a CSV is refused.
std::string refusal(const std::string& csv, const std::optional<std::string>& column = std::nullopt) {
  return refusal_of([&] { return read(csv, "I6", column); });
}

}  // namespace

TEST_CASE("points that are written are read back exactly, whatever columns are added") {
  const verify::Quantity& quantity = verify::find_quantity("I6");
  const std::vector<verify::Point> points{{0x1.23456789abcdep-300, -0.1}, {1.0 / 3, 1e300}};
  std::string csv = verify::points_csv(quantity, points, {"quantity: I6", "command: nipref points"});
  csv.replace(csv.find("eta_decimal") + 11, 0, ",mine");
  csv.replace(csv.find(",-0.1\n"), 6, ",-0.1,0x1p-3\n");
  csv.replace(csv.rfind('\n'), 1, ",nan\n");
  const MeasuredPoints back = read(csv);
  CHECK(back.quantity == &quantity);
  CHECK(back.points == points);
  CHECK(back.values[0] == 0.125);
  CHECK(std::isnan(back.values[1]));
  CHECK(back.contradicting_rows == 0);
  CHECK(back.short_rows == 0);
}

TEST_CASE("values are in the column that is named, or called value or as the quantity, or left alone") {
  CHECK(read("alpha,eta,value,other\n1,2,3,4\n", "I6").values[0] == 3);
  CHECK(read("alpha,eta,value,other\n1,2,3,4\n", "I6", "other").values[0] == 4);
  CHECK(read("I6,eta,alpha,x\n9,2,1,4\n", "I6").values[0] == 9);
  CHECK(read(" x , eta , alpha \n 5 , 2 , 1 \n", "I6").values[0] == 5);
  CHECK(read("x,eta,alpha\n5,2,1\n", "I6").points[0] == verify::Point{1, 2});
  CHECK(contains(refusal("alpha,eta,x,y\n1,2,3,4\n"), "must have the values in a column"));
  CHECK(contains(refusal("alpha,eta\n1,2\n"), "must have the values in a column"));
  CHECK(contains(refusal("alpha,eta,x\n1,2,3\n", "y"), "column = y"));
}

TEST_CASE("digits of an argument that were lost on the way are counted") {
  const MeasuredPoints lost = read(
      "eta,alpha,alpha_decimal,value\n0x1p0,0x1.5555555555555p-2,0.333333,1\n0x1p0,0x1p-1,0.5,1\n", "I6");
  CHECK(lost.contradicting_rows == 1);
  CHECK(lost.points[0][0] == 0x1.5555555555555p-2);
  CHECK(lost.short_rows == 0);
  const MeasuredPoints decimal = read(
      "eta_decimal,alpha_decimal,value\n0.3333333333333333,0,1\n0,0.333333,1\n2.000000000000000e-05,-0,1\n",
      "I6");
  CHECK(decimal.short_rows == 1);
}

TEST_CASE("an argument that has a default needs no column, and a choice is read by its name") {
  const MeasuredPoints points = read("axis,value\nin-plane,1\nnormal,2\n", "ti.rayleigh");
  const auto axis = std::ranges::find(points.quantity->arguments, "axis", &verify::Argument::name);
  const auto place = static_cast<std::size_t>(axis - points.quantity->arguments.begin());
  CHECK(axis->choice(points.points[0][place]) == "in-plane");
  CHECK(axis->choice(points.points[1][place]) == "normal");
}

TEST_CASE("a file of points that cannot be read is refused by line and column") {
  CHECK(contains(refusal("alpha,eta,value\n1,2,three\n"), ":2:5: must be a number"));
  CHECK(contains(refusal("alpha,eta,value\n1,inf,3\n"), ":2:3: must be a finite number"));
  CHECK(contains(refusal("alpha,eta,value\n\"1,5\",2,3\n"), ":2:1: must have a decimal point, not a comma"));
  CHECK(contains(refusal("alpha,value\n1,2\n"), "must have a column eta"));
  CHECK(contains(refusal("alpha,eta,value\n"), "must have a row"));
  CHECK(contains(refusal("alpha,eta,value\n1,2\n"), "must have 3 fields"));
  CHECK_THROWS_AS(static_cast<void>(read("alpha,value\n1,2\n")), data::BadInput);
  CHECK_THROWS_AS(static_cast<void>(read("# quantity: I9\nalpha,value\n1,2\n")), data::BadInput);
}
