#include <filesystem>
#include <fstream>
#include <iostream>

#include <nipref/verify/cli/verbs.hpp>

/// Writes the manual's page and the shells' completions into a folder; run by the build alone.
int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: nipref_manual FOLDER\n";
    return 2;
  }
  const auto write = [&](const std::string& name, const std::string& text) {
    std::ofstream file(std::filesystem::path(argv[1]) / name);
    file << text;
    file.close();
    return static_cast<bool>(file);
  };
  bool all_written = write("nipref.1", nipref::verify::manual_page());
  for (const std::string shell : {"bash", "zsh", "fish"})
    all_written = write("nipref." + shell, nipref::verify::completion_for(shell)) && all_written;
  return all_written ? 0 : 1;
}
