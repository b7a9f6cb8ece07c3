#pragma once
#include <memory>

#include <nipref/data/problem/friction.hpp>
#include <nipref/fast/elastic_nip/internal/half_contact.hpp>
#include <nipref/fast/nip/internal/counted_kernels.hpp>

namespace nipref::fast {

/// How a half contact is cut and resolved.
struct PanelLayout {
  int panels;        ///< [0, A 2^(1-panels)], then doubling towards the middle
  int terms;         ///< Chebyshev terms on each panel
  double tolerance;  ///< of the quadrature
};

/// Contact of any half length A (half-thicknesses), with or without friction, both tractions bounded at the
/// ends.
///
/// On each panel P + iQ is a Chebyshev polynomial with complex coefficients, on the end panel times
/// e^(1/2 - i epsilon): with full friction the sign terms of the coupling give this exponent at the end,
/// epsilon = atanh(theta2/N)/pi = ln(3 - 4 poisson)/(2 pi), so that the oscillation is resolved and not only
/// bounded. Matching at Chebyshev points, one more on the end panel than there are terms, for the edge
/// displacement and the creep are unknowns too. `poisson` is used with friction only.
/// (thesis 2.2, 2.5, 5.3, 5.5; continuous form)
std::unique_ptr<HalfContact> panel_contact(double half_length, data::Friction friction, double poisson,
                                           const PanelLayout& layout, CountedKernels& kernels);

}  // namespace nipref::fast
