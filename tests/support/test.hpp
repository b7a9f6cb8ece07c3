#pragma once

// What tests are written with: doctest and the standard library, which are precompiled for all of them, and how input is
// refused.

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

/// How often the part stands in the text.
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

/// Equal to numbers within a part `relative` of the larger of both.
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

/// doctest's, of as many as there are.
#undef CAPTURE
#define CAPTURE(...) INFO(#__VA_ARGS__ " := ", shown_in_a_row(__VA_ARGS__))

/// The call is refused, and these words say why.
#define CHECK_REFUSED(call, words)                                                             \
  CHECK_THROWS_WITH_AS(static_cast<void>(call), doctest::Contains(std::string(words).c_str()), \
                       nipref::data::BadInput)

/// What refuses the call; "accepted" if nothing does.
template <class Call>
std::string refusal_of(const Call& call) {
  try {
    static_cast<void>(call());
  } catch (const nipref::data::BadInput& error) {
    return error.what();
  }
  return "accepted";
}

/// Whether .ci/thorough asks for the whole of sweeps of which a part stands for all else.
inline bool is_thorough() { return std::getenv("NIPREF_THOROUGH") != nullptr; }
