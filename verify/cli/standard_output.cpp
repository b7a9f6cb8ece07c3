#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdlib>

#include <nipref/verify/cli/output_file.hpp>
#include <nipref/verify/cli/standard_output.hpp>

namespace nipref::verify {
namespace {

[[noreturn]] void fail() { throw OutputError("standard output"); }

/// open() takes the lowest descriptor that is free: this one, as those below are occupied.
void occupy(int descriptor, int mode) {
  if (fcntl(descriptor, F_GETFD) == -1 && errno == EBADF && open("/dev/null", mode) == -1) fail();
}

}  // namespace

void occupy_standard_descriptors() {
  occupy(STDIN_FILENO, O_RDONLY);
  occupy(STDOUT_FILENO, O_RDONLY);  // for writing it is as good as closed
  occupy(STDERR_FILENO, O_WRONLY);
}

bool standard_output_shows_colours() {
  const char* const unwanted = std::getenv("NO_COLOR");
  const char* const terminal = std::getenv("TERM");
  return (unwanted == nullptr || *unwanted == '\0') && terminal != nullptr &&
         std::string_view(terminal) != "dumb" && isatty(STDOUT_FILENO) == 1;
}

void write_to_standard_output(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(STDOUT_FILENO, text.data(), text.size());
    if (written == -1 && errno != EINTR) fail();
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
  // Some file systems tell only now that there was no room.
  if (close(STDOUT_FILENO) == -1 && errno != EINTR) fail();
}

}  // namespace nipref::verify
