#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {
namespace {

constexpr unsigned largest_exponent = 5000;

mpq_class power(unsigned long base, long exponent) {
  mpz_class magnitude;
  mpz_ui_pow_ui(magnitude.get_mpz_t(), base, static_cast<unsigned long>(std::labs(exponent)));
  return exponent >= 0 ? mpq_class(magnitude) : mpq_class(mpz_class(1), magnitude);
}

/// Removes a leading sign and returns whether it is a minus.
bool take_minus(std::string_view& text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  return negative;
}

/// The whole text as a signed exponent; nothing if the text is malformed or the exponent too large.
std::optional<long> exponent_of(std::string_view text) {
  const bool negative = take_minus(text);
  unsigned exponent = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), exponent);
  if (error != std::errc() || end != text.data() + text.size() || exponent > largest_exponent)
    return std::nullopt;
  return negative ? -static_cast<long>(exponent) : static_cast<long>(exponent);
}

std::optional<mpq_class> parse_rational(std::string_view text) {
  const bool negative = take_minus(text);
  const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  if (hexadecimal) text.remove_prefix(2);
  const std::size_t end = std::min(text.find_first_of(hexadecimal ? "pP" : "eE"), text.size());
  const std::optional<long> exponent = end < text.size() ? exponent_of(text.substr(end + 1)) : 0L;
  // The digits before and after the point form one integer; behind_point counts those after the point.
  std::string digits(text.substr(0, end));
  long behind_point = 0;
  if (const std::size_t point = digits.find('.'); point != std::string::npos) {
    digits.erase(point, 1);
    behind_point = static_cast<long>(digits.size() - point);
  }
  const char* allowed = hexadecimal ? "0123456789abcdefABCDEF" : "0123456789";
  if (!exponent || digits.empty() || digits.size() > largest_exponent ||
      digits.find_first_not_of(allowed) != std::string::npos)
    return std::nullopt;
  const mpz_class integer(digits, hexadecimal ? 16 : 10);
  mpq_class value =
      integer * (hexadecimal ? power(2, *exponent - 4 * behind_point) : power(10, *exponent - behind_point));
  value.canonicalize();
  return negative ? mpq_class(-value) : value;
}

}  // namespace

Exact::Exact(double value, std::string_view name) {
  if (!std::isfinite(value)) throw data::BadInput(name, value, "must be a finite number");
  value_ = value;
}

Exact Exact::parse(std::string_view text, std::string_view name) {
  const auto value = parse_rational(text);
  if (!value) {
    throw data::BadInput(name, text,
                         "must be a finite decimal or hexadecimal number, like 0.73, -1e-12 or 0x1.8p-3, "
                         "with an exponent of at most 5000");
  }
  return Exact(*value);
}

Exact Exact::magnitude() const { return Exact(mpq_class(abs(value_))); }

std::string Exact::text() const {
  Float nearest = zero_of_bits(64);
  mpfr_set_q(raw(nearest), value_.get_mpq_t(), MPFR_RNDN);
  std::array<char, 64> buffer{};
  mpfr_snprintf(buffer.data(), buffer.size(), "%.16Rg", raw(nearest));
  return buffer.data();
}

double Exact::approximate() const {
  Float nearest = zero_of_bits(53);
  mpfr_set_q(raw(nearest), value_.get_mpq_t(), MPFR_RNDN);
  return mpfr_get_d(raw(nearest), MPFR_RNDN);
}

double Exact::log2_magnitude() const {
  if (sign() == 0) return -HUGE_VAL;
  long numerator_exponent = 0;
  long denominator_exponent = 0;
  const double numerator = mpz_get_d_2exp(&numerator_exponent, value_.get_num_mpz_t());
  const double denominator = mpz_get_d_2exp(&denominator_exponent, value_.get_den_mpz_t());
  return std::log2(std::abs(numerator) / denominator) +
         static_cast<double>(numerator_exponent - denominator_exponent);
}

Float to_float(const mpq_class& exact) {
  Float value;
  mpfr_set_q(raw(value), exact.get_mpq_t(), MPFR_RNDN);
  return value;
}

Exact to_exact(const Float& value) {
  mpq_class exact;
  mpfr_get_q(exact.get_mpq_t(), raw(value));
  return Exact(exact);
}

}  // namespace nipref::ref
