#pragma once
#include <cstddef>

namespace nipref::ref {

/// Forgets everything that this room has computed and kept for later calls, and MPFR's constants of this
/// thread. Values stay the same to the last bit, only the next call takes the time of a first one.
/// Thread-safe; calls in progress keep what they use until they return.
void clear_caches();

/// What is kept at present, in bytes, MPFR's constants apart.
[[nodiscard]] std::size_t cached_bytes();

}  // namespace nipref::ref
