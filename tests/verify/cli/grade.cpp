#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include <nipref/fast/sheet/kernels.hpp>

#include "support/run_nipref.hpp"
#include "support/scratch_file.hpp"
#include "support/scratch_folder.hpp"
#include "support/test.hpp"
#include "support/unfolded.hpp"

using nlohmann::json;

namespace {

/// The points of the call, with a column of what `kernel` makes of each.
template <class Kernel>
std::string with_values(const std::string& points, Kernel kernel) {
  std::istringstream lines(points);
  std::string text, line;
  while (std::getline(lines, line)) {
    if (line.starts_with("#")) {
      text += line + "\n";
    } else if (line.starts_with("alpha")) {
      text += line + ",mine\n";
    } else {
      char value[64];
      std::snprintf(value, sizeof value, "%.17g", kernel(std::strtod(line.c_str(), nullptr)));
      text += line + "," + value + "\n";
    }
  }
  return text;
}

std::string points_of_I1(const std::string& more = "") {
  const Outcome outcome = run("points I1 alpha=1e-3..20:log --points 300" + more);
  REQUIRE(outcome.status == 0);
  return outcome.out;
}

}  // namespace

TEST_CASE("values of the points that nipref gave out are graded, from a file and from a pipe") {
  const ScratchFile sound(with_values(points_of_I1(), [](double alpha) { return nipref::fast::I1(alpha); }));
  const Outcome kept = run("grade '" + sound.path() + "' --json");
  CAPTURE(kept.err);
  CHECK(kept.status == 0);
  const json row = json::parse(kept.out)["rows"][0];
  CHECK(row["points"] == 300);
  CHECK(row["passed"] == true);
  CHECK(row["remarks"].empty());
  CHECK(row["max_error_ulp"].get<double>() > 0);
  CHECK(run("grade - I1 --json < '" + sound.path() + "'").status == 0);
  // What is read of a pipe to know what it is would be missing, or waited for.
  const std::string pipe = sound.path() + ".pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  CHECK(run("grade '" + pipe + "' I1 --json & graded=$!; cat '" + sound.path() + "' >'" + pipe +
            "'; (sleep 30; kill $graded) >/dev/null 2>&1 & wait $graded")
            .status == 0);
  std::filesystem::remove(pipe);
  CHECK(run("grade '" + sound.path() + "' --promise 1e-3").status == 1);

  const ScratchFile wrong(with_values(
      points_of_I1(), [](double alpha) { return alpha > 5 && alpha < 6 ? 1.0 : nipref::fast::I1(alpha); }));
  const json region = answer_to("grade '" + wrong.path() + "'", 1)["rows"][0]["wrong"];
  CHECK(std::strtod(region["first"]["alpha"].get<std::string>().c_str(), nullptr) > 5);
  CHECK(std::strtod(region["last"]["alpha"].get<std::string>().c_str(), nullptr) < 6);
}

TEST_CASE("the same call gives the same points, another seed others, and all lie in the ranges") {
  CHECK(points_of_I1() == points_of_I1());
  const std::string other = points_of_I1(" --seed 2");
  CHECK(other.substr(other.find("alpha,")) != points_of_I1().substr(points_of_I1().find("alpha,")));
  static_cast<void>(with_values(points_of_I1(), [](double alpha) {
    CHECK(alpha >= 1e-3);
    CHECK(alpha <= 20);
    return 0.0;
  }));
}

TEST_CASE("a baseline is made, kept, and not raised without a reason") {
  const ScratchFile sound(with_values(points_of_I1(), [](double alpha) { return nipref::fast::I1(alpha); }));
  const ScratchFile baseline("");
  const std::string against = " --baseline '" + baseline.path() + "'";
  const Outcome not_there = run("grade '" + sound.path() + "'" + against);
  CHECK(not_there.status == 1);
  CHECK(contains(unfolded(not_there.out), "as I1, its points, is not in the baseline"));
  CHECK(run("grade '" + sound.path() + "'" + against + " --update-baseline").status == 0);
  CHECK(run("grade '" + sound.path() + "'" + against).status == 0);
  // The same file with values that are worse, within a promise that is wide.
  std::ofstream(sound.path()) << with_values(
      points_of_I1(), [](double alpha) { return nipref::fast::I1(alpha) * (1 + 0x1p-48); });
  const std::string wide = " --promise 1000";
  const Outcome worse = run("grade '" + sound.path() + "'" + against + wide);
  CHECK(worse.status == 1);
  CHECK(contains(worse.out, "baseline: WORSE"));
  CHECK(run("grade '" + sound.path() + "'" + against + wide + " --update-baseline").status == 1);
  CHECK(
      run("grade '" + sound.path() + "'" + against + wide + " --update-baseline --accept 'shorter'").status ==
      0);
  CHECK(contains(baseline.text(), "shorter"));
}

TEST_CASE(
    "a baseline knows a file by its name, in whatever folder, and must be there unless it is to be made") {
  const ScratchFolder folder;
  for (const char* const checkout : {"one", "other"})
    std::filesystem::create_directory(folder.path() / checkout);
  const std::string baseline = (folder.path() / "baseline.toml").string(),
                    junit = folder.path() / "junit.xml";
  const std::string one = (folder.path() / "one/mine.csv").string(), other = folder.path() / "other/mine.csv";
  const std::string against = " --promise 1000 --baseline '" + baseline + "'";
  std::ofstream(one) << with_values(points_of_I1(), [](double alpha) { return nipref::fast::I1(alpha); });
  std::ofstream(other) << with_values(points_of_I1(),
                                      [](double alpha) { return nipref::fast::I1(alpha) * (1 + 0x1p-48); });
  check_call_refused("grade '" + one + "'" + against,
                     "must be a file that exists: --update-baseline makes one");
  CHECK_FALSE(std::filesystem::exists(baseline));
  REQUIRE(run("grade '" + one + "'" + against + " --update-baseline").status == 0);
  const Outcome worse = run("grade '" + other + "'" + against + " --junit '" + junit + "'");
  CHECK(worse.status == 1);
  CHECK(contains(worse.out, "baseline: WORSE"));
  std::ostringstream told;
  told << std::ifstream(junit).rdbuf();
  CHECK(told.str().find("name=\"mine.csv as I1, its points\"") != std::string::npos);
}

TEST_CASE("JUnit tells the outcome of a grade") {
  const ScratchFile wrong(with_values(points_of_I1(), [](double) { return 1.0; }));
  const ScratchFile junit;
  CHECK(run("grade '" + wrong.path() + "' --junit '" + junit.path() + "'").status == 1);
  CHECK(contains(junit.text(), "failures=\"1\""));
  CHECK(run("grade '" + wrong.path() + "' --junit /nowhere/at/all").status == 4);
}

TEST_CASE("what cannot be graded is refused") {
  const ScratchFile points(points_of_I1());
  check_call_refused("grade '" + points.path() + "'", "must have the values in a column");
  check_call_refused("grade '" + points.path() + "' --promise 0", "promise = 0");
  check_call_refused("grade '" + points.path() + "' --accept x", "must be given with --baseline");
}
