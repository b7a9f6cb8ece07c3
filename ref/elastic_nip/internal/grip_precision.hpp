#pragma once
#include <cmath>

#include <nipref/ref/elastic_nip/internal/grip_expansion.hpp>
#include <nipref/ref/elastic_nip/internal/proven_expansion.hpp>

namespace nipref::ref {

/// By which the finer of both expansions is better.
inline constexpr int finer_by = 4;

/// A contact without friction of this size has so many terms, of odd order alone.
inline int grip_terms(double half_length, int expansion) { return 2 * size_for(half_length, expansion); }

/// Expansions good to `expansion` digits: their layouts share no point.
inline GripLayout coarse_layout(double half_length, int expansion) {
  const int terms = grip_terms(half_length, expansion);
  return {terms, terms + 2, true};
}
inline GripLayout fine_layout(double half_length, int expansion) {
  const int terms = grip_terms(half_length, expansion + finer_by) + 4;
  return {terms, terms + 8, false};
}

/// How many digits each part of a solution is computed to; see precision_for() of the frictionless contact.
struct GripPrecision {
  int digits, expansion, kernel, working;

  GripPrecision(double half_length, int the_digits, bool for_load)
      : digits(the_digits),
        expansion(digits + (for_load ? 8 : 3) + static_cast<int>(std::ceil(std::log10(1 + half_length)))),
        kernel(expansion + finer_by + 4 +
               static_cast<int>(std::ceil(3 * std::log10(grip_terms(half_length, expansion))))),
        working(kernel + 6) {}
};

}  // namespace nipref::ref
