#pragma once
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include <nipref/data/bad_input.hpp>

// What the targets share: libFuzzer's LLVMFuzzerTestOneInput around the reader that each defines.

/// A file in memory with what libFuzzer gives.
class GivenFile {
 public:
  GivenFile(const std::uint8_t* data, std::size_t size) : descriptor_(memfd_create("given", MFD_CLOEXEC)) {
    if (write(descriptor_, data, size) != static_cast<ssize_t>(size)) std::abort();
  }
  GivenFile(const GivenFile&) = delete;
  GivenFile& operator=(const GivenFile&) = delete;
  ~GivenFile() { close(descriptor_); }

  /// For processes that are started too.
  [[nodiscard]] std::string path() const {
    return "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(descriptor_);
  }

 private:
  int descriptor_;
};

/// What is given is taken, or refused with BadInput in one line. Whatever else happens is a finding.
void take_or_refuse(const auto& read) {
  try {
    read();
  } catch (const nipref::data::BadInput& refusal) {
    if (std::string_view(refusal.what()).find('\n') != std::string_view::npos) std::abort();
  }
}

/// Reads what is given, as a text or as a file.
void read_given(const std::string& text, const GivenFile& file);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  read_given(std::string(reinterpret_cast<const char*>(data), size), GivenFile(data, size));
  return 0;
}
