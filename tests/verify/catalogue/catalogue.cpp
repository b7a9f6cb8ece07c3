#include <nipref/verify/audit/internal/sampling.hpp>
#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/deviation.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>
#include <nipref/verify/catalogue/named_point.hpp>
#include <nipref/verify/support/random.hpp>

#include "support/proven_pages.hpp"

using namespace nipref;
using verify::Point;
using verify::Quantity;

TEST_CASE("every entry of the catalogue is complete") {
  for (const Quantity& quantity : verify::catalogue()) {
    CAPTURE(quantity.name);
    CHECK_FALSE(quantity.definition.empty());
    CHECK(quantity.definition.find('\n') == std::string::npos);
    CHECK_FALSE(quantity.source.empty());
    CHECK_FALSE(quantity.scale.empty());
    CHECK(quantity.promise > 0);
    CHECK(quantity.by_ref);
    CHECK(quantity.by_fast);
    CHECK(quantity.by_fast_loop);
    CHECK(quantity.envelope);
    REQUIRE_FALSE(quantity.arguments.empty());
    CHECK(quantity.arguments.size() <= verify::most_arguments);
    // Either each argument has hard values of its own, or the quantity draws its points.
    for (const verify::Argument& argument : quantity.arguments)
      CHECK(argument.hard_values.empty() == static_cast<bool>(quantity.draw));
  }
}

TEST_CASE("each quantity is once in the table of what is proven") {
  std::multiset<std::string> named, quantities;
  for (const TableRow& row : rows_of_proven("quantities")) {
    for (const std::string& name : names_in(row[0])) named.insert(name);
  }
  for (const Quantity& quantity : verify::catalogue()) quantities.insert(quantity.name);
  CHECK(named == quantities);
}

TEST_CASE("the table of what is proven calls these quantities estimated, and no others") {
  // The list is written out here, so that an error that a flag shares with the page is found.
  const std::set<std::string> families{"die", "rolling", "ellipse"};
  const std::string others =
      " halfspace.rolling_index_beyond ti.critical anisotropic.critical halfspace.condition ti.condition ti.branch "
      "ti.exponent ti.span_ratio ti.force ti.axis_ratio rolling_nip.creep ";
  for (const TableRow& row : rows_of_proven("quantities")) {
    for (const std::string& name : names_in(row[0])) {
      CAPTURE(name);
      const bool is_estimated =
          families.contains(name.substr(0, name.find('.'))) || contains(others, " " + name + " ");
      CHECK(is_estimated == (row[1] == "estimated"));
    }
  }
}

TEST_CASE("both paths agree within the promise at random points, and what is proven is as the pages say") {
  std::map<std::string, std::string> state_of;
  for (const TableRow& row : rows_of_proven("quantities")) {
    for (const std::string& name : names_in(row[0])) state_of[name] = row[1];
  }
  constexpr int digits = 18;  // 1e-18 is a hundredth of an ulp
  for (const Quantity& quantity : verify::catalogue()) {
    verify::Random random("test " + quantity.drawn_for());
    // Fewer points if the reference is slow.
    const std::size_t most = (quantity.is_costly ? 12U : 45U) / (is_thorough() ? 1U : 12U);
    const std::size_t points = std::min(most, quantity.audit_points / 3);
    for (const Point& point : verify::random_points(quantity, {}, points, random)) {
      CAPTURE(quantity.name, point.front());
      const double value = quantity.by_fast(point, {});
      const ref::Estimate truth = verify::ref_value(quantity, point, digits);
      CHECK(verify::deviation(value, truth, quantity.envelope(point)).ulps <= quantity.promise);
      if (quantity.fast_error) {
        // Whether the truth is proven depends on the point here. The tests of the entry check it.
        CHECK(std::fabs(truth.error_of(value)) <= quantity.fast_error(point, {}));
      } else {
        CHECK((truth.proven ? "proven" : "estimated") == state_of[quantity.name]);
      }
    }
  }
}

