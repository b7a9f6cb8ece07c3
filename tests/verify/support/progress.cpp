#include <nipref/verify/support/internal/progress.hpp>

#include "support/test.hpp"

using nipref::verify::Progress;

namespace {

/// Records what is written. The clock stands still until it is set.
struct Told {
  double now = 1000;
  std::size_t columns = 0;
  std::vector<std::string> texts;

  nipref::verify::ProgressOutput output() {
    return {[this](const std::string& text) { texts.push_back(text); }, [this] { return now; },
            [this] { return columns; }};
  }
};

}  // namespace

TEST_CASE("without a terminal progress is a line every 15 s: what is done, time so far, what is left") {
  Told told;
  {
    Progress progress(told.output());
    progress.begin("audit", 4);
    progress.next("I1");
    told.now += 14;
    progress.next("I2");
    CHECK(told.texts.empty());
    told.now += 6;
    progress.at(0.5);
    told.now += 14;
    progress.at(0.9);
  }
  REQUIRE(told.texts.size() == 1);
  // 1.5 of 4 items took 20 s: the other 2.5 take 33.
  CHECK(told.texts[0] == "nipref: audit: 1 of 4 done, now I2, 20 s, about 33 s left\n");
  // With several parts the time counts from the start of the run.
  Told of_parts;
  Progress progress(of_parts.output());
  for (const auto& [part, items] : {std::pair<const char*, std::size_t>{"bench", 1}, {"audit", 2}}) {
    progress.begin(part, items);
    progress.next("I1");
    of_parts.now += 10;
    progress.at(0.5, "points");
  }
  REQUIRE(of_parts.texts.size() == 1);
  CHECK(of_parts.texts[0] == "nipref: audit: 0 of 2 done, now I1 points, 20 s, about 30 s left\n");
}

TEST_CASE("lines that stay take the place of a bar, and are silent where progress is") {
  Told told;
  told.columns = 80;
  {
    Progress progress(told.output());
    progress.begin("audit", 4);
    progress.next("I1");
    progress.tell("errata: all\n");
    progress.tell("limits: all\n");
    CHECK(told.texts.back() == "limits: all\n");
  }
  REQUIRE(told.texts.size() == 3);  // nothing is erased in the end
  CHECK(told.texts[1] == "\r\x1b[Kerrata: all\n");
  Progress silent({});
  silent.tell("nothing\n");
  CHECK_FALSE(nipref::verify::standard_error(true).write);
  CHECK(nipref::verify::standard_error(false).write);
}

TEST_CASE("on a terminal progress is a bar that is never wider than the window, and is wiped in the end") {
  const std::string wipe = "\r\x1b[K";
  for (const std::size_t columns : {1U, 5U, 20U, 40U, 60U, 80U, 200U}) {
    CAPTURE(columns);
    Told told;
    told.columns = columns;
    {
      Progress progress(told.output());
      progress.begin("audit", 4);
      progress.next("I1");
      progress.next("I2");
      told.texts.clear();
      told.now += 10;
      progress.next("I3");
      told.now += 0.05;
      progress.at(0.1);  // too soon after the last bar
    }
    REQUIRE(told.texts.size() == 2);
    CHECK(told.texts[0].starts_with(wipe));
    CHECK(told.texts[0].size() - wipe.size() < columns);
    CHECK(told.texts[0].find('\n') == std::string::npos);
    if (columns == 60)
      CHECK(told.texts[0] == wipe + "audit 2/4 [##########...........] I3, 10 s, about 10 s left");
    CHECK(told.texts[1] == wipe);
  }
}
