#pragma once
#include <cstddef>

#include "fast/accuracy.hpp"
#include "verify/command_line.hpp"

namespace nipref::verify {

// Options that several verbs read. Each gives the default if the option is not there, and BadInput naming it
// if it is wrong.

fast::Accuracy accuracy_option(const CommandLine& line);
std::size_t points_option(const CommandLine& line, std::size_t otherwise);

}  // namespace nipref::verify
