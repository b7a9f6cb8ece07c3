#pragma once

// Layout of the numbers behind the field inside the sheet, written at build time by generator/tabulate.hpp.

namespace nipref::fast::internal {

/// From this distance |alpha| on the field is computed from the residue series; nearer, it is the sum of the fields of
/// two half-planes in closed form and a rest that is analytic up to w = +-3i.
inline constexpr double near_load_end = 1.25;
inline constexpr int near_load_terms = 40;  ///< (w/3)^80 < 1e-21 where |w|^2 <= 1 + near_load_end^2
inline constexpr int field_roots = 11;      ///< e^{-(Im z_12 - Im z_1) near_load_end} < 1e-18

/// The functions of w = alpha + i depth that make up the field, see field_functions.hpp.
enum class FieldFunction { I4, K5, I5, I7, I5_slope, I7_slope };
inline constexpr int field_functions = 6;

struct FieldTable {
  /// The rest at w is sum_k rest[f][k] w^2k, times w if the function is odd.
  double rest[field_functions][near_load_terms];
  double amplitude[field_roots][field_functions][2];  ///< a in Re(a e^{i z_n w}), w real
};

extern const FieldTable field_table;

}  // namespace nipref::fast::internal
