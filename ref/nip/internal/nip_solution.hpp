#pragma once
#include <complex>
#include <vector>

#include <nipref/ref/nip/internal/tractions.hpp>

namespace nipref::ref {

/// What limits how fast the expansions of a contact converge.
struct Resolution {
  /// Of what an end causes in the tractions, e^(-decay e) is left at the distance e, half-thicknesses.
  double decay;
  /// The tractions have exponentials e^(-rate e), too. The first panel at an end has `first`, at most 1, of the width that
  /// it has without them, so that they hardly change on it.
  std::vector<std::complex<double>> rates;
  double first;
};

/// How finely a contact is cut into panels that grow from the end on.
struct Fineness {
  double first;   ///< width of the first one at most, half-thicknesses, but for Resolution::first
  double growth;  ///< where a panel ends over where it begins, as distances from the end
  double nats;    ///< what the expansions leave out is e^-nats
};
std::vector<TractionPanel> panels_of(const Float& half_length, const Resolution& resolution,
                                     const Fineness& fineness);

/// The elastic sheet of a nip.
struct ElasticSheet {
  bool grips;  ///< full friction, otherwise none
  Float beta;  ///< theta2/N

  ElasticSheet(bool the_grips, Float the_beta);
  /// Of the power 1/2 - i epsilon with which the tractions vanish at the ends: atanh(beta)/pi with full friction.
  [[nodiscard]] Float epsilon() const;
  [[nodiscard]] Resolution resolution() const;
};

/// An elastic contact of half length A (half-thicknesses), dimensionless: tractions times 2 R N/b, displacements times
/// 2 R/b^2, the creep times 2 R/b. In the contact u = edge_displacement + e (2A - e), with full friction v = creep y. Both
/// are collocated.
class ElasticSolution {
 public:
  ElasticSolution(const ElasticSheet& sheet, Tractions tractions, SheetKernels& kernels);
  /// How many this program has solved so far: nearly all of the work.
  static long solved();

  [[nodiscard]] const Float& half_length() const { return tractions_.half_length(); }
  [[nodiscard]] const Float& load() const { return load_; }
  /// d ln W/d ln A: dW/dA goes with the square of how the tractions' derivatives grow at the ends.
  [[nodiscard]] Float growth() const;
  /// Load, length, displacement and tractions at places between the ends, over the scales of their kinds; logarithms of the
  /// first two. They differ by what solutions differ by, relative to the scales.
  [[nodiscard]] std::vector<Float> signature() const;
  [[nodiscard]] const Float& edge_displacement() const { return edge_displacement_; }
  [[nodiscard]] Float indentation() const { return edge_displacement_ + half_length() * half_length(); }
  [[nodiscard]] const std::vector<TractionPanel>& panels() const { return tractions_.panels(); }
  [[nodiscard]] int unknowns() const { return tractions_.columns() + (sheet_.grips ? 2 : 1); }

  // At y = A - e, e <= A, outside the contact where e < 0.
  [[nodiscard]] PressureAndShear tractions(const Float& e) const;
  [[nodiscard]] Float normal(const Float& e, SheetKernels& kernels) const;
  [[nodiscard]] Float tangential(const Float& e, SheetKernels& kernels) const;
  [[nodiscard]] Float strain(const Float& e, SheetKernels& kernels) const;
  /// v/y at the end; with full friction anywhere in the contact.
  [[nodiscard]] Float creep(SheetKernels& kernels) const { return tangential(0, kernels) / half_length(); }

 private:
  [[nodiscard]] LineFunctional normal() const;
  [[nodiscard]] LineFunctional tangential() const;
  [[nodiscard]] Float value(const Float& e, const LineFunctional& functional, SheetKernels& kernels) const;

  ElasticSheet sheet_;
  Tractions tractions_;
  Vector coefficients_;
  Float edge_displacement_, creep_, load_;
};

}  // namespace nipref::ref
