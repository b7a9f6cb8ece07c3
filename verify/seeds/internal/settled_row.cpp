#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/ulp.hpp>
#include <nipref/verify/seeds/internal/settled_row.hpp>

namespace nipref::verify {
Propagated SettledRow::in_double(const ref::Estimate& reference) {
  const double value = reference.to_double();
  return {value, std::fabs(reference.error_of(value)) + std::strtod(reference.error_text().c_str(), nullptr)};
}

SettledRow::SettledRow(const std::string& name, const Assignments& given)
    : quantity(&find_quantity(name)), by_fast(0), by_ref(0) {
  constexpr int digits = 20;
  const ParsedArguments arguments = parse_arguments(*quantity, given);
  point = arguments.nearest(*quantity);
  by_ref = in_double(quantity->by_ref(arguments.exact, digits));
  const double value = quantity->by_fast(point, {});
  const double promised = quantity->promise * ulp_of(std::max(std::fabs(value), quantity->envelope(point)));
  const Propagated moved = in_double(ref_value(*quantity, point, digits)) - by_ref;
  by_fast = {value, promised + std::fabs(moved.value()) + moved.error()};
}

Settlement settled_by_form(const std::string& name, const Assignments& given) {
  const SettledRow row(name, given);
  const auto form = std::ranges::find(row.quantity->seed_forms, "printed", &SeedForm::name);
  std::string at = name;
  for (const auto& [argument, text] : given) at += " " + argument + "=" + text;
  return {at, printed_form(form->value(row.point)), row.by_fast, row.by_ref};
}

}  // namespace nipref::verify
