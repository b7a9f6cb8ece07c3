#include <nipref/data/closest_name.hpp>
#include <nipref/data/directory.hpp>
#include <nipref/data/input_file.hpp>
#include <nipref/data/internal/common.hpp>
#include <nipref/data/scene/file.hpp>
#include <nipref/data/scene/internal/read.hpp>

namespace nipref::data {
namespace {

constexpr std::size_t longest_scene = std::size_t{1} << 20;  ///< bytes

ElasticNip read_nip(const SceneTable& file) {
  const SceneTable roller = file.table("roller");
  const SceneTable sheet = file.table("sheet");
  const SceneTable material = file.table("material", "elastic-solid");
  return {roller.number("radius"),
          sheet.number("thickness"),
          {material.number("young"), material.number("poisson")}};
}

Given read_given(const SceneTable& file, const SceneOrigin& origin) {
  if (file.has("contact")) {
    const SceneTable contact = file.table("contact");
    if (file.has("load"))
      origin.refuse("contact", "(beside load)", "must be left out, or load: one of the two");
    return GivenLength{contact.number("length")};
  }
  if (!file.has("load")) {
    origin.refuse("load", "(missing)", "must be given, or contact in its place: one of the two");
  }
  return GivenLoad{file.table("load").number("per_length")};
}

/// Whether the method is the converged one, which has no other keys.
bool is_converged(const SceneTable& method) {
  if (method.choice("kind") != "converged") return false;
  method.allow();
  return true;
}

std::variant<ConvergedMethod, LineLoads> read_method(const SceneTable& method) {
  if (is_converged(method)) return ConvergedMethod{};
  method.allow("elastic-line-loads");
  return LineLoads{method.whole("leading_elements"), method.whole("trailing_elements"),
                   method.has("residue_terms") ? method.whole("residue_terms") : 0};
}

Drive read_drive(const SceneTable& traction, const SceneOrigin& origin) {
  if (traction.has("force_per_length") == traction.has("creep_ratio"))
    origin.refuse("traction", "(its keys)", "must have force_per_length or creep_ratio, one of the two");
  if (traction.has("creep_ratio")) return GivenCreep{traction.number("creep_ratio")};
  return GivenTraction{traction.number("force_per_length")};
}

void read_places(auto& problem, const SceneTable& file, const SceneOrigin& origin) {
  if (file.has("profile")) problem.profile = read_profile(file.table("profile"), origin);
  if constexpr (requires { problem.field; })
    if (file.has("field")) problem.field = read_field(file.table("field"));
}

PartialSlipProblem read_partial_slip(const SceneTable& file, const SceneOrigin& origin) {
  const SceneTable friction = file.table("friction", "partial-slip");
  PartialSlipProblem problem{.nip = {read_nip(file), friction.number("coefficient"),
                                     read_drive(file.table("traction", "partial-slip"), origin)},
                             .given = read_given(file, origin)};
  if (file.has("field")) origin.refuse("field", "(its keys)", "must be left out with Coulomb's friction");
  problem.method = read_method(file.any_table("method"));
  read_places(problem, file, origin);
  return problem;
}

ElasticNipProblem read_elastic_nip(const SceneTable& file, const SceneOrigin& origin) {
  ElasticNipProblem problem{.nip = read_nip(file), .given = read_given(file, origin)};
  const SceneTable friction = file.table("friction", "elastic-nip");
  if (friction.choice("model") == "full") problem.friction = Friction::full;
  if (friction.has("creep_ratio")) problem.creep_ratio = friction.number("creep_ratio");
  problem.method = read_method(file.any_table("method"));
  read_places(problem, file, origin);
  return problem;
}

std::variant<ConvergedMethod, ViscoelasticLineLoads> read_viscoelastic_method(const SceneTable& method) {
  if (is_converged(method)) return ConvergedMethod{};
  method.allow("rolling-line-loads");
  ViscoelasticLineLoads loads{.leading_elements = method.whole("leading_elements"),
                              .trailing_elements = {},
                              .approach_lengths = method.number("approach_lengths")};
  if (method.has("trailing_elements")) loads.trailing_elements = method.whole("trailing_elements");
  if (method.has("residue_terms")) loads.residue_terms = method.whole("residue_terms");
  return loads;
}

ViscoelasticNipProblem read_viscoelastic_nip(const SceneTable& file, const SceneOrigin& origin) {
  const SceneTable roller = file.table("roller");
  const SceneTable sheet = file.table("sheet");
  const SceneTable rolling = file.table("rolling");
  ViscoelasticNipProblem problem{
      .nip = {roller.number("radius"), sheet.number("thickness"),
              read_viscoelastic_material(file.any_table("material"), origin), rolling.number("speed")},
      .given = read_given(file, origin)};
  const std::string friction = file.table("friction").choice("model");
  if (friction != "none")
    origin.refuse("friction.model", friction,
                  "must be none: the rolling nip is solved without friction only");
  problem.method = read_viscoelastic_method(file.any_table("method"));
  read_places(problem, file, origin);
  return problem;
}

/// A rolling sheet is solved as a viscoelastic one, also if its material is elastic.
decltype(Scene::system) read_system(const SceneTable& file, const SceneOrigin& origin) {
  file.allow();
  if (file.has("half_space")) return read_half_space_problem(file, origin);
  const bool is_elastic = material_model(file.any_table("material")) == "elastic";
  if (file.has("rolling") || !is_elastic) return read_viscoelastic_nip(file, origin);
  if (file.any_table("friction").choice("model") == "coulomb") return read_partial_slip(file, origin);
  return read_elastic_nip(file, origin);
}

/// Adds the overrides to the title, which describes the file alone.
void add_to_title(Scene& scene, const SceneOverrides& overrides) {
  for (const auto& [key, value] : overrides) {
    if (key != "title") scene.title += ", with " + key + " = " + value;
  }
}

std::string closest_example(const std::string& name, const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code none_there;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none_there)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return did_you_mean(name, {names.begin(), names.end()}, 3);
}

/// Refuses the keys of a sweep that have no override: only with one value for each key the scene is a single contact.
void refuse_what_is_swept(const SceneTable& top, const SceneOrigin& origin, const SceneOverrides& overrides) {
  for (const auto& [key, values] : read_sweep(top, origin).keys) {
    if (std::ranges::find(overrides, key, &SceneOverrides::value_type::first) == overrides.end())
      origin.refuse("sweep." + key, values,
                    "must be solved by nipref solve, or have one value given beside the file");
  }
}

/// Makes the scene of a whole file; `origin` is that of the table.
Scene scene_of(const SceneTable& top, SceneOrigin& origin, const SceneOverrides& overrides) {
  refuse_what_is_swept(top, origin, overrides);
  const std::vector<std::string> wanted = top.texts("wanted");
  Scene scene{.title = top.text("title"), .wanted = {}, .system = read_system(top, origin), .origin = {}};
  scene.wanted = read_wanted(wanted, scene.kind(), origin);
  if (top.has("accuracy")) scene.accuracy = top.number("accuracy");
  add_to_title(scene, overrides);
  scene.origin = std::move(origin);
  scene.check();
  return scene;
}

}  // namespace

