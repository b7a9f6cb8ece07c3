#pragma once
#include <exception>

namespace nipref::verify {

/// Thrown by work that the user interrupted before it was finished.
struct Interrupted : std::exception {
  [[nodiscard]] const char* what() const noexcept override { return "interrupted"; }
};

/// From this call on, the first SIGINT (Ctrl-C) only sets a flag, so that the work can end early and print finished
/// results; the second kills the process. If SIGINT is ignored, as for a shell's background jobs, it stays ignored.
void stop_gently_on_interrupt();

/// True after a SIGINT. Loops call this between their items.
bool interrupted();

/// Throws Interrupted after a SIGINT.
void stop_if_interrupted();

}  // namespace nipref::verify
