#pragma once

namespace nipref::fast {

/// Calls `body` with `context`. It is for functions that are called from C, which no exception may leave. Returns 0, or
/// nipref_bad_input or nipref_failed (fast/sheet/c.h) after an exception; nipref_last_error() is then its message.
int c_call(void (*body)(void* context), void* context) noexcept;

/// Calls any callable likewise.
template <class Body>
int c_call(Body body) noexcept {
  return c_call([](void* context) { (*static_cast<Body*>(context))(); }, &body);
}

}  // namespace nipref::fast
