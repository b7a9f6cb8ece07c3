#include <bit>
#include <cstdint>

#include <nipref/verify/catalogue/ranges.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;

constexpr auto dots = "..";

/// The number of a double, counted from 0: neighbours differ by 1, and negative doubles have negative numbers.
std::int64_t ordinal(double value) {
  const auto magnitude = std::bit_cast<std::int64_t>(std::fabs(value));
  return std::signbit(value) ? -magnitude : magnitude;
}

double at_ordinal(std::int64_t ordinal) {
  const double magnitude = std::bit_cast<double>(ordinal < 0 ? -ordinal : ordinal);
  return ordinal < 0 ? -magnitude : magnitude;
}

double number_of(const std::string& name, const std::string& text, const std::string& whole) try {
  const double value = std::strtod(text.c_str(), nullptr);
  static_cast<void>(ref::Exact::parse(text, name));
  if (!std::isfinite(value)) throw BadInput(name, whole, "");
  return value;
} catch (const BadInput&) {
  throw BadInput(
      name, whole,
      "must be a number that a double can hold, or lo..hi, lo..hi:log, lo..hi:linear or lo..hi:bits");
}

Spacing spacing_of(const std::string& name, const std::string& text, const std::string& whole) {
  if (text == "linear") return Spacing::linear;
  if (text == "log") return Spacing::log;
  if (text == "bits") return Spacing::bits;
  throw BadInput(name, whole, "must have linear, log or bits after the colon");
}

bool of_one_sign(double lower, double upper) { return lower > 0 || upper < 0; }

}  // namespace

double Range::at(double fraction) const {
  if (fraction <= 0 || fixed()) return lower;
  if (fraction >= 1) return upper;
  double value = lower * (1 - fraction) + upper * fraction;
  if (spacing == Spacing::log)
    value = std::copysign(
        std::exp(std::log(std::fabs(lower)) * (1 - fraction) + std::log(std::fabs(upper)) * fraction), lower);
  if (spacing == Spacing::bits) {
    const std::int64_t first = ordinal(lower), last = ordinal(upper);
    // The distance of two doubles of opposite signs needs 64 bits without a sign.
    const auto steps = static_cast<std::uint64_t>(last) - static_cast<std::uint64_t>(first);
    const auto step =
        static_cast<std::uint64_t>(std::ldexp(fraction, 32) * std::ldexp(static_cast<double>(steps), -32));
    value = at_ordinal(static_cast<std::int64_t>(static_cast<std::uint64_t>(first) + step));
  }
  return std::clamp(value, lower, upper);
}

Range parse_range(const std::string& name, const std::string& text) {
  const std::size_t middle = text.find(dots);
  if (middle == std::string::npos) {
    const double value = number_of(name, text, text);
    return {value, value};
  }
  const std::size_t colon = text.find(':', middle);
  const std::size_t second = middle + std::string_view(dots).size();
  const double lower = number_of(name, text.substr(0, middle), text);
  const double upper =
      number_of(name, text.substr(second, colon == std::string::npos ? colon : colon - second), text);
  if (lower > upper) throw BadInput(name, text, "must have its lower end first");
  if (colon == std::string::npos)
    return {lower, upper, of_one_sign(lower, upper) ? Spacing::log : Spacing::linear};
  const Spacing spacing = spacing_of(name, text.substr(colon + 1), text);
  if (spacing == Spacing::log && !of_one_sign(lower, upper))
    throw BadInput(name, text,
                   "must have both ends of one sign and not 0 to be gone through by its logarithm");
  return {lower, upper, spacing};
}

Ranges parse_ranges(const Quantity& quantity, const Assignments& assignments) {
  const Assignments all = with_material_numbers(quantity, assignments);
  refuse_unknown_arguments(quantity, all);
  Ranges ranges;
  for (const Argument& argument : quantity.arguments) {
    const auto text = argument_text(argument, all);
    if (!text) {
      ranges.emplace_back();
    } else {
      const bool is_choice = argument.kind == ArgumentKind::choice;
      const double number = is_choice ? choice_number(argument, *text) : 0;
      ranges.emplace_back(is_choice ? Range{number, number} : parse_range(argument.name, *text));
    }
  }
  return ranges;
}

bool contains(const Ranges& ranges, const Point& point) {
  for (std::size_t i = 0; i < ranges.size(); ++i)
    if (ranges[i] && !ranges[i]->contains(point[i])) return false;
  return true;
}

}  // namespace nipref::verify
