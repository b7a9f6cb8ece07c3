#pragma once
#include <nlohmann/json.hpp>

#include "support/paths.hpp"
#include "support/test.hpp"

/// A JSON Schema (draft 2020-12) with a few keywords. A schema with other keywords is refused with
/// std::invalid_argument, so that no part of it goes unchecked. $ref leads to #/$defs only.
class JsonSchema {
 public:
  using Json = nlohmann::json;

  explicit JsonSchema(Json root) : root_(std::move(root)) { check_keywords(root_); }

  /// The first part of `value` that does not fit; empty if all fits. `definition`: a name in $defs; empty: the root.
  [[nodiscard]] std::string misfit(const Json& value, const std::string& definition = "") const {
    return misfit(definition.empty() ? root_ : root_["$defs"].at(definition), value, "answer");
  }

 private:
  static constexpr std::array says_nothing{"$schema", "$id", "title", "description"};
  static constexpr std::array by_name{"$defs", "properties"};  // with a schema under each name
  static constexpr std::array others{
      "$ref", "additionalProperties", "anyOf", "const", "enum", "items", "required", "type"};

  static bool is_among(const auto& names, const std::string& name) {
    return std::ranges::find(names, std::string_view(name)) != names.end();
  }

  static void check_keywords(const Json& schema) {
    if (schema.is_boolean()) return;
    for (const auto& [keyword, content] : schema.items()) {
      if (is_among(by_name, keyword) || keyword == "anyOf") {
        for (const Json& part : content) check_keywords(part);
      } else if (keyword == "items" || keyword == "additionalProperties") {
        check_keywords(content);
      } else if (!is_among(says_nothing, keyword) && !is_among(others, keyword)) {
        throw std::invalid_argument("unknown keyword " + keyword);
      }
    }
  }

  static bool has_type(const Json& value, const Json& types) {
    if (types.is_array())
      return std::ranges::any_of(types, [&](const Json& type) { return has_type(value, type); });
    return types == "integer" ? value.is_number_integer() : types == value.type_name();
  }

  [[nodiscard]] std::string misfit_of_members(const Json& schema, const Json& value,
                                              const std::string& at) const {
    for (const auto& [name, member] : value.items()) {
      const Json known = schema.value("properties", Json::object());
      const Json part = known.contains(name) ? known[name] : schema.value("additionalProperties", Json(true));
      if (const std::string found = misfit(part, member, at + "." + name); !found.empty()) return found;
    }
    for (const Json& name : schema.value("required", Json::array())) {
      if (!value.contains(name)) return at + " has no " + name.get<std::string>();
    }
    return "";
  }

  [[nodiscard]] std::string misfit_of_choice(const Json& choices, const Json& value,
                                             const std::string& at) const {
    std::string all;
    for (const Json& choice : choices) {
      const std::string found = misfit(choice, value, at);
      if (found.empty()) return "";
      all += "\n  " + found;
    }
    return at + " fits none:" + all;
  }

  [[nodiscard]] std::string misfit(const Json& schema, const Json& value, const std::string& at) const {
    if (schema.is_boolean()) return schema.get<bool>() ? "" : at + " is not expected";
    const auto has = [&](const char* keyword) { return schema.contains(keyword); };
    if (has("type") && !has_type(value, schema["type"])) return at + " is no " + schema["type"].dump();
    if (has("const") && value != schema["const"]) return at + " is not " + schema["const"].dump();
    if (has("enum") && std::ranges::find(schema["enum"], value) == schema["enum"].end())
      return at + " is none of " + schema["enum"].dump();
    std::string found;
    if (has("$ref"))
      found = misfit(root_.at(Json::json_pointer(schema["$ref"].get<std::string>().substr(1))), value, at);
    if (found.empty() && has("anyOf")) found = misfit_of_choice(schema["anyOf"], value, at);
    if (found.empty() && value.is_object()) found = misfit_of_members(schema, value, at);
    if (value.is_array() && has("items")) {
      for (std::size_t i = 0; i < value.size() && found.empty(); ++i)
        found = misfit(schema["items"], value[i], at + "[" + std::to_string(i) + "]");
    }
    return found;
  }

  Json root_;
};

/// The schema of the program's answers.
inline const JsonSchema& answer_schema() {
  static const JsonSchema schema(
      nlohmann::json::parse(std::ifstream(source_directory() + "/data/schema/nipref-1.json")));
  return schema;
}

/// Whether is_so(name, value) holds for a member at any depth.
bool holds_anywhere(const nlohmann::json& value, const auto& is_so) {
  if (!value.is_structured()) return false;
  for (const auto& [name, item] : value.items()) {
    if (is_so(name, item) || holds_anywhere(item, is_so)) return true;
  }
  return false;
}