TEST_CASE("loop and batch give the scalar's values") {
  for (const Quantity& quantity : verify::catalogue()) {
    CAPTURE(quantity.name);
    verify::Random random("columns " + quantity.drawn_for());
    const std::vector<Point> points = verify::random_points(
        quantity, {}, (quantity.is_costly ? 10U : 150U) * (is_thorough() ? 4 : 1), random);
    std::vector<std::vector<double>> columns(quantity.arguments.size());
    for (const Point& point : points) {
      for (std::size_t i = 0; i < point.size(); ++i) columns[i].push_back(point[i]);
    }
    const std::vector<std::span<const double>> spans(columns.begin(), columns.end());
    std::vector<double> looped(points.size());
    quantity.by_fast_loop(spans, looped, {});
    std::vector<double> batched = looped;
    if (quantity.by_fast_batch) quantity.by_fast_batch(spans, batched, {});
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double scalar = quantity.by_fast(points[i], {});
      const double scale = std::max(std::fabs(scalar), quantity.envelope(points[i]));
      CHECK(looped[i] == scalar);
      CHECK(std::fabs(batched[i] - scalar) <= 0x1p-51 * scale + 0x1p-1074);
    }
  }
}

TEST_CASE("samples stay in the domains") {
  for (const Quantity& quantity : verify::catalogue()) {
    CAPTURE(quantity.name);
    verify::Random random("domain " + quantity.drawn_for());
    const std::size_t count = (quantity.is_costly ? 20U : 500U) / (is_thorough() ? 1U : 4U);
    std::vector<Point> points = verify::random_points(quantity, {}, count, random);
    for (const Point& start : verify::dense_points(quantity, {}, count, random)) {
      points.push_back(start);
      points.push_back(verify::perturbed(quantity, {}, start, random));
    }
    for (const Point& point : points) {
      REQUIRE(point.size() == quantity.arguments.size());
      CHECK_FALSE(std::isnan(verify::fast_value(quantity, point, {})));
      CHECK_FALSE(std::isnan(quantity.envelope(point)));
    }
  }
}

TEST_CASE("the zeros of I1 are where neighbouring doubles have values of different sign") {
  const Quantity& quantity = verify::find_quantity("I1");
  verify::Random random("zeros");
  const std::vector<Point> points = verify::zero_points(quantity, {}, 100'000, random);
  // Half a period of the first residue term is pi/1.1254 = 2.79; the first zero lies beyond 1.
  const auto within_middle = [](const Point& point) { return point[0] < 50; };
  CHECK(std::ranges::count_if(points, within_middle) / 7 == 18);
  for (std::size_t first = 0; first + 6 < points.size(); first += 7) {
    const double before = quantity.by_fast(points[first], {});
    const double after = quantity.by_fast(points[first + 6], {});
    CHECK(std::signbit(before) != std::signbit(after));
  }
}

TEST_CASE("random numbers are reproducible and of the range asked for") {
  verify::Random first("seed");
  verify::Random second("seed");
  verify::Random other("another seed");
  int equal = 0;
  for (int i = 0; i < 1000; ++i) {
    const double value = first.log_uniform(1e-3, 10);
    CHECK(value == second.log_uniform(1e-3, 10));
    equal += value == other.log_uniform(1e-3, 10) ? 1 : 0;
    CHECK(value >= 1e-3 * (1 - 1e-15));
    CHECK(value <= 10 * (1 + 1e-15));
    CHECK(other.index(7) < 7);
  }
  CHECK(equal < 5);
}

TEST_CASE("arguments are matched and found by name, and what fits no double is for ref only") {
  const Quantity& vs = verify::find_quantity("vs");
  const auto parsed = verify::parse_arguments(vs, {{"poisson", "0.25"}, {"eta", "0x1p-1"}, {"alpha", "0.1"}});
  CHECK(parsed.text == std::vector<std::string>{"0.1", "0x1p-1", "1", "0.25"});
  const Point numbers = parsed.nearest(vs);
  CHECK(numbers == Point{0.1, 0.5, 1, 0.25});
  const verify::NamedPoint point(vs.arguments, numbers);
  CHECK(point["eta"] == 0.5);
  CHECK_THROWS_AS(point["poison"], std::logic_error);
  const Quantity& I3 = verify::find_quantity("I3");
  for (const char* text : {"1e400", "-1e400", "1e-400"})
    CHECK_THROWS_AS(verify::parse_arguments(I3, {{"alpha", text}}).nearest(I3), data::BadInput);
}
