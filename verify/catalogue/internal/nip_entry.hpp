#pragma once
#include <gmpxx.h>

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nipref/fast/number/estimate.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {

// What the entries about nips share. A nip is a sheet of thickness 1 and Young's modulus 1, at once, between rollers so
// large that their radius is no shorter than any contact: everything is as 1/R, so that only shapes are left.

inline constexpr double nip_roller_radius = 1024;
inline constexpr double shortest_nip = 1e-8, longest_nip = 1e3;  ///< L/B

/// Numbers of a contact in the order of their entries.
using NipEstimates = std::vector<fast::Estimate>;
using NipReferences = std::vector<ref::Estimate>;

/// BadInput unless L/B is one that is solved.
void check_nip_length(double L_over_B);

/// fast's accuracy asked of a contact.
double nip_accuracy(fast::Accuracy accuracy);

/// The number in another unit, by a factor known exactly or rounded; a proven bound stays one.
ref::Estimate in_unit(ref::Estimate number, const mpq_class& factor);
fast::Estimate in_unit(const fast::Estimate& number, double factor);

/// One number of a kind of contact.
struct NipNumber {
  std::string_view name;
  std::string_view definition;
  std::string_view scale;
  double promise;  ///< units in the last place of the scale
};

/// How the contacts of a kind are solved: all numbers at once.
struct NipSolver {
  std::function<NipEstimates(std::span<const double> arguments, fast::Accuracy accuracy)> fast;
  std::function<NipReferences(std::span<const double> arguments, int digits)> ref;
};

/// An entry without arguments and where to look; what both paths find at a point is kept for the other entries.
/// `family`: of entries that come out of one solution; `number`: which of the solver's.
Quantity nip_entry(const NipNumber& description, std::string_view source, std::string_view family,
                   const NipSolver& solver, std::size_t number);

/// Log-uniform within [shortest, longest], now and then an end itself.
double draw_nip_length(Random& random, double shortest, double longest);

/// Anywhere, near 1/2, and 0.
double draw_nip_poisson(Random& random);

}  // namespace nipref::verify
