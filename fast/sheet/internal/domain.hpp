#pragma once

namespace nipref::fast::internal {

/// Where a kernel is defined.
enum class Domain { finite, finite_nonzero };

}  // namespace nipref::fast::internal
