#pragma once
#include <fmt/format.h>

#include <string>

#include <nipref/verify/support/text.hpp>

namespace nipref::verify {

/// "accuracy 1e-10 is met", or "is missed", in colour.
inline std::string met_text(long double accuracy, bool met) {
  return verdict(met, fmt::format("accuracy {:g} is {}", accuracy, met ? "met" : "missed"));
}

}  // namespace nipref::verify
