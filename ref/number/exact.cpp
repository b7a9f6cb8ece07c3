#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {
namespace {

constexpr int largest_exponent = 5000;

mpq_class power(unsigned long base, long exponent) {
  mpz_class magnitude;
  mpz_ui_pow_ui(magnitude.get_mpz_t(), base, static_cast<unsigned long>(std::labs(exponent)));
  return exponent >= 0 ? mpq_class(magnitude) : mpq_class(mpz_class(1), magnitude);
}

bool take(std::string_view& text, char lower) {
  if (text.empty() || std::tolower(static_cast<unsigned char>(text.front())) != lower) return false;
  text.remove_prefix(1);
  return true;
}

/// Digits before and after the point, as one integer and the number of them behind the point.
struct Digits {
  std::string all;
  int behind_point = 0;
};

Digits take_digits(std::string_view& text, bool hexadecimal) {
  Digits digits;
  bool point = false;
  for (; !text.empty(); text.remove_prefix(1)) {
    const auto c = static_cast<unsigned char>(text.front());
    if (c == '.' && !point) {
      point = true;
    } else if (hexadecimal ? std::isxdigit(c) != 0 : std::isdigit(c) != 0) {
      digits.all += static_cast<char>(c);
      digits.behind_point += point ? 1 : 0;
    } else {
      break;
    }
  }
  return digits;
}

/// The signed exponent at the end of the text; nothing if it is malformed or too large.
std::optional<int> take_exponent(std::string_view& text) {
  const bool negative = take(text, '-');
  if (!negative) take(text, '+');
  if (text.empty() || text.size() > 4) return std::nullopt;
  int exponent = 0;
  for (; !text.empty(); text.remove_prefix(1)) {
    if (std::isdigit(static_cast<unsigned char>(text.front())) == 0) return std::nullopt;
    exponent = 10 * exponent + (text.front() - '0');
  }
  if (exponent > largest_exponent) return std::nullopt;
  return negative ? -exponent : exponent;
}

std::optional<mpq_class> parse_rational(std::string_view text) {
  const bool negative = take(text, '-');
  if (!negative) take(text, '+');
  const bool hexadecimal = text.size() > 2 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
  if (hexadecimal) text.remove_prefix(2);
  const Digits digits = take_digits(text, hexadecimal);
  if (digits.all.empty() || digits.all.size() > largest_exponent) return std::nullopt;
  int exponent = 0;
  if (!text.empty()) {
    if (!take(text, hexadecimal ? 'p' : 'e')) return std::nullopt;
    const auto given = take_exponent(text);
    if (!given) return std::nullopt;
    exponent = *given;
  }
  const mpz_class integer(digits.all, hexadecimal ? 16 : 10);
  const mpq_class scale =
      hexadecimal ? power(2, exponent - 4 * digits.behind_point) : power(10, exponent - digits.behind_point);
  mpq_class value = integer * scale;
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

Float to_float(const Exact& exact) {
  Float value;
  mpfr_set_q(raw(value), exact.value().get_mpq_t(), MPFR_RNDN);
  return value;
}

Exact to_exact(const Float& value) {
  mpq_class exact;
  mpfr_get_q(exact.get_mpq_t(), raw(value));
  return Exact(exact);
}

}  // namespace nipref::ref
