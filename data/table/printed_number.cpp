#include <nipref/data/internal/common.hpp>
#include <nipref/data/table/printed_number.hpp>

namespace nipref::data {
namespace {

bool is_digit(char character) { return character >= '0' && character <= '9'; }

/// number * 10^exponent as the nearest double.
std::optional<double> scaled(std::int64_t number, long exponent) {
  return read_exact_number(fmt::format("{}e{}", number, exponent));
}

/// Reads a number with lost digits. Its interval reaches from the number with 0 for all of them to the one with 9.
std::optional<PrintedNumber> read_with_lost_digits(std::string lowest, int scale_exponent) {
  std::string highest = lowest;
  std::ranges::replace(lowest, lost_digit, '0');
  std::ranges::replace(highest, lost_digit, '9');
  const auto one = read_printed_number(lowest, scale_exponent);
  const auto other = read_printed_number(highest, scale_exponent);
  if (!one || !other) return std::nullopt;
  const Interval all{std::min(one->rounding.lower, other->rounding.lower),
                     std::max(one->rounding.upper, other->rounding.upper)};
  return PrintedNumber{all.middle(), all};
}

}  // namespace

std::optional<double> read_exact_number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<PrintedNumber> read_printed_number(std::string_view text, int scale_exponent) {
  if (text.find(lost_digit) != std::string_view::npos)
    return read_with_lost_digits(std::string(text), scale_exponent);
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  const std::size_t point = std::min(text.find('.'), text.size());
  const std::string_view decimals = text.substr(std::min(point + 1, text.size()));
  std::string digits(text.substr(0, point));
  digits += decimals;
  const bool plain = point > 0 && (point == text.size() || !decimals.empty()) &&
                     std::all_of(digits.begin(), digits.end(), is_digit);
  if (!plain) return std::nullopt;

  // With one more digit, half a unit of the last printed digit is 5.
  digits += '0';
  std::int64_t number = 0;
  if (std::from_chars(digits.data(), digits.data() + digits.size(), number).ec != std::errc{})
    return std::nullopt;
  const long exponent = -static_cast<long>(decimals.size()) - scale_exponent - 1;
  const auto value = scaled(number, exponent), inner = scaled(number - 5, exponent),
             outer = scaled(number + 5, exponent);
  if (!value || !inner || !outer) return std::nullopt;
  if (negative) return PrintedNumber{-*value, {-*outer, -*inner}};
  return PrintedNumber{*value, {*inner, *outer}};
}

}  // namespace nipref::data
