#pragma once
#include <gmpxx.h>

#include <numbers>

#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

/// The rational number as an Enclosure.
inline Enclosure known_number(const mpq_class& value, int digits) {
  if (value == 0) return exact_zero(digits);
  return enclose(digits, 0, [&](double nats) {
    return Interval(Exact(value), static_cast<mpfr_prec_t>(64 + nats / std::numbers::ln2));
  });
}

}  // namespace nipref::ref
