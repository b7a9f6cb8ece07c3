#pragma once
#include <nipref/verify/support/internal/interrupt.hpp>

namespace nipref::verify {

/// The last line of a long run's answer for people if the process was interrupted, otherwise nothing.
inline const char* interruption_text() {
  return interrupted() ? "\ninterrupted: above is what was finished by then\n" : "";
}

}  // namespace nipref::verify
