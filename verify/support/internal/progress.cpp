#include <fmt/format.h>
#include <unistd.h>

#include <nipref/verify/support/internal/progress.hpp>

namespace nipref::verify {

Progress::Progress() : terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() { show(""); }

void Progress::show(const std::string& text) {
  constexpr auto start_and_wipe = "\r\x1b[K";
  if (terminal_) fmt::print(stderr, "{}{}", start_and_wipe, text);
}

}  // namespace nipref::verify
