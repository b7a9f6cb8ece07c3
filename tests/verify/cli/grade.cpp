#include <fmt/format.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <nipref/data/directory.hpp>
#include <nipref/fast/sheet/kernels.hpp>

#include "support/json_schema.hpp"
#include "support/run_nipref.hpp"
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
  CHECK(run_with_pipe("grade", sound.path(), "I1 --json").status == 0);
  CHECK(run("grade '" + sound.path() + "' --promise 1e-3ulp").status == 1);

  const ScratchFile wrong(with_values(
      points_of_I1(), [](double alpha) { return alpha > 5 && alpha < 6 ? 1.0 : nipref::fast::I1(alpha); }));
  const json region = answer_to("grade '" + wrong.path() + "'", 1)["rows"][0]["wrong"];
  CHECK(std::strtod(region["first"]["alpha"].get<std::string>().c_str(), nullptr) > 5);
  CHECK(std::strtod(region["last"]["alpha"].get<std::string>().c_str(), nullptr) < 6);
}

TEST_CASE("the same call gives the same points, another seed others, and all lie in the ranges") {
  const std::string points = points_of_I1(), other = points_of_I1(" --seed 2");
  CHECK(points_of_I1() == points);
  CHECK(other.substr(other.find("alpha,")) != points.substr(points.find("alpha,")));
  static_cast<void>(with_values(points, [](double alpha) {
    CHECK(alpha >= 1e-3);
    CHECK(alpha <= 20);
    return 0.0;
  }));
}

TEST_CASE("a baseline is made where asked, kept whatever the folder, and not raised without a reason") {
  const ScratchFolder folder;
  const std::string baseline = folder.file("baseline.toml"), junit = folder.file("junit.xml"),
                    against = " --promise 1000 --baseline '" + baseline + "'";
  const auto checked_out = [&](const std::string& name, double factor) {
    std::filesystem::create_directory(folder.file(name));
    folder.write(name + "/mine.csv",
                 with_values(points_of_I1(), [=](double alpha) { return nipref::fast::I1(alpha) * factor; }));
    return "grade '" + folder.file(name + "/mine.csv").string() + "'" + against;
  };
  const std::string one = checked_out("one", 1), worse = checked_out("other", 1 + 0x1p-48);
  check_call_refused(one, "must be a file that exists: --update-baseline makes one");
  folder.write("baseline.toml", "");
  const Outcome not_there = run(one);
  CHECK(not_there.status == 1);
  CHECK(contains(unfolded(not_there.out), "as I1, its points, is not in the baseline"));
  std::filesystem::remove(baseline);
  const json made = answer_to(one + " --update-baseline");
  CHECK(answer_schema().misfit(made, "grade") == "");
  CHECK(run(one).status == 0);
  const Outcome found = run(worse + " --junit '" + junit + "'");
  CHECK(found.status == 1);
  CHECK(contains(found.out, "baseline: WORSE"));
  CHECK(contains(text_of_file(junit), "name=\"mine.csv as I1, its points\""));
  CHECK(run(worse + " --update-baseline").status == 1);
  CHECK(run(worse + " --update-baseline --accept 'shorter'").status == 0);
  CHECK(contains(text_of_file(baseline), "shorter"));
}

