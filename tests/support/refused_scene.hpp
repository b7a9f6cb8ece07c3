#pragma once
#include <string>

#include "support/run_nipref.hpp"
#include "support/scratch_file.hpp"

/// `nipref solve` of this text is refused and says `says`.
inline void check_refused(const std::string& text, const std::string& says, const std::string& flags = "") {
  const ScratchFile file(text);
  check_call_refused("solve " + file.path() + flags, says);
}
