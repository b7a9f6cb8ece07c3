#include <fmt/format.h>

#include <nipref/data/scene/keys.hpp>
#include <nipref/data/scene/results.hpp>
#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/json.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

constexpr std::string_view scene_group = "scene";
constexpr auto symbols =
    "\nalpha = y/b: distance from the load; eta = l/b: distance from the load to the point held fixed; b: "
    "half thickness of the sheet\n";

Json argument_json(const Argument& argument) {
  return {{"name", argument.name}, {"domain", domain(argument)}, {"default", argument.default_text}};
}

Json form_json(const SeedForm& form) { return {{"form", form.name}, {"differs", form.differs}}; }

Json quantity_json(const Quantity& quantity) {
  return {{"name", quantity.name},
          {"definition", quantity.definition},
          {"source", quantity.source},
          {"scale", quantity.scale},
          {"promise_ulp", quantity.promise},
          {"audit_points", quantity.audit_points},
          {"arguments", json_list(written_arguments(quantity), argument_json)},
          {"seed_forms", json_list(quantity.seed_forms, form_json)}};
}

std::string arguments_text(const Quantity& quantity) {
  std::string text;
  for (const Argument& argument : written_arguments(quantity)) {
    text += fmt::format(" {}={}", argument.name, argument.default_text.value_or(""));
  }
  return text.substr(1);
}

/// What it is, and what it takes.
std::string brief_text(const Quantity& quantity) {
  return fmt::format("{}  {}\n    {}\n", quantity.name, arguments_text(quantity), quantity.definition);
}

std::string full_text(const Quantity& quantity) {
  std::string text = fmt::format(
      "{} = {}\n  source: {}\n  errors are measured against: {}\n  fast promises, at full accuracy: {:g} ulp of "
      "that\n  audit: {} points unless told otherwise\n",
      quantity.name, quantity.definition, quantity.source, quantity.scale, quantity.promise,
      quantity.audit_points);
  for (const Argument& argument : written_arguments(quantity)) {
    text +=
        fmt::format("  {} {}: {}\n", argument.name,
                    argument.default_text ? "= " + *argument.default_text + " if not given" : "must be given",
                    domain(argument));
    for (const MaterialModel& model : argument.models)
      text += fmt::format("    {}={}\n", argument.name, written_model(model));
  }
  for (const SeedForm& form : quantity.seed_forms)
    text += fmt::format("  form={}: {}\n", form.name, form.differs);
  return text;
}

/// What a scene may hold and what it can want.
Json key_json(const data::SceneKey& key) {
  return {{"name", key.name}, {"unit", key.dimension.text()}, {"meaning", key.meaning}};
}
Json result_json(const data::SceneResult& result) {
  return {{"name", result.name}, {"unit", result.unit}, {"meaning", result.meaning}};
}
std::string scene_text() {
  std::string text = "keys of a scene, in any consistent units\n";
  for (const data::SceneKey& key : data::scene_keys())
    text += fmt::format("  {} [{}]: {}\n", key.name, key.dimension.text(), key.meaning);
  text += "results that a scene can want\n";
  for (const data::SceneResult& result : data::scene_results())
    text += fmt::format("  {} [{}]: {}\n", result.name, result.unit, result.meaning);
  return text;
}

}  // namespace

int list_verb(const CommandLine& line, std::ostream& out) {
  const Selection selected = selection(line, {scene_group});
  const bool of_scenes = !line.words.empty() && selected.has(scene_group);
  const auto members = [&] {
    Json answer{{"quantities",
                 json_list(selected.quantities, [](const Quantity* one) { return quantity_json(*one); })}};
    if (of_scenes) {
      answer.set("keys", json_list(data::scene_keys(), key_json));
      answer.set("results", json_list(data::scene_results(), result_json));
    }
    return answer;
  };
  const auto text = [&] {
    std::string all = of_scenes ? scene_text() : "";
    for (const Quantity* quantity : selected.quantities)
      all += line.has("full") || !line.words.empty() ? full_text(*quantity) : brief_text(*quantity);
    return folded(selected.quantities.empty() ? all : all + symbols);
  };
  return write_answer(line, out, "list", true, members, text);
}

}  // namespace nipref::verify
