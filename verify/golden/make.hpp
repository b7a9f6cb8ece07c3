#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <nipref/verify/golden/golden.hpp>

namespace nipref::verify {

/// What golden values are made with; stands in their header.
struct Provenance {
  std::string nipref, compiler, mpfr;
  std::string commit;  ///< full hash; "unknown"
  bool clean;          ///< nothing differed from the commit
};

/// Whether a value of many digits takes seconds.
bool is_slow(const Quantity& quantity);

struct GoldenOptions {
  std::size_t points;
  int digits;
  std::string seed = "1";  ///< any text, from which the points are drawn
  /// Called now and then with the part done, 0 to 1; may be empty.
  std::function<void(double part)> progress = {};
};

/// 50 digits at 250 points; 30 digits at 200 where values are slow; 21 digits at 30 where several quantities come out
/// of one solution that takes seconds.
inline GoldenOptions golden_options(const Quantity& quantity) {
  if (!quantity.family.empty()) return {30, 21};
  return is_slow(quantity) ? GoldenOptions{200, 30} : GoldenOptions{250, 50};
}

/// A point whose value was not taken.
struct RefusedRow {
  Point arguments;
  std::string reason;
};

struct MadeGolden {
  GoldenFile file;
  std::vector<RefusedRow> refused;  ///< that no second method confirms
};

/// Golden values of a quantity: hard cases, zeros and their neighbours, the points at which fast was found worst by an
/// audit, and points spread over the whole domain. Each has been confirmed by a second method: their distance is at
/// most the sum of bound and the method's own error, and that is small beside a double's last place. Points that the
/// reference does not take are left out, and of points where the value is nothing but 0 no more than a twentieth are
/// kept. Deterministic, whatever the number of threads. BadInput if the quantity has no second method. Throws
/// Interrupted if the process is.
MadeGolden make_golden(const Quantity& quantity, const GoldenOptions& options, const Provenance& provenance);

/// The row confirmed: confirmed_by is set, or the reason why it is not is given back.
std::string confirm_row(const Quantity& quantity, GoldenRow& row);

}  // namespace nipref::verify
