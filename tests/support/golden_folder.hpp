#pragma once
#include <nipref/data/directory.hpp>

#include "support/scratch.hpp"

/// A temporary data folder with an empty folder of golden values. While the object lives, the program and this process
/// take it for theirs.
class GoldenFolder {
 public:
  [[nodiscard]] std::filesystem::path path() const { return top_.file("golden"); }
  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return path() / name; }

 private:
  [[nodiscard]] std::string with_tables() const {
    std::filesystem::create_directory_symlink(nipref::data::tables_directory(), top_.file("tables"));
    std::filesystem::create_directory(path());
    return top_.path();
  }

  ScratchFolder top_;
  Environment data_{"NIPREF_DATA", with_tables()};
};
