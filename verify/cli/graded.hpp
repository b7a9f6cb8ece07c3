#pragma once
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/grade/baseline.hpp>
#include <nipref/verify/grade/fault.hpp>
#include <nipref/verify/grade/grade.hpp>
#include <nipref/verify/grade/speed.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// A kernel beside an older one.
struct Slowdown {
  std::string older;           ///< file
  double allowed;              ///< its time over the older one's may be 1 and so much
  std::optional<Speed> speed;  ///< none: one of them fails

  [[nodiscard]] bool kept() const { return speed && speed->ratio <= 1 + allowed; }
};

/// A grade and all that is said of it besides.
struct Graded {
  Grade grade;
  double seconds;
  std::string promised = {};       ///< what is allowed, in words; empty: what fast promises
  std::optional<double> own = {};  ///< the value at the worst point; nothing where there is none
  std::string seed = {};           ///< of its points
  std::vector<std::string> remarks = {};
  std::optional<BaselineComparison> against_baseline = {};
  bool is_kernel = false;  ///< what follows is of kernels alone
  std::vector<Fault> faults = {};
  std::optional<Speed> to_fast = {};  ///< none: it fails
  std::optional<Slowdown> to_older = {};

  [[nodiscard]] bool kept() const;
};

std::string graded_text(const Graded& graded);
Json graded_json(const Graded& graded);
/// The test suite in the JUnit format, which Jenkins, GitLab and others read.
std::string junit_text(const std::vector<Graded>& all);

/// Allows what --promise says and returns it in words, none if it is not given: N or Nulp is in units in the last place, Nrel or N < 1/2 a part of
/// the scale, as no double keeps less than half a unit, Nabs in the quantity's own unit.
std::string take_promise(const CommandLine& line, AuditOptions& options);

/// Appends the worst point of a grade, with the reference's value of 50 digits, to a file like those of data/golden,
/// of which it is the first row if there is none. Nothing if the point is there. BadInput naming "keep-worst" if the
/// file is about another quantity. OutputError if it cannot be written.
void keep_worst(const std::string& path, const Graded& graded);

}  // namespace nipref::verify
