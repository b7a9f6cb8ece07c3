#pragma once

namespace nipref::fast {

/// Empties all caches of this room. Later values are the same to the last bit, but the next call takes the time of a
/// first one. Thread-safe.
void clear_caches();

}  // namespace nipref::fast
