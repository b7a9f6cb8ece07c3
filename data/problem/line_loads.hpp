#pragma once
#include <optional>

namespace nipref::data {

/// The thesis's line loads at the centres of equal elements of a viscoelastic nip, which has no symmetry: all of them started
/// at once at a distance before the nip. (thesis 2.2, 7.1-7.17) Each solver says which it takes.
struct ViscoelasticLineLoads {
  int leading_elements;  ///< m1, on the entry side; method.leading_elements
  /// m2, on the exit side; method.trailing_elements. Absent: from m1 down the first that leaves no tension under the load
  /// (section 2.5), which needs a given load.
  std::optional<int> trailing_elements;
  /// C_L, how far before the nip the loads started, > 0, half-thicknesses; method.approach_lengths
  double approach_lengths;
  /// 0: exact kernels; else as many terms of their series, 1 to 500; method.residue_terms
  int residue_terms = 0;
  /// Of theta1 + theta2 at once, 0 to 1: the sum after a load has passed ends with its first term below it.
  double smallest_term = 0;
};

}  // namespace nipref::data
