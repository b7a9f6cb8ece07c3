#pragma once

// The headers of all tests, doctest and the standard library, and functions that check refusals of input.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <nipref/data/bad_input.hpp>

inline bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// The number of times that the part stands in the text.
inline std::size_t times_in(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

inline std::string text_of_file(const std::filesystem::path& file) {
  const std::ifstream stream(file, std::ios::binary);
  REQUIRE(stream);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Equals numbers that differ from `value` by at most the part `relative` of the larger of both.
inline doctest::Approx approx(double value, double relative) {
  return doctest::Approx(value).scale(0).epsilon(relative);
}

inline constexpr double infinite = std::numeric_limits<double>::infinity(),
                        not_a_number = std::numeric_limits<double>::quiet_NaN();

template <class... Values>
doctest::String shown_in_a_row(const Values&... values) {
  doctest::String row;
  ((row += doctest::toString(values) + "  "), ...);
  return row;
}

/// Replaces doctest's CAPTURE by one that takes any number of arguments.
#undef CAPTURE
#define CAPTURE(...) INFO(#__VA_ARGS__ " := ", shown_in_a_row(__VA_ARGS__))

/// Checks that the call throws BadInput and that the message has these words.
#define CHECK_REFUSED(call, words)                                                             \
  CHECK_THROWS_WITH_AS(static_cast<void>(call), doctest::Contains(std::string(words).c_str()), \
                       nipref::data::BadInput)

/// The message with which the call is refused; "accepted" if it is not refused.
template <class Call>
std::string refusal_of(const Call& call) {
  try {
    static_cast<void>(call());
  } catch (const nipref::data::BadInput& error) {
    return error.what();
  }
  return "accepted";
}

/// Whether whole sweeps are requested, as in .ci/thorough, instead of a part of each.
inline bool is_thorough() { return std::getenv("NIPREF_THOROUGH") != nullptr; }
