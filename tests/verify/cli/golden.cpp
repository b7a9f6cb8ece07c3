#include <nipref/data/directory.hpp>

#include "support/json_schema.hpp"
#include "support/run_nipref.hpp"

namespace {

using nlohmann::json;

int status_in(const std::filesystem::path& folder, const std::string& command) {
  return WEXITSTATUS(std::system(("cd '" + folder.string() + "' && " + command).c_str()));
}

/// An answer that fits the schema.
json exported(const std::string& arguments, const std::filesystem::path& to) {
  const json found = answer_to("golden export " + arguments + " -o '" + to.string() + "'");
  CHECK(answer_schema().misfit(found, "golden_export") == "");
  return found;
}

}  // namespace

TEST_CASE("golden: an exported header compiles in a stranger's program, whose I1 it finds right and wrong") {
  const ScratchFolder folder;
  const json told = exported("I1 contacts-frictionless --format cpp", folder.path());
  CHECK(told["version"] == json::parse(run("--version --json").out)["golden"]);
  // I1 is -log|alpha| and a constant but for terms of the order alpha^2 log alpha.
  folder.write("stranger.cpp", R"(
    #include <cmath>
    #include "I1.hpp"
    #include "contacts-frictionless.hpp"
    static_assert(nipref_golden::contacts_frictionless[0].load_bound > 0);
    int main() {
      int rows = 0, wrong = 0;
      for (const auto& row : nipref_golden::I1) {
        if (std::fabs(row.alpha) > 1e-7) continue;
        const double mine = -std::log(std::fabs(row.alpha)) - CONSTANT;
        ++rows, wrong += !(std::fabs(mine - row.value) <= 1e-12 * row.scale);
      }
      return rows < 10 ? 2 : wrong > 0;
    })");
  for (const auto& [constant, status] : {std::pair{"0.3516753926187", 0}, {"0.3516753936187", 1}}) {
    const std::string compiler = "c++ -std=c++17 -Wall -Werror -D CONSTANT=";
    REQUIRE(status_in(folder.path(), compiler + constant + " stranger.cpp -o it") == 0);
    CHECK(status_in(folder.path(), "./it") == status);
  }
  const std::string text = text_of_file(nipref::data::golden_directory() / "I1.csv");
  for (const std::string format : {"csv", "json"}) {
    const std::filesystem::path file = folder.path() / ("I1." + format);
    exported("I1 --format " + format, file);
    if (format == "csv") CHECK(text_of_file(file).ends_with(text));
    if (format == "json") CHECK(json::parse(text_of_file(file))["columns"]["value"]["double"].size() == 250);
  }
}
