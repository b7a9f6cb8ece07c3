#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <nipref/verify/report/report.hpp>

namespace nipref::verify {

// Numbers that both the text and the page say.

/// "88 of 88", "3 of 88"
std::string fraction(std::size_t some, std::size_t all);
/// "all 88 quantities kept", "87 of 88 quantities kept"
std::string counted(std::size_t some, std::size_t all, std::string_view what);

std::size_t kept_in(const std::vector<AuditResult>& results);

/// The promised ratios of fast's times to those of other libraries.
std::vector<const BenchRatio*> headline_ratios(const BenchReport& speed);

/// What a run has missed, skipped or left unexplained.
struct Shortfall {
  std::string count;  ///< "3 missed"
  std::string what;   ///< of how many, and what these are
  std::string id;     ///< where more about it stands on the page
};

std::vector<Shortfall> shortfalls(const Report& report);

/// 68441 as 68000, 33.2 as 33, 1e12 as 1e+12
std::string two_digits(double number);

/// "26 % low", "102 % high", "0.07 % high"
std::string off_text(double relative);

}  // namespace nipref::verify
