#include <nipref/verify/grade/baseline.hpp>

#include "support/scratch.hpp"

using namespace nipref::verify;
using nipref::data::BadInput;

namespace {

const BaselineKey baseline_key{"mine.csv", "I1", "its domain", "", 1000, 1, "GNU 12.2.0", "v3"};

Baseline with_entry(double error) { return {{{baseline_key, error, ""}}}; }

}  // namespace

TEST_CASE("an error may be half more than it was and a quarter ulp, and no more") {
  const Baseline baseline = with_entry(2);
  CHECK(compare_with(baseline, baseline_key, 3.25).verdict == "not worse");
  CHECK(compare_with(baseline, baseline_key, 3.2501).verdict == "WORSE");
  CHECK(compare_with(baseline, baseline_key, 0).verdict == "not worse");
}

TEST_CASE("another key is not comparable, and says in what it is another") {
  const auto words = [](auto change) {
    BaselineKey other = baseline_key;
    change(other);
    const BaselineComparison compared = compare_with(with_entry(2), other, 1);
    CHECK(compared.verdict == "not comparable");
    return compared.words;
  };
  CHECK(words([](BaselineKey& other) { other.quantity = "I2"; }) ==
        "mine.csv as I2, its domain, is not in the baseline");
  CHECK(words([](BaselineKey& other) { other.compiler = "GNU 14"; }).starts_with("compiler was"));
  CHECK(words([](BaselineKey& other) { other.points = 7; }).starts_with("points was"));
  CHECK(words([](BaselineKey& other) { other.instruction_set = "v4"; }).starts_with("instruction set was"));
  CHECK(words([](BaselineKey& other) { other.seed = "2"; }).starts_with("seed was"));
  CHECK(words([](BaselineKey& other) { other.sampler = 2; }).starts_with("sampler was"));
}

TEST_CASE("lowering is free, raising needs a reason, which is kept") {
  Baseline baseline;
  CHECK(update(baseline, baseline_key, 2, std::nullopt));
  CHECK(update(baseline, baseline_key, 1, std::nullopt));
  CHECK(baseline.entries.at(0).max_error_ulp == 1);
  CHECK_FALSE(update(baseline, baseline_key, 5, std::nullopt));
  CHECK(baseline.entries.at(0).max_error_ulp == 1);
  CHECK(update(baseline, baseline_key, 1.5, std::nullopt));  // not worse: nothing is raised
  CHECK(baseline.entries.at(0).max_error_ulp == 1);
  CHECK(update(baseline, baseline_key, 5, "a faster series"));
  CHECK(baseline.entries.at(0).max_error_ulp == 5);
  CHECK(baseline.entries.at(0).reason == "a faster series");
  CHECK(baseline.entries.size() == 1);
}

TEST_CASE("a baseline is read back as it was written") {
  Baseline baseline = with_entry(0.1);
  BaselineKey odd = baseline_key;
  odd.what = "it's \"mine\"\n";
  REQUIRE(update(baseline, odd, 1e300, "why = not"));
  const ScratchFile file(baseline.text());
  const Baseline back = Baseline::read(file.path());
  REQUIRE(back.entries.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(back.entries[i].key == baseline.entries[i].key);
    CHECK(back.entries[i].max_error_ulp == baseline.entries[i].max_error_ulp);
    CHECK(back.entries[i].reason == baseline.entries[i].reason);
  }
  CHECK_THROWS_AS(static_cast<void>(Baseline::read(file.path() + ".missing")), BadInput);
}

TEST_CASE("what is no baseline is refused by file and line") {
  const auto refused = [](const std::string& toml) {
    const ScratchFile file(toml);
    CHECK_THROWS_AS(static_cast<void>(Baseline::read(file.path())), BadInput);
  };
  refused("graded = 3\n");
  refused("[[other]]\n");
  refused("[[graded]]\nwhat = \"x\"\n");
  refused("not toml");
  refused("[[graded]]\n\xc3\xa9 = 1\n");  // a text that toml++ must not receive
  refused("[[graded]]\na.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p.q = 1\n");
  CHECK_REFUSED(Baseline::read("/"), "baseline = /: must be a file");
  std::string negative = with_entry(1.5).text();
  negative.replace(negative.find("1.5"), 3, "-1.");
  refused(negative + "\n");
}
