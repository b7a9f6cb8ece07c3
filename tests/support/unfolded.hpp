#pragma once
#include <regex>
#include <string>

/// A text with one space for each gap, as it would read without its line breaks.
inline std::string unfolded(const std::string& text) {
  return std::regex_replace(text, std::regex("\\s+"), " ");
}
