#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/golden/golden.hpp>
#include <nipref/verify/support/on_progress.hpp>

namespace nipref::verify {

/// The program that computed golden values, as written in their header.
struct Provenance {
  std::string nipref, compiler, mpfr;
  std::string commit;  ///< the full hash, or "unknown"
  bool clean;          ///< whether no file differed from the commit
};

/// Adds the entries nipref, compiler, mpfr, commit and tree.
void add_provenance(GoldenHeader& header, const Provenance& provenance);

/// Whether the reference takes seconds for a value of many digits.
bool is_slow(const Quantity& quantity);

struct GoldenOptions {
  std::size_t points;
  int digits;
  std::string seed = "1";  ///< seed of the random points; any text
  OnProgress progress = {};
};

/// 50 digits at 250 points; for a slow quantity 30 digits at 200 points.
inline GoldenOptions golden_options(const Quantity& quantity) {
  return is_slow(quantity) ? GoldenOptions{200, 30} : GoldenOptions{250, 50};
}

/// A point or a contact without golden values.
struct RefusedRow {
  Assignments arguments;  ///< arguments or keys, as the golden file writes them
  std::string reason;
};

struct MadeGolden {
  GoldenFile file;
  std::vector<RefusedRow> refused = {};  ///< points or contacts without a confirmed value
};

/// Golden values of a quantity at hard cases, at zeros and their neighbours, at the points where an audit finds the
/// largest errors of fast, and at points spread over the whole domain. A second method confirms each value: the two
/// differ by at most the sum of the bound and the method's own error, and this sum is small against a unit in the last
/// place of a double. Points that the reference refuses are left out, and at most a twentieth of the values are exactly
/// 0. The result does not depend on the number of threads. BadInput if the quantity has no second method. Throws
/// Interrupted if the process is interrupted.
MadeGolden make_golden(const Quantity& quantity, const GoldenOptions& options, const Provenance& provenance);

/// Confirms the row by the second method and sets its confirmed_by. Returns the reason if the method does not confirm
/// it, otherwise an empty text.
std::string confirm_row(const Quantity& quantity, GoldenRow& row);

struct ChangedRow {
  std::size_t row;  ///< counted from 1
  GoldenRow before, after;
  std::string why;
};

/// A golden file after an update. Rows that are refused stay as they are.
struct UpdatedGolden : MadeGolden {
  std::vector<ChangedRow> changed = {};
};

/// Computes all values of the file again. A row changes if the reference's new value contradicts its value, if its
/// status or scale differs, or, with `all`, in any case. A second method confirms each changed row. Throws
/// Interrupted if the process is interrupted.
UpdatedGolden update_golden(const Quantity& quantity, const GoldenFile& file, bool all,
                            const Provenance& provenance, const OnProgress& progress);

}  // namespace nipref::verify
