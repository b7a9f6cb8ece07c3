#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/closest_name.hpp>
#include <nipref/verify/catalogue/arguments.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;

std::string text_of(const Argument& argument, const Quantity& quantity, const Assignments& assignments) {
  if (const auto given = argument_text(argument, assignments)) return *given;
  if (argument.default_text) return *argument.default_text;
  throw BadInput(argument.name, "(missing)",
                 fmt::format("{} needs it: must be {}", quantity.name, domain(argument)));
}

/// The name of a choice stands for its number.
ref::Exact parse(const Argument& argument, const std::string& text) {
  if (argument.kind != ArgumentKind::choice) {
    const ref::Exact number = ref::Exact::parse(text, argument.name);
    const bool refused = (argument.kind == ArgumentKind::nonnegative && number.sign() < 0) ||
                         (argument.kind == ArgumentKind::positive && number.sign() <= 0);
    if (refused) throw BadInput(argument.name, text, "must be " + domain(argument));
    return number;
  }
  const auto found = std::ranges::find(argument.choices, text);
  if (found == argument.choices.end()) throw BadInput(argument.name, text, "must be " + domain(argument));
  return ref::Exact(static_cast<double>(found - argument.choices.begin()));
}

double nearest_double(const std::string& name, const std::string& text, const ref::Exact& exact) {
  const double value = std::strtod(text.c_str(), nullptr);
  if (!std::isfinite(value) || (value == 0 && exact.sign() != 0)) {
    throw BadInput(name, text, "must be within the range of a double for fast; --path ref takes it");
  }
  return value;
}

}  // namespace

void refuse_unknown_arguments(const Quantity& quantity, const Assignments& assignments) {
  std::vector<std::string_view> known;
  for (const Argument& argument : quantity.arguments) known.push_back(argument.name);
  for (const auto& [name, value] : assignments) {
    if (std::ranges::find(known, name) == known.end()) {
      throw BadInput(name, value,
                     fmt::format("unknown argument: {}{} takes {}", data::did_you_mean(name, known),
                                 quantity.name, fmt::join(known, ", ")));
    }
  }
}

std::optional<std::string> argument_text(const Argument& argument, const Assignments& assignments) {
  std::vector<std::string> given;
  for (const auto& [name, value] : assignments) {
    if (name == argument.name) given.push_back(value);
  }
  if (given.size() > 1) throw BadInput(argument.name, given[1], "given twice: must be given once");
  return given.empty() ? std::nullopt : std::optional(given.front());
}

Point ParsedArguments::nearest(const Quantity& quantity) const {
  Point point;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const Argument& argument = quantity.arguments[i];
    point.push_back(argument.kind == ArgumentKind::choice ? exact[i].approximate()
                                                          : nearest_double(argument.name, text[i], exact[i]));
  }
  return point;
}

ParsedArguments parse_arguments(const Quantity& quantity, const Assignments& assignments) {
  refuse_unknown_arguments(quantity, assignments);
  ParsedArguments parsed;
  for (const Argument& argument : quantity.arguments) {
    parsed.text.push_back(text_of(argument, quantity, assignments));
    parsed.exact.push_back(parse(argument, parsed.text.back()));
  }
  return parsed;
}

long parse_integer(const std::string& name, const std::string& text) {
  long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    throw BadInput(name, text, "must be a whole number");
  return value;
}

double parse_real(const std::string& name, const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    throw BadInput(name, text, "must be a finite number");
  }
  return value;
}

}  // namespace nipref::verify
