#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/golden/golden.hpp>

#include "support/scratch.hpp"

using namespace nipref;

namespace {

const std::string head =
    "# quantity: ti.branch\n# digits: 30\n"
    "theta_deg,which,solid,value,bound,scale,status,confirmed_by,origin\n";
const std::string row =
    "-0x1.8p+4,minus,\"transversely-isotropic(c11=0x1p+3, c33=0x1p+4, c13=0x0p+0, c44=0x1p+1, c66=0x1p+1, "
    "density=0x1p+10)\"";

std::string refusal(const std::string& text) {
  const ScratchFile file(text);
  return refusal_of([&] { return verify::read_golden(file.path()); });
}

}  // namespace

TEST_CASE("golden values are read as they are written") {
  const std::string text = head + row +
                           ",1.25e-3,1e-40,0.00125,proven,closed form to 2.0e-41,worst:fast@abc\n" + row +
                           ",0,0,0,estimated,closed form to 0,user\n";
  const ScratchFile file(text);
  const verify::GoldenFile golden = verify::read_golden(file.path());
  CHECK(golden.digits() == 30);
  REQUIRE(golden.rows.size() == 2);
  CHECK(golden.rows[0].arguments == verify::Point{-24, 2, 8, 16, 0, 2, 2, 1024});
  CHECK(golden.rows[0].number().to_double() == 1.25e-3);
  CHECK(mpfr_cmp_d(nipref::ref::raw(golden.rows[0].number().error), 1e-40) >= 0);
  CHECK(golden.rows[0].proven);
  CHECK_FALSE(golden.rows[1].proven);
  CHECK(verify::golden_text(golden) == text);
}

TEST_CASE("a golden file older than an argument has that argument's default") {
  const ScratchFile file(
      "# quantity: un\n# digits: 30\nalpha,poisson,value,bound,scale,status,confirmed_by,origin\n"
      "0x1p-1,0x1p-2,1,1e-9,1,proven,closed form,dense\n");
  CHECK(verify::read_golden(file.path()).rows[0].arguments == verify::Point{0.5, 1, 0.25});
  CHECK(contains(
      refusal("# quantity: un\n# digits: 30\nalpha,young,value,bound,scale,status,confirmed_by,origin\n"),
      ":3:13: must be the column poisson"));
}

TEST_CASE("a golden file that is none is refused with line and column") {
  const std::string good = ",1,1e-9,1,proven,closed form,dense\n";
  CHECK(refusal(head + row + good) == "accepted");
  CHECK(contains(refusal("# quantity: I9\n# digits: 30\nx\n"), "I9"));
  CHECK(contains(refusal("# digits: 30\nx\n"), "quantity = (missing)"));
  CHECK(contains(refusal("# quantity: I1\nalpha\n"), "digits = (missing)"));
  CHECK(contains(refusal("# quantity: I1\n# digits: 30\nalpha,value\n"),
                 ":3:7: must be followed by the column bound"));
  CHECK(contains(refusal("# quantity: I1\n# digits: 30\neta,value\n"), ":3:1: must be the column alpha"));
  CHECK(contains(refusal(head + row + ",one,1e-9,1,proven,c,dense\n"), "must be a finite decimal number"));
  CHECK(contains(refusal(head + row + ",nan,1e-9,1,proven,c,dense\n"), "must be a finite decimal number"));
  CHECK(contains(refusal(head + row + ",1,-1e-9,1,proven,c,dense\n"), "must not be negative"));
  CHECK(contains(refusal(head + row + ",1,1e-9,-1,proven,c,dense\n"), "must not be negative"));
  CHECK(contains(refusal(head + row + ",1,1e-9,1,certain,c,dense\n"), "must be proven or estimated"));
  std::string unknown = row;
  unknown.replace(unknown.find("minus"), 5, "other");
  CHECK(contains(refusal(head + unknown + good), "must be 56 or plus or minus"));
}

TEST_CASE("all quantities but those of whole nips have 200 golden values or more, each confirmed") {
  std::size_t all = 0;
  std::uintmax_t bytes = 0;
  for (const verify::Quantity& quantity : verify::catalogue()) {
    CAPTURE(quantity.name);
    if (!quantity.family.empty()) continue;
    REQUIRE(std::filesystem::exists(verify::golden_path(quantity.name)));
    bytes += std::filesystem::file_size(verify::golden_path(quantity.name));
    const verify::GoldenFile file = verify::read_golden(verify::golden_path(quantity.name));
    CHECK(file.quantity().name == quantity.name);
    CHECK(file.entry("tree") == "clean");
    CHECK(file.entry("commit").size() == 40);
    for (const char* key : {"unit", "command", "nipref", "compiler", "mpfr", "example"})
      CHECK_FALSE(file.entry(key).empty());
    CHECK(file.rows.size() >= 200);
    all += file.rows.size();
    std::set<std::vector<double>> points;
    std::set<std::string> origins;
    for (const verify::GoldenRow& one : file.rows) {
      points.insert(one.arguments);
      origins.insert(one.origin.substr(0, one.origin.find('@')));
      CHECK(contains(one.confirmed_by, " to "));
    }
    CHECK(points.size() == file.rows.size());
    CHECK(origins.contains("worst:fast"));
    CHECK((origins.contains("hard") || quantity.draw));
  }
  CHECK(all >= 10'000);
  CHECK(bytes < 70'000 * verify::catalogue().size());
}
