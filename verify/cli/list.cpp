#include <fmt/format.h>

#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/answer.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {
namespace {

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
          {"arguments", json_list(quantity.arguments, argument_json)},
          {"seed_forms", json_list(quantity.seed_forms, form_json)}};
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
    out << answer_text("list", {{"quantities", json_list(catalogue(), quantity_json)}}, line.no_times);
    return 0;
  }
  for (const Quantity& quantity : catalogue()) {
    out << fmt::format("{:8} {:31} {}\n{:40} {}; scale: {}\n", quantity.name, arguments_text(quantity),
                       quantity.definition, "", quantity.source, quantity.scale);
    for (const SeedForm& form : quantity.seed_forms)
      out << fmt::format("{:40} form={}: {}\n", "", form.name, form.differs);
  }
  out << "\nalpha = y/b: distance from the load; eta = l/b: distance from the load to the point held fixed; b: half "
         "thickness of the sheet\n";
  return 0;
}

}  // namespace nipref::verify
