#pragma once

namespace nipref::data {

/// A computed number and its error in the same unit: |value - truth| <= error. Derived classes say whether the error is
/// proven (a bound) or an estimate.
template <class Number, class Error = Number>
struct WithError {
  Number value;
  Error error;
};

}  // namespace nipref::data
