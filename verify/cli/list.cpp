#include <fmt/format.h>
#include <fmt/ostream.h>

#include <nlohmann/json.hpp>

#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/internal/print_json.hpp>

namespace nipref::verify {
namespace {

nlohmann::ordered_json to_json(const Argument& argument) {
  nlohmann::ordered_json json{{"name", argument.name}, {"domain", domain(argument)}};
  json["default"] = argument.default_text ? nlohmann::ordered_json(*argument.default_text) : nullptr;
  return json;
}

nlohmann::ordered_json to_json(const Quantity& quantity) {
  nlohmann::ordered_json json{{"name", quantity.name},
                              {"definition", quantity.definition},
                              {"source", quantity.source},
                              {"scale", quantity.scale}};
  json["arguments"] = nlohmann::ordered_json::array();
  for (const Argument& argument : quantity.arguments) json["arguments"].push_back(to_json(argument));
  json["seed_forms"] = nlohmann::ordered_json::array();
  for (const SeedForm& form : quantity.seed_forms)
    json["seed_forms"].push_back({{"form", form.name}, {"differs", form.differs}});
  return json;
}

std::string arguments_text(const Quantity& quantity) {
  std::string text;
  for (const Argument& argument : quantity.arguments) {
    text += fmt::format(" {}={}", argument.name, argument.default_text.value_or(""));
  }
  return text.substr(1);
}

}  // namespace

int list_verb(const CommandLine& line, std::ostream& out) {
  if (line.json) {
    nlohmann::ordered_json json{{"quantities", nlohmann::ordered_json::array()}};
    for (const Quantity& quantity : catalogue()) json["quantities"].push_back(to_json(quantity));
    print_json(json, out);
    return 0;
  }
  for (const Quantity& quantity : catalogue()) {
    fmt::print(out, "{:8} {:31} {}\n{:40} {}; scale: {}\n", quantity.name, arguments_text(quantity),
               quantity.definition, "", quantity.source, quantity.scale);
    for (const SeedForm& form : quantity.seed_forms)
      fmt::print(out, "{:40} form={}: {}\n", "", form.name, form.differs);
  }
  fmt::print(out,
             "\nalpha = y/b: distance from the load; eta = l/b: distance from the load to the point held "
             "fixed; b: half thickness of the sheet\n");
  return 0;
}

}  // namespace nipref::verify
