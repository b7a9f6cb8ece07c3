#pragma once
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

#include <nipref/ref/number/estimate.hpp>

/// |a - b| of estimates or of proven numbers.
inline double difference(const nipref::ref::Estimate& a, const nipref::ref::Estimate& b) {
  nipref::ref::Float result = nipref::ref::zero_of_bits(400);
  mpfr_sub(nipref::ref::raw(result), nipref::ref::raw(a.value), nipref::ref::raw(b.value), MPFR_RNDN);
  return std::fabs(mpfr_get_d(nipref::ref::raw(result), MPFR_RNDN));
}

/// Whether two numbers differ by no more than the sum of their errors, however small these are.
inline bool meet(const nipref::ref::Estimate& a, const nipref::ref::Estimate& b) {
  nipref::ref::Float apart = nipref::ref::zero_of_bits(64), allowed = nipref::ref::zero_of_bits(64);
  mpfr_sub(nipref::ref::raw(apart), nipref::ref::raw(a.value), nipref::ref::raw(b.value), MPFR_RNDA);
  mpfr_add(nipref::ref::raw(allowed), nipref::ref::raw(a.error), nipref::ref::raw(b.error), MPFR_RNDU);
  return mpfr_cmpabs(nipref::ref::raw(apart), nipref::ref::raw(allowed)) <= 0;
}

/// The error of a number, proven or not.
inline double error(const nipref::ref::Estimate& x) {
  return mpfr_get_d(nipref::ref::raw(x.error), MPFR_RNDU);
}

inline double relative_error(const nipref::ref::Estimate& truth, double value) {
  return std::fabs(truth.error_of(value) / value);
}

/// A number that a test takes by default, or that the environment gives: NIPREF_RANDOM_CONTACTS is the number of random
/// contacts, NIPREF_RANDOM_SEED their seed.
inline int number_from(const char* variable, int always) {
  const char* const asked = std::getenv(variable);
  return asked != nullptr ? std::stoi(asked) : always;
}
inline int random_contacts(int always) { return number_from("NIPREF_RANDOM_CONTACTS", always); }
inline unsigned random_seed(int always) {
  return static_cast<unsigned>(number_from("NIPREF_RANDOM_SEED", always));
}

/// A random number, log-uniform from `low` to `high`.
inline double between(double low, double high, std::mt19937_64& random) {
  return std::exp(std::uniform_real_distribution(std::log(low), std::log(high))(random));
}
