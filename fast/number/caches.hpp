#pragma once

namespace nipref::fast {

/// Empties all caches of `fast`. Later results are the same to the last bit, but the next call takes as long as a first
/// call. Thread-safe.
void clear_caches();

}  // namespace nipref::fast
