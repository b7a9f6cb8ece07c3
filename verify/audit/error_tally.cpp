#include <nipref/verify/audit/error_tally.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {
namespace {

constexpr int bins_of_octave = 32;
constexpr int lowest_octave = -6;
constexpr int bits_of_sum = 32;
constexpr int infinite_bin = 1 << 20;

/// Bin 0 holds the numbers up to 2^lowest_octave. Every other bin includes its upper end.
int bin_of(double number) {
  if (std::isinf(number)) return infinite_bin;
  if (number <= std::ldexp(1, lowest_octave)) return 0;
  const int octave = std::ilogb(number);
  const double beyond = std::ldexp(number, -octave) - 1;  // [0, 1), exact
  return (octave - lowest_octave) * bins_of_octave + static_cast<int>(std::ceil(beyond * bins_of_octave));
}

double upper_end(int bin) {
  if (bin == infinite_bin) return std::numeric_limits<double>::infinity();
  if (bin == 0) return std::ldexp(1, lowest_octave);
  const int octave = (bin - 1) / bins_of_octave, part = (bin - 1) % bins_of_octave + 1;
  return std::ldexp(1 + static_cast<double>(part) / bins_of_octave, octave + lowest_octave);
}

}  // namespace

void ErrorTally::add(double number) {
  largest_ = std::max(largest_, number);
  ++bins_[bin_of(number)];
  const double units = std::ceil(std::ldexp(number, bits_of_sum));
  // A number that is too large for the sum makes the mean infinite.
  if (std::isfinite(units)) {
    sum_ += mpz_class(units);
  } else {
    largest_ = std::numeric_limits<double>::infinity();
  }
}

void ErrorTally::add(const ErrorTally& more) {
  largest_ = std::max(largest_, more.largest_);
  sum_ += more.sum_;
  for (const auto& [bin, count] : more.bins_) bins_[bin] += count;
}

std::uint64_t ErrorTally::count() const {
  std::uint64_t all = 0;
  for (const auto& [bin, count] : bins_) all += count;
  return all;
}

double ErrorTally::mean() const {
  if (std::isinf(largest_)) return largest_;
  return std::ldexp(sum_.get_d(), -bits_of_sum) / static_cast<double>(count());
}

double ErrorTally::percentile(double share) const {
  const auto rank =
      std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(count()))));
  std::uint64_t seen = 0;
  for (const auto& [bin, count] : bins_) {
    seen += count;
    if (seen >= rank) return std::min(upper_end(bin), largest_);
  }
  return largest_;
}

}  // namespace nipref::verify
