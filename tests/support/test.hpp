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

/// Equal to numbers within a part `relative` of the larger of both.
inline doctest::Approx approx(double value, double relative) {
  return doctest::Approx(value).scale(0).epsilon(relative);
}

/// Whether .ci/thorough asks for the whole of sweeps of which a part stands for all else.
inline bool is_thorough() { return std::getenv("NIPREF_THOROUGH") != nullptr; }
