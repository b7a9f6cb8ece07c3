#pragma once
#include <vector>

#include <nipref/verify/support/json.hpp>

// The finite-element program CalculiX gets the shape of the surface under four converged contacts of the thesis's
// sheets. It computes the load, the free surface beside the contact and, without friction, the slip in the contact,
// which are compared with the solver's. A relative error of 1e-5 of the indentation, or of 1e-3 of the length or the
// creep, to which the load is insensitive, exceeds at least one of the limits.

namespace nipref::verify {

/// The differences between the program and the solver.
struct Witnessed {
  double thickness;   ///< of the sheet, inches
  bool gripped;       ///< full friction, otherwise none
  double load;        ///< relative
  double normal;      ///< over the indentation, under the contact and as far again beside it
  double tangential;  ///< over the largest tangential displacement there

  // The limits are the errors of the mesh: these become up to eight times larger with elements that grow by 1.3
  // instead of 1.15, and up to four times smaller with half the largest element.
  static constexpr double load_limit = 3e-6, normal_limit = 1e-5, tangential_limit = 1e-4;
  [[nodiscard]] bool agrees() const;
};

struct Witness {
  bool installed = false;
  std::vector<Witnessed> contacts;  ///< empty if the program is not installed

  [[nodiscard]] bool agrees() const;  ///< in all contacts
};

/// Makes the comparison, which takes some seconds. Throws std::runtime_error if the program fails.
Witness outside_witness();

/// Null if the program is not installed.
Json witness_json(const Witness& witness);

}  // namespace nipref::verify
