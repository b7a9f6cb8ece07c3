#pragma once
#include <functional>

#include <nipref/ref/number/estimate.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// An estimate whose error is a proven bound: |value - truth| <= error, and error <= 10^-digits min(1, |truth|). If the
/// truth is exactly 0, value and error are 0. Only code that proves the bound constructs an Enclosure.
struct Enclosure : Estimate {
  Enclosure(Float the_value, Float bound, int the_digits);
};

/// BadInput naming "digits" unless 16 <= digits <= 1000.
void check_digits(int digits);

/// The exact number 0, and a rational number; BadInput for digits out of range.
Enclosure exact_zero(int digits);
Enclosure exactly(const mpq_class& value, int digits);

/// The interval from value - error to value + error, rounded outwards.
Interval interval_of(const Estimate& number);

/// The middle of an interval with its half-width as the error. The caller ensures that the half-width is at most
/// 10^-digits min(1, |truth|).
Enclosure enclosure_of(const Interval& interval, int digits);

/// Encloses a quantity to the accuracy that Enclosure promises. `interval_at(nats)` returns an interval that contains
/// the quantity and has a half-width of about e^{-nats}. `first_nats` is a guess at -ln|truth|, 0 where the truth is of
/// order 1. Where the value turns out smaller, as near a zero, it is evaluated once more with the missing nats added.
/// BadInput for digits out of range. BadInput naming "arguments" if 30000 more nats do not distinguish the value from
/// 0, or if the value is above e^{30000}.
Enclosure enclose(int digits, double first_nats, const std::function<Interval(double nats)>& interval_at);

}  // namespace nipref::ref