TEST_CASE("JUnit tells the outcome of a grade, and what cannot be graded is refused") {
  const ScratchFile wrong(with_values(points_of_I1(), [](double) { return 1.0; })), points(points_of_I1());
  const ScratchFile junit;
  const ScratchFolder folder;
  const std::string name = "b <&\"> .csv";
  folder.write(name, wrong.text());
  CHECK(run("grade '" + folder.file(name).string() + "' --junit '" + junit.path() + "'").status == 1);
  std::istringstream text(junit.text());
  boost::property_tree::ptree root;
  read_xml(text, root);
  const auto& suite = root.get_child("testsuites.testsuite");
  for (const auto& [count, wanted] : {std::pair{"tests", 1}, {"failures", 1}, {"errors", 0}})
    CHECK(suite.get<int>(std::string("<xmlattr>.") + count) == wanted);
  const auto& one = suite.get_child("testcase");
  CHECK(one.get<std::string>("<xmlattr>.name") == name + " as I1, its points");
  CHECK(!contains(one.get<std::string>("<xmlattr>.time"), "e"));
  CHECK(contains(one.get<std::string>("failure.<xmlattr>.message"), "largest error found"));
  CHECK(one.count("error") == 0);
  CHECK(contains(one.get<std::string>("system-out"), "its points: FAIL"));
  CHECK(run("grade '" + wrong.path() + "' --junit /nowhere/at/all").status == 4);
  check_call_refused("grade '" + points.path() + "'", "must have the values in a column");
  for (const auto& [options, says] : {std::pair{" --promise 0", "promise = 0"},
                                      {" --promise 2rel", "promise = 2rel: must be a number > 0"},
                                      {" --accept x", "must be given with --baseline"},
                                      {" I1 alpha=2", "alpha = 2"},
                                      {" I1 --points 100", "points = 100"}})
    check_call_refused("grade '" + wrong.path() + "'" + options, says);
}

TEST_CASE("contacts are graded by their results, each beside its truth: relative, absolute and in ulp") {
  const std::string at = " contact.length=0.5,2 material.poisson=0.3";
  const std::string points = run("points contacts-frictionless" + at).out;
  CHECK(contains(points, "\n# command: nipref points contacts-frictionless contact.length=0.5,2"));
  // L/B of 0.5 and 2, R = 1e6, from the reference; the load of the second is wrong by this factor.
  const json solved =
      answer_to("solve '" + (nipref::data::golden_directory() / "contacts-frictionless.toml").string() + "'" +
                at + " --path ref")["columns"];
  const auto number = [&](const char* name, std::size_t i) {
    return std::stod(solved[name][i].get<std::string>());
  };
  const auto with = [&](double factor, const std::string& name) {
    std::istringstream lines(points);
    std::string text;
    std::size_t contacts = 0;
    for (std::string line; std::getline(lines, line); text += '\n') {
      text += line;
      if (line.starts_with("contact.length,")) text += "," + name + ",indentation";
      if (std::isdigit(line[0]) == 0) continue;
      text += fmt::format(",{:.17g},{:.17g}", number("load", contacts) * (contacts == 1 ? factor : 1),
                          number("indentation", contacts));
      ++contacts;
    }
    CHECK(contacts == 2);
    return text;
  };
  const ScratchFile wrong(with(1.00001, "load")), right(with(1, "load")), misnamed(with(1, "laod"));
  const json rows = json::parse(run("grade '" + wrong.path() + "' --promise 1e-6 --json").out)["rows"];
  REQUIRE(rows.size() == 2);
  CHECK(rows[0]["quantity"] == "contacts-frictionless.load");
  CHECK(rows[0]["passed"] == false);
  CHECK(rows[0]["promise"] == "1e-06 of the scale");
  CHECK(rows[0]["max_relative_error"].get<double>() == doctest::Approx(1e-5));
  CHECK(std::abs(rows[0]["own"]["agreeing_digits"].get<int>() - 5) <= 1);
  CHECK(rows[1]["passed"] == true);
  const std::string text = unfolded(run("grade '" + wrong.path() + "' --promise 1e-6").out);
  // The load is 1.99 of a power of two, 2^-52 of which is its ulp.
  CHECK(contains(text, "of the result itself, at most 2e-05 of it, among"));
  CHECK(contains(text, "digits agree"));
  const double off = 1e-5 * number("load", 1);
  for (const auto& [file, promise, status] : {std::tuple{&wrong, fmt::format("{}abs", 1.01 * off), 0},
                                              {&wrong, fmt::format("{}abs", 0.99 * off), 1},
                                              {&wrong, std::string("1.1e-5"), 0},
                                              {&right, std::string("1ulp"), 0}})
    CHECK(run("grade '" + file->path() + "' --promise " + promise).status == status);
  check_call_refused("grade '" + misnamed.path() + "'", "laod must be one of load, indentation");
}
