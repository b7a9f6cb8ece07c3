#pragma once
#include <string>

namespace nipref::verify {

/// What help says of all verbs, as a page for man.
std::string manual_page();

/// What bash needs to complete verbs, their options, and the names of quantities, tables and example scenes.
std::string bash_completion();

}  // namespace nipref::verify
