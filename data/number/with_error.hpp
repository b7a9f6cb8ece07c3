#pragma once

namespace nipref::data {

/// A number and its error in the same unit: |value - truth| <= error. The error is a bound where `proven` is true, and an
/// estimate otherwise.
template <class Number, class Error = Number>
struct WithError {
  Number value;
  Error error;
  bool proven = false;
};

}  // namespace nipref::data
