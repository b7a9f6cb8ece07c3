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

inline constexpr int tier_count = 5;
inline constexpr int full_tier = tier_count - 1;
inline constexpr int piece_degree = 7;
inline constexpr int even_degree = 10;
inline constexpr int coarse_degree = 3;

/// The work behind each tolerance: degrees of the truncated series. Each array has an entry for each tier.
struct TierWork {
  static constexpr double error[]{1e-3, 5e-7, 1e-9, 5e-13, 0x1p-51};  ///< promised, relative to the scale
  /// Whether one table of cubics serves for both the logarithm and the pieces.
  static constexpr bool coarse[]{true, true, false, false, false};
  static constexpr int piece[]{2, coarse_degree, 4, 6, piece_degree};  ///< local polynomial of a piece
  static constexpr int log1p[]{0, 0, 0, 0, 6};  ///< ln(1 + r) inside one of 128 cells; 0: the 16 cells serve
  static constexpr int short_log1p[]{0, 0, 6, 8, 10};    ///< ln(1 + r) inside one of 16 cells
  static constexpr int even[]{2, 4, 5, 7, even_degree};  ///< even remainder, as a polynomial in x^2
  static constexpr int exponential[]{1, 2, 3, 5, 6};     ///< decay of the residue
  static constexpr int sine[]{1, 3, 5, 7, 7};            ///< phase of the residue, odd part
  static constexpr int cosine[]{2, 4, 4, 6, 8};          ///< phase of the residue, even part
  /// Whether low words are carried, in tables and in products of the argument with constants.
  static constexpr bool compensated[]{false, false, false, true, true};
};

/// The cheapest tier whose promised error is at most rtol, or the full tier if there is none.
constexpr int cheapest_tier(double rtol) {
  for (int tier = 0; tier < full_tier; ++tier) {
    if (TierWork::error[tier] <= rtol) return tier;
  }
  return full_tier;
}

}  // namespace nipref::fast::internal
