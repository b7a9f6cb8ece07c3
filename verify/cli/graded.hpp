#pragma once
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/grade/baseline.hpp>
#include <nipref/verify/grade/fault.hpp>
#include <nipref/verify/grade/grade.hpp>
#include <nipref/verify/grade/speed.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// The speed of a kernel beside an older one.
struct Slowdown {
  std::string older;           ///< its file
  double allowed;              ///< the ratio of its time to the older one's may be 1 + allowed
  std::optional<Speed> speed;  ///< nothing if one of them fails

  [[nodiscard]] bool kept() const { return speed && speed->ratio <= 1 + allowed; }
};

/// A grade, with all else that is reported with it.
struct Graded {
  Grade grade;
  double seconds;
  std::string promised = {};       ///< the allowed error in words; empty if it is fast's promise
  std::optional<double> own = {};  ///< the value at the worst point; nothing where there is none
  std::string seed = {};           ///< seed of its points
  std::vector<std::string> remarks = {};
  std::optional<BaselineComparison> against_baseline = {};
  bool is_kernel = false;  ///< the members below are for kernels only
  std::vector<Fault> faults = {};
  std::optional<Speed> to_fast = {};  ///< nothing if the kernel fails
  std::optional<Slowdown> to_older = {};

  [[nodiscard]] bool kept() const;
};

std::string graded_text(const Graded& graded);
Json graded_json(const Graded& graded);
/// The test suite in the JUnit format, which Jenkins, GitLab and others read.
std::string junit_text(const std::vector<Graded>& all);

/// Sets the error that --promise allows and returns it in words; empty without the option. N or Nulp is in units in the
/// last place, Nabs in the quantity's unit, Nrel a part of the scale. So is N < 1/2: rounding errs by half a unit.
std::string take_promise(const CommandLine& line, AuditOptions& options);

/// Appends the worst point of a grade, with the reference's value of 50 digits, to a file like those of data/golden.
/// Makes the file if there is none; does nothing if it has the point. BadInput naming "keep-worst" if the file is about
/// another quantity. OutputError if it cannot be written.
void keep_worst(const std::string& path, const Graded& graded);

}  // namespace nipref::verify
