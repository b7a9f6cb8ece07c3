#include <algorithm>

#include <nipref/data/scene/keys.hpp>
#include <nipref/data/scene/results.hpp>
#include <nipref/verify/cli/verbs.hpp>

namespace nipref::verify {
namespace {

constexpr std::string_view scene_group = "scene";

Json argument_json(const Argument& argument) {
  const auto written = [](const MaterialModel& model) { return Json(written_model(model)); };
  return {{"name", argument.name},
          {"domain", domain(argument)},
          {"default", argument.default_text},
          {"_models", json_list(argument.models, written)}};
}

Json form_json(const SeedForm& form) { return {{"form", form.name}, {"differs", form.differs}}; }

Json quantity_json(const Quantity* one) {
  const Quantity& quantity = *one;
  return {{"name", quantity.name},
          {"definition", quantity.definition},
          {"source", quantity.source},
          {"scale", quantity.scale},
          {"promise_ulp", quantity.promise},
          {"audit_points", quantity.audit_points},
          {"arguments", json_list(written_arguments(quantity), argument_json)},
          {"seed_forms", json_list(quantity.seed_forms, form_json)}};
}

/// A key that a scene may hold; below, a result that it can want.
Json key_json(const data::SceneKey& key) {
  return {{"name", key.name}, {"unit", key.dimension.text()}, {"meaning", key.meaning}};
}
Json result_json(const data::SceneResult& result) {
  return {{"name", result.name},
          {"unit", result.unit},
          {"meaning", result.meaning},
          {"measured_against", data::text(result.scale)}};
}

/// The rows that the words name, or all rows. Words that name a row are removed.
template <class Rows>
auto named(const Rows& rows, bool all, std::vector<std::string>& words) {
  std::vector<typename Rows::value_type> result;
  for (const auto& row : rows)
    if (std::erase(words, row.name) > 0 || all) result.push_back(row);
  return result;
}

}  // namespace

VerbAnswer list_verb(const CommandLine& line) {
  CommandLine rest = line;
  const bool of_scenes = std::ranges::find(line.words, scene_group) != line.words.end();
  const auto keys = named(data::scene_keys(), of_scenes, rest.words);
  const auto results = named(data::scene_results(), of_scenes, rest.words);
  const bool has_quantities = line.words.empty() || !rest.words.empty();
  const Selection selected = has_quantities ? selection(rest.words, {scene_group}) : Selection{};
  Json answer{{"quantities", json_list(selected.quantities, quantity_json)},
              {"_full", line.has("full") || !line.words.empty()},
              {"_of_quantities", !selected.quantities.empty()},
              {"_of_keys", !keys.empty()},
              {"_of_results", !results.empty()}};
  if (!keys.empty()) answer.set("keys", json_list(keys, key_json));
  if (!results.empty()) answer.set("results", json_list(results, result_json));
  return {"list", answer};
}

}  // namespace nipref::verify
