#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/audit/internal/stored.hpp>
#include <nipref/verify/audit/internal/work.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>

#include "support/test.hpp"

using namespace nipref::verify;

namespace {

constexpr std::size_t few_in_blocks = 700;

AuditOptions in_small_blocks(const std::string& seed = "1") {
  AuditOptions options{few_in_blocks, {}, {}};
  options.seed = seed;
  options.block = 90;
  return options;
}

/// The findings of a block as another process reads them.
Json sent(BlockWork& work, std::size_t block) { return Json::parse(work.do_block(block, {}).line()); }

/// Does the blocks in this order, as if each had a process of its own.
std::string row_by(const Quantity& quantity, const std::vector<std::size_t>& order) {
  QuantityWork sum(quantity, in_small_blocks());
  for (const std::size_t block : order) {
    QuantityWork own(quantity, in_small_blocks());
    sum.add(block, sent(own, block));
  }
  return audit_row_json(sum.result()).text();
}

}  // namespace

TEST_CASE("blocks share out all items, and differ by one at most") {
  for (const std::size_t items : {0U, 1U, 4096U, 4097U, 20'000U}) {
    const Blocks blocks(items, 4096);
    std::size_t sum = 0;
    for (std::size_t block = 0; block < blocks.count; ++block) {
      CHECK(blocks.first(block) == sum);
      CHECK(blocks.size(block) <= 4096);
      CHECK(blocks.size(block) + 1 >= blocks.size(0));
      sum += blocks.size(block);
    }
    CHECK(sum == items);
  }
  CHECK(Blocks(20'000, 4096).count == 5);
  CHECK(Blocks(0, 4096).count == 1);
  const std::size_t million_millions = 1'000'000'000'000;
  CHECK(Blocks(million_millions, 4096).first(244'140'625) == million_millions);
}

TEST_CASE("the blocks of an audit have each listed point once, and one dense point in each cell") {
  const Quantity& quantity = find_quantity("I3");
  AuditOptions options{20'000, {}, {}};
  options.more_points = {{0.7296875}, {0.8296875}};
  const QuantityWork plan(quantity, options);
  CHECK(plan.blocks() == 5);
  std::multiset<Point> points;
  for (std::size_t block = 0; block < plan.blocks(); ++block) {
    const std::vector<Point> of_block = plan.points(block);
    CHECK(of_block.size() + plan.searched(block) <= plan.size(block) + options.more_points.size());
    CHECK(of_block == plan.points(block));
    points.insert(of_block.begin(), of_block.end());
  }
  for (const double hard : quantity.arguments[0].hard_values) CHECK(points.count({hard}) >= 1);
  for (const Point& own : options.more_points) CHECK(points.count(own) == 1);

  options.ranges = {Range{1, 2}};
  options.search = false;
  std::set<long> cells;
  constexpr std::size_t of_range = 3000;  // number of dense points
  for (const Point& point : audit_points(quantity, options))
    cells.insert(static_cast<long>((point[0] - 1) * of_range));
  CHECK(cells.size() >= of_range);
}

TEST_CASE("whoever does which block in whatever order, an audit finds the same to the last byte") {
  for (const char* const name : {"I3", "I6"}) {
    const Quantity& quantity = find_quantity(name);
    const QuantityWork work(quantity, in_small_blocks());
    REQUIRE(work.blocks() == 8);
    const std::string expected = row_by(quantity, {0, 1, 2, 3, 4, 5, 6, 7});
    CHECK(row_by(quantity, {7, 3, 5, 1, 6, 2, 0, 4}) == expected);
    CHECK(row_by(quantity, {4, 0, 1, 2, 3, 7, 6, 5}) == expected);
    const AuditResult alone = audit(quantity, in_small_blocks());
    CHECK(audit_row_json(alone).text() == expected);
  }
}

TEST_CASE("another seed has other points and other inputs, and a block of its own text") {
  const Quantity& quantity = find_quantity("I3");
  QuantityWork work(quantity, in_small_blocks()), other(quantity, in_small_blocks("2"));
  CHECK(work.inputs() != other.inputs());
  CHECK(sent(work, 3).line() != sent(other, 3).line());
  CHECK(other.seed(17) == "2/I3/block/17");
}

TEST_CASE("what is no finding about the quantity is not read") {
  QuantityWork work(find_quantity("I6"), in_small_blocks());
  QuantityWork of_one_argument(find_quantity("I3"), in_small_blocks());
  CHECK_THROWS_AS(work.add(0, sent(of_one_argument, 0)), JsonMisfit);
  CHECK_THROWS_AS(work.add(0, Json::object()), JsonMisfit);
}

TEST_CASE("hard cases of contacts are told to the last bit") {
  const auto work = hard_cases_work(), other = hard_cases_work();
  work->add(1, sent(*other, 1));
  const std::vector<ContactAudit> cases = work->result();
  REQUIRE(cases.size() == 3);
  CHECK(stored(cases).line() == stored(audit_hard_cases(1)).line());
  CHECK(contact_audit_json(cases).text() == contact_audit_json(audit_hard_cases(1)).text());
}
