#pragma once
#include <exception>

namespace nipref::verify {

/// Thrown where work ends unfinished because it was interrupted.
struct Interrupted : std::exception {
  [[nodiscard]] const char* what() const noexcept override { return "interrupted"; }
};

/// From this call on, the first SIGINT (Ctrl-C) is only noted, so that the work ends early and prints what is finished;
/// the second one kills the process. Nothing changes where SIGINT is ignored, as for a shell's background jobs.
void stop_gently_on_interrupt();

/// True once a SIGINT was noted. Loops ask between their items.
bool interrupted();

/// Throws Interrupted if so.
void stop_if_interrupted();

}  // namespace nipref::verify
