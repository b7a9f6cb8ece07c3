#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <string>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/catalogue/named_point.hpp>

namespace nipref::verify {

namespace {

std::string_view domain_of_number(ArgumentKind kind) {
  switch (kind) {
    case ArgumentKind::nonzero_position:
      return "a finite nonzero number";
    case ArgumentKind::young:
    case ArgumentKind::positive:
      return "a finite number > 0";
    case ArgumentKind::depth:
      return "a number from -1 to 1";
    case ArgumentKind::poisson:
      return "a number > -1 and <= 0.5";
    case ArgumentKind::index:
      return "a whole number from 1 to 1000000";
    case ArgumentKind::rate:
    case ArgumentKind::time:
    case ArgumentKind::nonnegative:
      return "a finite number >= 0";
    default:
      return "a finite number";
  }
}

}  // namespace

std::string domain(const Argument& argument) {
  if (argument.kind != ArgumentKind::choice) return std::string(domain_of_number(argument.kind));
  return fmt::format("{}", fmt::join(argument.choices, " or "));
}

double default_number(const Argument& argument) {
  if (!argument.default_text) return 0;
  if (argument.kind != ArgumentKind::choice) return std::stod(*argument.default_text);
  return static_cast<double>(std::ranges::find(argument.choices, *argument.default_text) -
                             argument.choices.begin());
}

Point point_of(const Quantity& quantity, const std::vector<std::pair<std::string_view, double>>& given) {
  Point point;
  for (const Argument& argument : quantity.arguments) point.push_back(default_number(argument));
  for (const auto& [name, number] : given) point[argument_number(quantity.arguments, name)] = number;
  return point;
}

double fast_value(const Quantity& quantity, std::span<const double> point, fast::Accuracy accuracy) {
  try {
    return quantity.by_fast(point, accuracy);
  } catch (const data::BadInput&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

ref::Estimate ref_value(const Quantity& quantity, std::span<const double> point, int digits) {
  if (quantity.by_ref_of_doubles) return quantity.by_ref_of_doubles(point, digits);
  std::vector<ref::Exact> exact;
  exact.reserve(point.size());
  for (std::size_t i = 0; i < point.size(); ++i) exact.emplace_back(point[i], quantity.arguments[i].name);
  return quantity.by_ref(exact, digits);
}

}  // namespace nipref::verify
