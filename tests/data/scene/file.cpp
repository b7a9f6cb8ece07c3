#include <nipref/data/scene/file.hpp>

#include "support/scratch.hpp"
#include "support/table_rows.hpp"

using namespace nipref;

namespace {

const std::string good = R"(title = "a nip"
wanted = ["contact_length", "pressure"]
accuracy = 1e-8
[roller]
radius = 6
[sheet]
thickness = 1.0
[material]
model = "elastic"
young = 1.45e5
poisson = 0.3
[load]
per_length = 100.0
[friction]
model = "full"
creep_ratio = 1e-3
[method]
kind = "line-loads"
leading_elements = 3
trailing_elements = 3
[profile]
points = 4
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t position = text.find(from);
  REQUIRE(position != std::string::npos);
  return text.replace(position, from.size(), to);
}

/// The refusal of a scene with these overrides, or its title if it is accepted.
std::string said_of(const std::string& text, const data::SceneOverrides& overrides = {}) {
  std::string title;
  const std::string refusal = refusal_of([&] { title = data::load_scene({"FILE", text}, overrides).title; });
  return refusal == "accepted" ? title : refusal;
}

const data::ElasticNipProblem& elastic(const data::Scene& scene) {
  return std::get<data::ElasticNipProblem>(scene.system);
}

}  // namespace

TEST_CASE("a scene is read as it stands") {
  const data::Scene scene = data::load_scene(ScratchFile(good).path());
  CHECK(scene.title == "a nip");
  CHECK(scene.wanted ==
        std::vector<data::ResultId>{data::ResultId::contact_length, data::ResultId::pressure});
  CHECK(scene.accuracy == 1e-8);
  const data::ElasticNipProblem& problem = elastic(scene);
  CHECK(problem.nip.roller_radius == 6);
  CHECK(problem.nip.sheet_thickness == 1);
  CHECK(problem.nip.material.young == 1.45e5);
  CHECK(problem.nip.material.poisson == 0.3);
  CHECK(std::get<data::GivenLoad>(problem.given).per_length == 100);
  CHECK(problem.friction == data::Friction::full);
  CHECK(problem.creep_ratio == 1e-3);
  CHECK(std::get<data::LineLoads>(problem.method).trailing_elements == 3);
  CHECK(std::get<data::LineLoads>(problem.method).residue_terms == 0);
  CHECK(std::get<data::EvenlySpaced>(*problem.profile).points == 4);
}

TEST_CASE("a scene is read without the keys and tables that may be left out") {
  std::string text = replaced(good, "accuracy = 1e-8\n", "");
  text = replaced(text, "creep_ratio = 1e-3\n", "");
  text = replaced(text, ", \"pressure\"", "");
  text = replaced(text, "[profile]\npoints = 4\n", "");
  CHECK(said_of(text) == "a nip");
  text = replaced(text, "[load]\nper_length = 100.0", "[contact]\nlength = 0.5");
  CHECK(said_of(text) == "a nip");
}

TEST_CASE("every refusal has file, line, key, value and what is allowed") {
  const auto rows = table_rows("data/scene/refusals.txt");
  CHECK(rows.size() > 60);
  for (const auto& row : rows) {
    const std::string message = said_of(replaced(good, row.at(0), row.at(1))), where = "FILE" + row.at(2);
    CAPTURE(row[1], message);
    CHECK(message.starts_with(where));
    CHECK(message.find(row.at(3), where.size()) != std::string::npos);
  }
}

TEST_CASE("overrides stand for what the file has, or add to it, and the title says so") {
  const ScratchFile file(good);
  const data::Scene scene = data::load_scene(file.path(), {{"load.per_length", "2e2"},
                                                           {"accuracy", "1e-6"},
                                                           {"wanted", "[\"load\", \"pressure\"]"},
                                                           {"profile.points", "5"},
                                                           {"friction.model", "full"},
                                                           {"material.model", "\"elastic\""}});
  CHECK(std::get<data::GivenLoad>(elastic(scene).given).per_length == 200);
  CHECK(elastic(scene).friction == data::Friction::full);
  CHECK(scene.accuracy == 1e-6);
  CHECK(scene.wanted == std::vector<data::ResultId>{data::ResultId::load, data::ResultId::pressure});
  CHECK(
      scene.title ==
      "a nip, with load.per_length = 2e2, with accuracy = 1e-6, with wanted = [\"load\", \"pressure\"], with "
      "profile.points = 5, with friction.model = full, with material.model = \"elastic\"");
  const data::Scene added = data::load_scene(file.path(), {{"method.residue_terms", "7"}, {"title", "mine"}});
  CHECK(std::get<data::LineLoads>(elastic(added).method).residue_terms == 7);
  CHECK(added.title == "mine, with method.residue_terms = 7");
}

