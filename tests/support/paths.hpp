#pragma once
#include <string>

/// Paths that the tests need and that only the build knows.

std::string source_directory();
std::string seeds_directory();
std::string program();
/// A shared object of tests/verify/grade/plugins.
std::string plugin_file(const std::string& name);
