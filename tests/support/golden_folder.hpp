#pragma once
#include <unistd.h>

#include <nipref/data/directory.hpp>

#include "support/test.hpp"

/// A data folder of its own with an empty folder of golden values, which the program and this process take for theirs
/// while it lives.
class GoldenFolder {
 public:
  GoldenFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "nipref-golden-XXXXXX").string();
    REQUIRE(mkdtemp(pattern.data()) != nullptr);
    top_ = pattern;
    std::filesystem::create_directory_symlink(nipref::data::tables_directory(), top_ / "tables");
    std::filesystem::create_directory(top_ / "golden");
    setenv("NIPREF_DATA", top_.c_str(), 1);
  }
  GoldenFolder(const GoldenFolder&) = delete;
  GoldenFolder& operator=(const GoldenFolder&) = delete;
  ~GoldenFolder() {
    unsetenv("NIPREF_DATA");
    std::filesystem::remove_all(top_);
  }

  [[nodiscard]] std::filesystem::path path() const { return top_ / "golden"; }
  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return path() / name; }

 private:
  std::filesystem::path top_;
};
