#pragma once

namespace nipref::data {

/// A computed number and its error in the same unit: |value - truth| <= error. Whether the error is a proven bound or an
/// estimate is said by what derives from this.
template <class Number, class Error = Number>
struct WithError {
  Number value;
  Error error;
};

}  // namespace nipref::data
