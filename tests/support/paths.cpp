#include "support/paths.hpp"

std::string source_directory() { return NIPREF_SOURCE_DIR; }
std::string seeds_directory() { return NIPREF_SEEDS_DIR; }
std::string program() { return NIPREF_EXECUTABLE; }
std::string plugin_file(const std::string& name) { return NIPREF_PLUGINS_DIR "/" + name + ".so"; }
