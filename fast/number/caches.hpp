#pragma once

namespace nipref::fast {

/// Forgets everything that this room has computed and kept for later calls. Values stay the same to the last
/// bit, only the next call takes the time of a first one. Thread-safe.
void clear_caches();

}  // namespace nipref::fast
