#pragma once
#include <nipref/data/directory.hpp>

#include "support/scratch_folder.hpp"
#include "support/test.hpp"

/// A data folder of its own with an empty folder of golden values, which the program and this process take for theirs
/// while it lives.
class GoldenFolder {
 public:
  GoldenFolder() {
    std::filesystem::create_directory_symlink(nipref::data::tables_directory(), top_.file("tables"));
    std::filesystem::create_directory(path());
    setenv("NIPREF_DATA", top_.path().c_str(), 1);
  }
  GoldenFolder(const GoldenFolder&) = delete;
  GoldenFolder& operator=(const GoldenFolder&) = delete;
  ~GoldenFolder() { unsetenv("NIPREF_DATA"); }

  [[nodiscard]] std::filesystem::path path() const { return top_.file("golden"); }
  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return path() / name; }

 private:
  ScratchFolder top_;
};
