#include <nipref/data/directory.hpp>
#include <nipref/data/scene/file.hpp>
#include <nipref/data/scene/keys.hpp>

#include "support/paths.hpp"
#include "support/test.hpp"

using namespace nipref;

namespace {

/// Adds the keys of an example. Headers of tables stand in lines of their own, and keys begin lines.
void add_keys_of(const std::filesystem::path& file, std::set<std::string>& keys) {
  std::istringstream lines(text_of_file(file));
  std::string line, table;
  while (std::getline(lines, line)) {
    if (line.starts_with('[')) {
      table = line.substr(1, line.find(']') - 1) + ".";
    } else if (const std::size_t equals = line.find(" = "); equals != std::string::npos && line[0] != '#') {
      const std::string key = line.substr(0, equals);
      if (key.find_first_of(" \"[") == std::string::npos) keys.insert(table + key);
    }
  }
}

/// Whether the reader of this scene reads the key, and refuses the value because of its type.
bool is_read(const data::SceneText& scene, const std::string& key) {
  try {
    (void)data::load_scene(scene, {{key, "[true]"}});
  } catch (const data::BadInput& error) {
    return error.argument().starts_with(key) && !contains(std::string(error.what()), "unknown key");
  }
  return false;
}

}  // namespace

TEST_CASE("every key of the scenes that come with the library is in the table of keys") {
  std::set<std::string> keys;
  for (const auto& entry : std::filesystem::directory_iterator(data::scenes_directory())) {
    if (entry.path().extension() == ".toml") add_keys_of(entry.path(), keys);
  }
  CHECK(keys.contains("material.theta1_rates"));
  for (const std::string& key : keys) {
    CAPTURE(key);
    CHECK(data::find_scene_key(key) != nullptr);
  }
}

TEST_CASE("no key is twice in the table of keys") {
  std::set<std::string_view> names;
  for (const data::SceneKey& key : data::scene_keys()) {
    CAPTURE(key.name);
    CHECK(names.insert(key.name).second);
    CHECK(data::find_scene_key(key.name) == &key);
  }
}

TEST_CASE("the reader of scenes reads every key of the table of keys") {
  std::vector<data::SceneText> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(data::scenes_directory())) {
    if (entry.path().extension() == ".toml") scenes.push_back(data::read_scene(entry.path()));
  }
  for (const data::SceneKey& key : data::scene_keys()) {
    CAPTURE(key.name);
    CHECK(std::ranges::any_of(scenes,
                              [&](const auto& scene) { return is_read(scene, std::string(key.name)); }));
  }
}

TEST_CASE("README.md of the scenes lists the keys of the table of keys") {
  std::map<std::string, std::string> rows;
  for (const data::SceneKey& key : data::scene_keys()) {
    std::string& row =
        rows[key.table().empty() ? "(above all tables)" : "`[" + std::string(key.table()) + "]`"];
    row += (row.empty() ? "`" : ", `") + std::string(key.last()) + "`";
  }
  const std::string readme = text_of_file(data::scenes_directory() / "README.md");
  for (const auto& [table, names] : rows) CHECK(contains(readme, "\n| " + table + " | " + names + " |\n"));
}

TEST_CASE("enumerators of results and scales are those of their rows") {
  CHECK(data::scene_results().front().id == data::ResultId::contact_length);
  CHECK(data::scene_result(data::ResultId::coupling).name == "coupling");
  CHECK(data::text(data::Scale::half_contact_times_load) == "L/2 times the load");
}
