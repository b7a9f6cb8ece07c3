#pragma once
#include <cctype>

#include "support/test.hpp"

/// The text with one space for each gap, as it reads without line breaks.
inline std::string unfolded(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char letter) { return std::isspace(letter) != 0; }, ' ');
  const auto rest = std::ranges::unique(text, [](char a, char b) { return a == ' ' && b == ' '; });
  text.erase(rest.begin(), rest.end());
  return text;
}