TEST_CASE("bad overrides are refused as they were given, and what is wrong in the file at its line") {
  CHECK(said_of(good, {{"load.per_length", "-5e0"}}) == "load.per_length = -5e0: must be finite and > 0");
  CHECK(said_of(good, {{"load.per_length", "much"}}) == "load.per_length = much: must be a number");
  CHECK(said_of(good, {{"load.per_length", "1\nx=2"}}) == "load.per_length = 1 x=2: must be a number");
  CHECK(said_of(good, {{"method.leading_elements", "3.5"}}) ==
        "method.leading_elements = 3.5: must be a whole number");
  CHECK(said_of(good, {{"load.per_lenght", "0x10"}})
            .starts_with("load.per_lenght = 0x10: unknown key: did you mean per_length?"));
  CHECK(said_of(good, {{"lod.per_length", "5"}})
            .starts_with("FILE: lod = (a table): unknown key: did you mean load?"));
  CHECK(said_of(good, {{"wanted", "[\"load\", \"laod\"]"}})
            .starts_with("wanted[1] = laod: did you mean load?"));
  for (const char* key : {"load", "", "load.", "load.x.y.", "profile"})
    CHECK(said_of(good, {{key, "5"}}).starts_with(std::string(key) + " = 5: "));
  CHECK(said_of(good, {{"load", "{per_length = 5}"}})
            .starts_with("load = {per_length = 5}: must be TABLE.KEY=VALUE"));
  CHECK(said_of(good, {{"title.x", "5"}}) ==
        "title.x = 5: must be TABLE.KEY or KEY of the scene: 'title' is no table");
  CHECK(said_of(good, {{".x", "5"}}).starts_with(".x = 5: must be TABLE.KEY"));
  CHECK(said_of(good, {{"accuracy", "1e-6"}, {"accuracy", "1e-7"}}) ==
        "accuracy = 1e-7: given twice: must be given once");
  CHECK(said_of(replaced(good, "radius = 6", "radius = 0"), {{"accuracy", "1e-6"}})
            .starts_with("FILE:5: roller.radius = 0: "));
}

TEST_CASE("a scene of more than a mebibyte is refused unread, and one nested without end") {
  const ScratchFile large(good + std::string(1 << 20, '\n'));
  CHECK_REFUSED(data::load_scene(large.path()), "must be a file of at most 1048576 bytes");
  CHECK_REFUSED(data::parse_scene(good + "x = " + std::string(100'000, '['), "deep"), "deep");
}

TEST_CASE("a key of parts without end is refused wherever it stands, other dots are not counted") {
  std::string parts = "a";
  for (int i = 0; i < 100'000; ++i) parts += ".a";
  for (const std::string& text : {parts + " = 1\n", "[" + parts + "]\n", "x = [{" + parts + " = 1}]\n"}) {
    for (const std::string before : {"", "y = \"\\\"#\" # '", "y = \"\"\"\"=\"\"\"", "y = ''"})
      CHECK(said_of(before + "\n" + text + good).ends_with("must have keys of at most 16 parts"));
  }
  CHECK(said_of("\n" + parts + " = 1\n").starts_with("FILE:2: syntax = a.a."));
  CHECK(said_of(good, {{parts, "1"}}).ends_with("must be a key of at most 16 parts"));
  CHECK(said_of(good, {{"accuracy", "{" + parts + " = 1}"}}).ends_with("must be a number"));
  const std::string dots(100, '.');
  CHECK(said_of(replaced(good, "a nip", dots + "\\\"" + dots) + "# " + dots) == dots + "\"" + dots);
}

TEST_CASE("letters beyond ASCII are accepted in texts and comments alone") {
  CHECK(said_of(replaced(good, "radius = 6", "r\u00e1dius = 6"))
            .starts_with("FILE:5: syntax = r\u00e1dius = 6: must be TOML"));
  CHECK(said_of("\xef\xbb\xbf# \u00e1\n" + replaced(good, "a nip", "\u00e1")) == "\u00e1");
  // Texts in which toml++ would read on through quotes, or take a letter for a space.
  for (const char* const radius :
       {"6'\u00e1'", "6b='\u00e1'", "6.'\u00e1'", "6['\u00e1'", " \"\"\"\\\u00e1\"\"\"", " \"\\\\ \u00e1\""})
    CHECK(contains(said_of(replaced(good, "radius = 6", std::string("radius = ") + radius)),
                   "must be TOML: letters beyond ASCII in quotes behind a space, with no backslash"));
}

TEST_CASE("a scene made in C++ is refused by its keys, with no file, one of a text by the text's name") {
  CHECK_REFUSED(data::parse_scene("title = ", "a text"), "a text:1: syntax");
  data::Scene scene = data::parse_scene(good, "a text");
  scene.origin = {};
  auto& problem = std::get<data::ElasticNipProblem>(scene.system);
  problem.nip.sheet_thickness = 0;
  CHECK_THROWS_WITH_AS(scene.check(), "sheet.thickness = 0: must be finite and > 0", data::BadInput);
  problem.nip.sheet_thickness = 1;
  CHECK_NOTHROW(scene.check());
  problem.friction = data::Friction::none;
  CHECK_REFUSED(scene.check(), "friction.creep_ratio = 0.001");
}
