#pragma once
#include <gmpxx.h>

#include <nipref/data/problem/nip.hpp>
#include <nipref/fast/number/estimate.hpp>
#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

// Common parts of the entries about nips. The sheet has the thickness 1 and the instantaneous Young's modulus 1. The
// radius of the rollers is no shorter than any contact; all results are proportional to 1/R.

inline constexpr double nip_roller_radius = 1024;
inline constexpr double shortest_nip = 1e-8, longest_nip = 1e3;  ///< L/B

/// Numbers of a contact in the order of their entries.
using NipEstimates = std::vector<fast::Estimate>;
using NipReferences = std::vector<ref::Estimate>;

/// Throws BadInput unless L/B is within these limits.
void check_nip_length(double L_over_B);

/// The accuracy that fast is asked for in a contact.
double nip_accuracy(fast::Accuracy accuracy);

/// The number in another unit. The factor is exact or rounded; a proven bound stays proven.
ref::Estimate in_unit(ref::Estimate number, const mpq_class& factor);
fast::Estimate in_unit(const fast::Estimate& number, double factor);

/// Solves contacts of one kind by either path: all numbers together, in the order of their entries.
struct NipSolver {
  std::function<NipEstimates(const NamedPoint& x, fast::Accuracy accuracy)> fast;
  std::function<NipReferences(const NamedPoint& x, int digits)> ref;
};

/// The quantities of a family in the order of the table, without sampling. They share the cached solution at a point.
std::vector<Quantity> nip_entries(std::string_view family, const NipSolver& solver);

/// Estimates of the seconds that the reference takes for the converged contact of that length on one core of a server
/// of 2022, from the number of unknowns, right to a factor of about two. They throw BadInput where the reference does.
[[nodiscard]] double likely_seconds(const data::ElasticNip& nip, data::Friction friction, double length,
                                    int digits, int most_terms = ref::most_proof_terms);
[[nodiscard]] double likely_seconds(const data::ViscoelasticNip& nip, double length, int digits);

/// Seconds beyond which the catalogue refuses a contact and `solve` warns; and the terms of a proof that takes so long.
inline constexpr double long_time = 10;
inline constexpr int terms_in_long_time = 750;

/// The largest number of digits, from 16 to 50, that the reference computes in reasonable time; 0 if there is none.
/// `seconds` may throw BadInput for digits that the reference refuses.
int most_digits_in_time(const std::function<double(int digits)>& seconds);

}  // namespace nipref::verify
