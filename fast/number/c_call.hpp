#pragma once

namespace nipref::fast {

/// Calls `body` with `context` for a function that is called from C, which no exception may leave. Returns 0, or for an
/// exception nipref_bad_input or nipref_failed of fast/sheet/c.h; nipref_last_error() is then the exception's message.
int c_call(void (*body)(void* context), void* context) noexcept;

/// The same for any callable.
template <class Body>
int c_call(Body body) noexcept {
  return c_call([](void* context) { (*static_cast<Body*>(context))(); }, &body);
}

}  // namespace nipref::fast
