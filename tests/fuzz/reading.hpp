#pragma once
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include <nipref/data/bad_input.hpp>

// Common to all targets: libFuzzer's LLVMFuzzerTestOneInput, which calls the reader that each target defines.

/// A file in memory with the bytes that libFuzzer gives.
class GivenFile {
 public:
  GivenFile(const std::uint8_t* data, std::size_t size) : descriptor_(memfd_create("given", MFD_CLOEXEC)) {
    if (write(descriptor_, data, size) != static_cast<ssize_t>(size)) std::abort();
  }
  GivenFile(const GivenFile&) = delete;
  GivenFile& operator=(const GivenFile&) = delete;
  ~GivenFile() { close(descriptor_); }

  /// A path that processes started from here can open as well.
  [[nodiscard]] std::string path() const {
    return "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(descriptor_);
  }

 private:
  int descriptor_;
};

/// Calls `read`, which must succeed or throw BadInput with a message of one line. Anything else is a finding.
void take_or_refuse(const auto& read) {
  try {
    read();
  } catch (const nipref::data::BadInput& refusal) {
    if (std::string_view(refusal.what()).find('\n') != std::string_view::npos) std::abort();
  }
}

/// Reads the given bytes, as a text or as a file.
void read_given(const std::string& text, const GivenFile& file);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  read_given(std::string(reinterpret_cast<const char*>(data), size), GivenFile(data, size));
  return 0;
}