SceneText read_scene(const std::filesystem::path& file) {
  std::ifstream stream = open_input_file(file, "scene");
  std::string text(longest_scene + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > longest_scene)
    throw BadInput("scene", file.string(), fmt::format("must be a file of at most {} bytes", longest_scene));
  return {file.string(), std::move(text)};
}

Scene load_scene(const SceneText& given, const SceneOverrides& overrides) {
  SceneOrigin origin(given.name);
  return scene_of(SceneTable::parse(given.toml, origin, overrides), origin, overrides);
}

Scene load_scene(const std::filesystem::path& file, const SceneOverrides& overrides) {
  return load_scene(read_scene(file), overrides);
}

Scene parse_scene(const std::string& toml, const std::string& name) {
  return load_scene(SceneText{name, toml}, {});
}

std::filesystem::path example_scene(const std::string& name) {
  const auto folder = scenes_directory();
  const auto file = folder / (name + ".toml");
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none)) {
    throw BadInput("scene", name,
                   closest_example(name, folder) + "must be one of the files in " + folder.string());
  }
  return file;
}

SceneText read_scene_or_example(const std::string& name) {
  const std::filesystem::path file = name;
  std::error_code none;  // for example if a name is longer than that of a file may be
  const bool is_file = std::filesystem::exists(file, none) || file.has_parent_path() || file.has_extension();
  return read_scene(is_file ? file : example_scene(name));
}

}  // namespace nipref::data
