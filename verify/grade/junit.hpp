#pragma once
#include <string>
#include <vector>

namespace nipref::verify {

/// A test case, as continuous integration shows it.
struct JUnitCase {
  enum class Outcome { passed, failed, error };
  std::string name;
  double seconds;
  Outcome outcome;
  std::string message;  ///< one line, empty if it passed
  std::string details;  ///< the full text
};

/// A test suite in the JUnit format, which Jenkins, GitLab and others read.
std::string junit_text(const std::string& suite, const std::vector<JUnitCase>& cases);

}  // namespace nipref::verify
