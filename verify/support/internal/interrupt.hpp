#pragma once
#include <exception>

namespace nipref::verify {

/// Thrown where work ends unfinished because it was interrupted.
struct Interrupted : std::exception {
  [[nodiscard]] const char* what() const noexcept override { return "interrupted"; }
};

/// From here on the first SIGINT (Ctrl-C) of this process is only noted, for the work to come to its end and
/// so that what was finished is printed; the second one kills. Nothing changes if SIGINT is ignored, as in a
/// shell's background.
void stop_gently_on_interrupt();

/// True once a SIGINT was noted. Loops ask between their items.
bool interrupted();

/// Throws Interrupted if so.
void stop_if_interrupted();

}  // namespace nipref::verify
