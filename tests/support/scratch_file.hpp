#pragma once
#include <unistd.h>

#include "support/test.hpp"

/// A file in the temporary folder, gone at the end of the test.
class ScratchFile {
 public:
  explicit ScratchFile(const std::string& text = "") {
    std::string pattern = (std::filesystem::temp_directory_path() / "nipref-test-XXXXXX").string();
    const int descriptor = mkstemp(pattern.data());
    REQUIRE(descriptor >= 0);
    close(descriptor);
    path_ = pattern;
    std::ofstream(path_, std::ios::binary) << text;
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile() { std::filesystem::remove(path_); }

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::string text() const {
    std::ostringstream text;
    text << std::ifstream(path_).rdbuf();
    return text.str();
  }

 private:
  std::string path_;
};
