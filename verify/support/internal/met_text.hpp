#pragma once
#include <fmt/format.h>

#include <string>

#include <nipref/verify/support/text.hpp>

namespace nipref::verify {

/// "accuracy 1e-10 is met", or "is missed", in colour. `of`: what the accuracy is relative to, " of the scale".
inline std::string met_text(long double accuracy, bool met, const char* of = "") {
  return verdict(met, fmt::format("accuracy {:g}{} is {}", accuracy, of, met ? "met" : "missed"));
}

}  // namespace nipref::verify
