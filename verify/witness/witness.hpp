#pragma once
#include <string>
#include <vector>

#include <nipref/verify/support/json.hpp>

// An outside program, CalculiX, is given the shape under four converged contacts of the thesis's sheets that the solver
// found, and finds the load, the free surface beside the contact and, without friction, the slip under it. An
// indentation off by 1e-5, and a length or creep off by 1e-3, which the load hardly feels, each exceed at least one
// of the limits.

namespace nipref::verify {

/// How far outside program and solver are apart.
struct Witnessed {
  double thickness;   ///< of the sheet, inches
  bool gripped;       ///< full friction, otherwise none
  double load;        ///< relative
  double normal;      ///< of the indentation, under the contact and as far again beside it
  double tangential;  ///< of the largest tangential displacement there

  // The mesh's own errors: elements that grow by 1.3 instead of 1.15 make them up to eight times larger, half the
  // largest element up to four times smaller.
  static constexpr double load_limit = 3e-6, normal_limit = 1e-5, tangential_limit = 1e-4;
  [[nodiscard]] bool agrees() const;
};

struct Witness {
  bool installed = false;
  std::vector<Witnessed> contacts;  ///< none where the program is not installed

  [[nodiscard]] bool agrees() const;  ///< in all contacts
};

/// Some seconds. Throws std::runtime_error where the program fails.
Witness outside_witness();

std::string witness_text(const Witness& witness);
/// Null where the program is not installed.
Json witness_json(const Witness& witness);

}  // namespace nipref::verify
