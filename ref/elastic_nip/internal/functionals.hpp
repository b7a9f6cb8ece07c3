#pragma once
#include <optional>
#include <vector>

#include <nipref/ref/elastic_nip/internal/proven_expansion.hpp>
#include <nipref/ref/number/interval.hpp>
#include <nipref/ref/sheet/internal/smooth_kernel.hpp>

namespace nipref::ref {

/// A place t >= 0 on the surface, in half lengths of the contact from its middle, by 1 - t: so that the
/// distance from the end is known as well as t.
struct SurfacePoint {
  Interval before_end;
};

/// What follows from a proven expansion, in half-thicknesses b, pressures in b/(2 R N), displacements in
/// b^2/(2R). Intervals contain the truth for each half length of the expansion's.
class ContactFunctionals {
 public:
  ContactFunctionals(ProvenExpansion expansion, SmoothKernel& kernel, double nats);

  [[nodiscard]] const Interval& half_length() const { return expansion_.half_length; }
  [[nodiscard]] const ProvenExpansion& expansion() const { return expansion_; }
  [[nodiscard]] int terms() const { return static_cast<int>(size()); }
  [[nodiscard]] long coupling_values() const { return coupling_values_; }  ///< of I3, taken so far
  [[nodiscard]] Interval load() const;                                     ///< pi A^2 c_0
  [[nodiscard]] Interval pressure(const SurfacePoint& place) const;        ///< 0 outside
  [[nodiscard]] Interval indentation() const;
  /// Towards the middle plane: d0 - A^2 t^2 in the contact.
  [[nodiscard]] Interval normal_displacement(const SurfacePoint& place) const;
  /// Along the surface, away from the middle; beta = theta2/N.
  [[nodiscard]] Interval tangential_displacement(const SurfacePoint& place, const Interval& beta) const;
  /// v's derivative along the surface, in b/(2R), by parts and by the same nodes.
  [[nodiscard]] Interval strain(const SurfacePoint& place, const Interval& beta) const;
  /// Whether the pressure given by the coefficients falls from the middle to the ends, as a proof; then the
  /// largest pressure is that in the middle, to the same error.
  [[nodiscard]] bool falls_outwards() const;

 private:
  [[nodiscard]] Interval coefficient(long m) const;
  [[nodiscard]] long size() const { return static_cast<long>(expansion_.coefficients.size()); }
  [[nodiscard]] Interval normal_by_pressure(const SurfacePoint& place) const;
  [[nodiscard]] Interval tangential_by_pressure(const SurfacePoint& place, const Interval& beta) const;
  [[nodiscard]] Interval pressure_between(const SurfacePoint& place) const;
  /// int k(A (t - s)) p/(2A) ds, |k| <= largest.
  template <class Kernel>
  [[nodiscard]] Interval smooth_integral(const SurfacePoint& place, const Kernel& kernel,
                                         const Interval& largest) const;

  ProvenExpansion expansion_;
  SmoothKernel& kernel_;
  double nats_;
  mutable long coupling_values_ = 0;
  mutable std::optional<Interval> indentation_;
  std::vector<Interval> nodes_;           ///< s_j > 0
  std::vector<Interval> node_pressures_;  ///< sqrt(1 - s_j^2) p(s_j)/(2A)
  std::vector<Interval> node_slopes_;     ///< sum_m mu c_m cos(mu theta_j)
};

}  // namespace nipref::ref
