#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <nipref/verify/report/internal/counts.hpp>

namespace nipref::verify {

std::string fraction(std::size_t some, std::size_t all) { return fmt::format("{} of {}", some, all); }

std::string counted(std::size_t some, std::size_t all, std::string_view what) {
  return (some == all ? fmt::format("all {} ", all) : fraction(some, all) + " ") + std::string(what);
}

std::size_t kept_in(const std::vector<AuditResult>& results) {
  return static_cast<std::size_t>(std::ranges::count_if(results, &AuditResult::kept));
}

std::vector<const BenchRatio*> headline_ratios(const BenchReport& speed) {
  std::vector<const BenchRatio*> headline;
  for (const BenchRatio& ratio : speed.ratios) {
    if (ratio.what.find("against Boost") != std::string::npos ||
        ratio.what.find("against GSL") != std::string::npos)
      headline.push_back(&ratio);
  }
  return headline;
}

std::string two_digits(double number) {
  if (!(number >= 10 && number < 1e6)) return fmt::format("{:.2g}", number);
  const double unit = std::pow(10, std::floor(std::log10(number)) - 1);
  return fmt::format("{:.0f}", std::round(number / unit) * unit);
}

std::string off_text(double relative) {
  const double percent = std::fabs(100 * relative);
  return fmt::format("{} % {}", percent < 1 ? fmt::format("{:.1g}", percent) : fmt::format("{:.0f}", percent),
                     relative < 0 ? "low" : "high");
}

}  // namespace nipref::verify
