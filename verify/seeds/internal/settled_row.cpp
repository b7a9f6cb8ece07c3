#include <algorithm>
#include <cmath>

#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/ulp.hpp>
#include <nipref/verify/seeds/internal/settled_row.hpp>

namespace nipref::verify {

SettledRow::SettledRow(const std::string& name, const Assignments& given) : quantity(&find_quantity(name)) {
  constexpr int digits = 20;
  const ParsedArguments arguments = parse_arguments(*quantity, given);
  point = arguments.nearest(*quantity);
  by_fast = quantity->by_fast(point, {});
  by_ref = quantity->by_ref(arguments.exact, digits).to_double();
  promised = quantity->promise * ulp_of(std::max(std::fabs(by_fast), quantity->envelope(point)));
}

Settlement settled_by_form(const std::string& name, const Assignments& given) {
  const SettledRow row(name, given);
  const auto form = std::ranges::find(row.quantity->seed_forms, "printed", &SeedForm::name);
  std::string at = name;
  for (const auto& [argument, text] : given) at += " " + argument + "=" + text;
  return {at, form->value(row.point), row.by_fast, row.by_ref, row.promised};
}

}  // namespace nipref::verify
