#pragma once

namespace nipref::fast {

/// A computed number and an estimate of its error in the same unit: |value - truth| <= error is expected, not
/// proven.
struct Estimate {
  double value;
  double error;
};

}  // namespace nipref::fast
