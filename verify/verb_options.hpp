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

/// What the words name: quantities of the catalogue, "contact" the elastic contacts, "rolling" the
/// viscoelastic ones; all of it if there are none. BadInput for other words.
struct Selection {
  std::vector<const Quantity*> quantities;
  bool contacts;
  bool rolling;
};
Selection selection(const CommandLine& line);

}  // namespace nipref::verify
