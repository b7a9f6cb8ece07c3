#include "data/scene_file.hpp"

#include <utility>

#include "data/bad_input.hpp"
#include "data/scene_table.hpp"
#include "data/table_index.hpp"

namespace nipref::data {
namespace {

/// First of all, so that a scene for another material is not refused for some other key of its own.
void check_material_model(const SceneTable& file, const SceneOrigin& origin) {
  const SceneTable material = file.table("material");
  const std::string model = material.text("model");
  if (model != "elastic")
    origin.refuse("material.model", model, "must be elastic, the only model known so far");
}

ElasticNip read_nip(const SceneTable& file) {
  const SceneTable roller = file.table("roller");
  const SceneTable sheet = file.table("sheet");
  const SceneTable material = file.table("material");
  roller.allow({"radius"});
  sheet.allow({"thickness"});
  material.allow({"model", "young", "poisson"});
  return {roller.number("radius"),
          sheet.number("thickness"),
          {material.number("young"), material.number("poisson")}};
}

GivenLoad read_load(const SceneTable& load) {
  load.allow({"per_length"});
  return {load.number("per_length")};
}

GivenLength read_contact(const SceneTable& contact) {
  contact.allow({"length"});
  return {contact.number("length")};
}

std::variant<GivenLoad, GivenLength> read_given(const SceneTable& file, const SceneOrigin& origin) {
  if (file.has("contact")) {
    const SceneTable contact = file.table("contact");
    if (file.has("load"))
      origin.refuse("contact", "(beside load)", "must be left out, or load: one of the two");
    return read_contact(contact);
  }
  if (!file.has("load")) {
    origin.refuse("load", "(missing)", "must be given, or contact in its place: one of the two");
  }
  return read_load(file.table("load"));
}

void read_friction(const SceneTable& friction, ElasticNipProblem& problem) {
  friction.allow({"model", "creep_ratio"});
  problem.friction = friction.choice("model", {"none", "full"}) == "full" ? Friction::full : Friction::none;
  if (friction.has("creep_ratio")) problem.creep_ratio = friction.number("creep_ratio");
}

std::variant<ConvergedMethod, LineLoads> read_method(const SceneTable& method) {
  if (method.choice("kind", {"converged", "line-loads"}) == "converged") {
    method.allow({"kind"});
    return ConvergedMethod{};
  }
  method.allow({"kind", "leading_elements", "trailing_elements", "residue_terms"});
  return LineLoads{method.whole("leading_elements"), method.whole("trailing_elements"),
                   method.has("residue_terms") ? method.whole("residue_terms") : 0};
}

std::variant<EvenlySpaced, Positions> read_profile(const SceneTable& profile, const SceneOrigin& origin) {
  profile.allow({"points", "positions"});
  if (profile.has("points") == profile.has("positions")) {
    origin.refuse("profile", profile.has("points") ? "(points and positions)" : "(empty)",
                  "must hold points or positions, one of the two");
  }
  if (profile.has("points")) return EvenlySpaced{profile.whole("points")};
  return Positions{profile.numbers("positions")};
}

ElasticNipProblem read_elastic_nip(const SceneTable& file, const SceneOrigin& origin) {
  ElasticNipProblem problem{.nip = read_nip(file),
                            .given = read_given(file, origin),
                            .creep_ratio = {},
                            .method = {},
                            .profile = {}};
  read_friction(file.table("friction"), problem);
  problem.method = read_method(file.table("method"));
  if (file.has("profile")) problem.profile = read_profile(file.table("profile"), origin);
  return problem;
}

}  // namespace

Scene load_scene(const std::filesystem::path& file) {
  SceneOrigin origin(file.string());
  const SceneTable top = SceneTable::read(file, origin);
  if (top.has("material")) check_material_model(top, origin);
  top.allow({"title", "wanted", "accuracy", "roller", "sheet", "material", "load", "contact", "friction",
             "method", "profile"});
  Scene scene{.title = top.text("title"),
              .wanted = top.texts("wanted"),
              .system = read_elastic_nip(top, origin),
              .origin = {}};
  if (top.has("accuracy")) scene.accuracy = top.number("accuracy");
  scene.origin = std::move(origin);
  scene.check();
  return scene;
}

std::filesystem::path example_scene(const std::string& name) {
  const auto folder = tables_directory().parent_path() / "scenes";
  const auto file = folder / (name + ".toml");
  if (!std::filesystem::is_regular_file(file)) {
    throw BadInput("scene", name, "must be one of the files in " + folder.string());
  }
  return file;
}

}  // namespace nipref::data
