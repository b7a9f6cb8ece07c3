#include <algorithm>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/internal/contact.hpp>

namespace nipref::ref {
namespace {

constexpr int most_digits = 100;
constexpr int guard_digits = 12;
constexpr long most_directions = 4096;

[[noreturn]] void refuse_digits(int digits) {
  throw data::BadInput("digits", std::to_string(digits),
                       "must be fewer, the speed farther below the critical one or the body rounder: " +
                           std::to_string(most_directions) + " lines do not give them here");
}

Float at_most_1(const Float& value) { return std::min(Float(1), Float(abs(value))); }

Float number(const Real& real) {
  if (mpfr_number_p(real.get()) == 0)
    throw data::BadInput("surface", mpfr_nan_p(real.get()) != 0 ? "nan" : "infinite",
                         "must answer with finite numbers");
  return to_float(real);
}

}  // namespace

WorkingAnswer WorkingSurface::at(const Exact& degrees) const {
  const LineAnswer line = answer_(degrees, digits_);
  return {number(line.compliance), number(line.coupling), number(line.coupling_across), number(line.in_line)};
}

Float tolerance(int digits) { return pow(Float(10), -digits); }

Estimated with_digits(int digits, const std::function<Estimated(int working)>& compute, int cancelled) {
  if (digits < 16 || digits > most_digits)
    throw data::BadInput("digits", std::to_string(digits),
                         "must be from 16 to " + std::to_string(most_digits));
  const WorkingDigits working(digits + guard_digits + cancelled);
  return compute(digits + guard_digits + cancelled);
}

Estimated estimated(const Float& value, const Float& error, int digits) {
  // Two results may agree to the last bit: then rounding and the surface's own digits are what is left.
  const Float sum = error + tolerance(digits + guard_digits / 2) * at_most_1(value);
  if (!(sum <= tolerance(digits) * at_most_1(value))) refuse_digits(digits);
  return {to_real(value), to_real(sum), digits};
}

Estimated closed(const Float& value, int digits) { return estimated(value, 0, digits); }

bool is_settled(const Float& change, const Float& value, int digits) {
  return change <= tolerance(digits) * at_most_1(value) / 10;
}

void double_directions(int digits, const CrowdedDirections& directions,
                       const std::function<Float(const Exact& degrees)>& value,
                       const std::function<bool(const std::vector<DirectionValue>& values)>& settled) {
  std::vector<DirectionValue> values;
  for (long count = 8; count <= most_directions; count *= 2) {
    std::vector<DirectionValue> finer;
    for (long i = 0; i < count; ++i) {
      if (!values.empty() && i % 2 == 0) {
        finer.push_back(std::move(values[static_cast<std::size_t>(i / 2)]));
      } else {
        auto at = directions.at(i, count);
        Float found = value(at.degrees);
        finer.push_back({std::move(at), std::move(found)});
      }
    }
    values = std::move(finer);
    if (settled(values)) return;
  }
  refuse_digits(digits);
}

}  // namespace nipref::ref
