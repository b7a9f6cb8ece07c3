#pragma once
#include <cstddef>

namespace nipref::ref {

/// Empties all caches of the reference, and MPFR's cache of constants of this thread. Later results are the same to
/// the last bit, but the next call takes as long as a first one. Thread-safe; calls in progress keep the values that
/// they use until they return.
void clear_caches();

/// The size of the caches in bytes, without MPFR's constants.
[[nodiscard]] std::size_t cached_bytes();

}  // namespace nipref::ref
