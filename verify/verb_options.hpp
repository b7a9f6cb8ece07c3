#pragma once
#include <cstddef>
#include <vector>

#include "fast/accuracy.hpp"
#include "verify/command_line.hpp"
#include "verify/quantity.hpp"

namespace nipref::verify {

// Options that several verbs read. Each gives the default if the option is not there, and BadInput naming it
// if it is wrong.

fast::Accuracy accuracy_option(const CommandLine& line);
std::size_t points_option(const CommandLine& line, std::size_t otherwise);

/// What of the catalogue and of the contacts the words name: all of both if there are none; the word
/// "contact" stands for the contacts. BadInput for words that are neither.
struct Selection {
  std::vector<const Quantity*> quantities;
  bool contacts;
};
Selection selection(const CommandLine& line);

}  // namespace nipref::verify
