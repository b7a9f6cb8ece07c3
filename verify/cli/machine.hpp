#pragma once
#include <string>

namespace nipref::verify {

/// Compiler and kind of build, in words.
std::string build_description();

/// Processor, number of cores, and the instruction set that fast has chosen, in words.
std::string machine_description();

}  // namespace nipref::verify
