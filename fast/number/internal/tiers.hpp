#pragma once

// The degrees of truncated series for each tolerance. The argument of every series is bounded by construction, so the
// degree n that a tolerance needs is known beforehand. The truncation errors, relative to the scale of accuracy.hpp, are:
//
// - polynomial of a piece, |z_1| t <= 2.388/64 = 0.0373: 0.0373^(n+1)/(n+1)!, up to ten times that near
//   x = 1/2 and 1: 6e-10, 4e-12, 2e-14 for n = 4 ... 6; n = 7 is economised to 1e-18
// - cubic of the coarse tiers, width 1/32 everywhere, economised: 2e-7; its first three terms: 3e-5
// - ln(1 + r) in one of 128 cells, |r| <= 1/256: 2.5 * 2^(-8(n+1))/(n+1), the smallest scale there being 0.4
// - ln(1 + r) in one of 16 cells, |r| <= 1/32: 2.5 * 2^(-5(n+1))/(n+1)
// - even remainder in x^2 <= 1/4, nearest singularity -4, economised: 20 * 66^(-n-1)
// - decay of the residue in one of 32 cells, y <= ln 2/64 = 0.0109: y^(n+1)/(n+1)!
// - phase of the residue in one of 64 cells, b <= pi/64 = 0.0491: b^(n+2)/(n+2)! for the even and for the odd part

namespace nipref::fast::internal {

/// The work behind one tolerance: degrees of the truncated series.
struct Tier {
  double error;      ///< promised error relative to the scale
  bool coarse;       ///< whether one table of cubics serves for both the logarithm and the pieces
  int piece;         ///< local polynomial of a piece
  int log1p;         ///< ln(1 + r) inside one of 128 cells of the logarithm; 0: only the 16 cells are used
  int short_log1p;   ///< ln(1 + r) inside one of 16 cells of the logarithm
  int even;          ///< even remainder, as a polynomial in x^2
  int exponential;   ///< decay of the residue
  int sine;          ///< phase of the residue, odd part
  int cosine;        ///< phase of the residue, even part
  bool compensated;  ///< carry low words: in tables and in products of the argument with constants
};

inline constexpr int tier_count = 5;
inline constexpr int full_tier = tier_count - 1;
inline constexpr int piece_degree = 7;
inline constexpr int even_degree = 10;
inline constexpr int coarse_degree = 3;

inline constexpr Tier tier_works[tier_count] = {
    {1e-3, true, 2, 0, 0, 2, 1, 1, 2, false},
    {5e-7, true, coarse_degree, 0, 0, 4, 2, 3, 4, false},
    {1e-9, false, 4, 0, 6, 5, 3, 5, 4, false},
    {5e-13, false, 6, 0, 8, 7, 5, 7, 6, true},
    {0x1p-51, false, piece_degree, 6, 10, even_degree, 6, 7, 8, true},
};

/// The cheapest tier whose promised error is at most rtol, or the full tier if there is none.
constexpr int cheapest_tier(double rtol) {
  for (int tier = 0; tier < full_tier; ++tier) {
    if (tier_works[tier].error <= rtol) return tier;
  }
  return full_tier;
}

}  // namespace nipref::fast::internal
