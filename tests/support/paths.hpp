#pragma once
#include <string>

/// Where the tests find what they test, known to the build alone.

std::string source_directory();
std::string seeds_directory();
std::string program();
/// A shared object of tests/verify/grade/plugins.
std::string plugin_file(const std::string& name);
