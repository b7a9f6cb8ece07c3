#pragma once
#include <doctest/doctest.h>

#include <string>

#include "support/run_nipref.hpp"
#include "support/scratch_file.hpp"

/// `nipref solve` of this text: status 2, nothing on standard output, one line on standard error that says
/// `says`.
inline void check_refused(const std::string& text, const std::string& says, const std::string& flags = "") {
  const ScratchFile file(text);
  const Outcome outcome = run("solve " + file.path() + flags);
  CAPTURE(outcome.err);
  CAPTURE(says);
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.find(says) != std::string::npos);
  CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
}
