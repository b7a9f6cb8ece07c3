#pragma once
#include <sys/types.h>

#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

/// A file descriptor. The destructor closes it.
class Descriptor {
 public:
  /// Throws std::system_error if the number is -1, the result of a failed system call.
  explicit Descriptor(int number);
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor();
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

/// A new file in memory, with these flags of open().
int file_in_memory(int flags = 0);

/// Writes the whole text to a descriptor. Returns false, with the reason in errno, if that fails.
bool write_all(int descriptor, std::string_view text);

/// Starts a program, which is searched for as in a shell, with these descriptors as its descriptors 0, 1, ... With
/// `apart` it has a process group of its own, so that Ctrl-C in a terminal interrupts this program only. Throws
/// std::system_error if the program cannot be started.
pid_t started(std::vector<std::string> words, const std::vector<int>& descriptors, bool apart = false);

/// Waits for the end of a process and returns the status that waitpid() gives.
int status_at_end(pid_t process);

struct ProgramOutput {
  int status;  ///< exit status, or -1 if the program did not exit
  std::string text;
};

/// Runs a program and waits for its end. Its standard input is `input`, its standard output is returned, and its standard
/// error is discarded.
ProgramOutput output_of(const std::vector<std::string>& words, std::string_view input = {});

/// The status of a program that does not exist.
inline constexpr int status_not_found = 127;

}  // namespace nipref::verify
