#pragma once

namespace nipref::fast {

/// Calls `body` with `context`, for functions that are called from C: no exception leaves it. 0, or nipref_bad_input
/// or nipref_failed of fast/sheet/c.h, and then nipref_last_error() is what the exception says.
int c_call(void (*body)(void* context), void* context) noexcept;

/// The same of a callable.
template <class Body>
int c_call(Body body) noexcept {
  return c_call([](void* context) { (*static_cast<Body*>(context))(); }, &body);
}

}  // namespace nipref::fast
