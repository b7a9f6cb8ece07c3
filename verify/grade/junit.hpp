#pragma once
#include <string>
#include <vector>

namespace nipref::verify {

/// One thing that was tested, as continuous integration shows it.
struct JUnitCase {
  enum class Outcome { passed, failed, error };
  std::string name;
  double seconds;
  Outcome outcome;
  std::string message;  ///< one line, unless it passed
  std::string details;  ///< all about it
};

/// The file that Jenkins, GitLab and others read: one test suite.
std::string junit_text(const std::string& suite, const std::vector<JUnitCase>& cases);

}  // namespace nipref::verify
