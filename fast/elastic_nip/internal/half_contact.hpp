#pragma once
#include <memory>
#include <vector>

namespace nipref::fast {

/// Pressure and shear at one point, dimensionless as in HalfContact.
struct Traction {
  double pressure;
  double shear;
};

/// One half of a solved symmetric contact, dimensionless: lengths in half-thicknesses b, e the distance from
/// the end of the contact towards its middle, tractions times 2 R N/b, normal displacements times 2 R/b^2,
/// creep times 2 R/b. The surface follows  u = edge_displacement + 2 A e - e^2, A the half length, and with
/// full friction v = creep (A - e).
struct HalfContact {
  double half_length = 0;        ///< A = L/B
  double edge_displacement = 0;  ///< at e = 0
  double creep = 0;              ///< 0 without friction, where it is no part of the solution
  double load = 0;               ///< of the whole contact: twice the integral of the pressure over the half
  double tail = 0;               ///< largest tail of the expansions, see expansion_tail.hpp
  std::vector<double> breaks;    ///< 0 = e_0 < ... < A: between them the tractions are analytic
  /// Solutions of the same half length with other roundings: see SolutionAndTwins.
  std::vector<std::unique_ptr<HalfContact>> twins;

  HalfContact() = default;
  HalfContact(const HalfContact&) = delete;
  HalfContact& operator=(const HalfContact&) = delete;
  virtual ~HalfContact() = default;
  /// At 0 <= e <= A.
  [[nodiscard]] virtual Traction traction(double e) const = 0;
  /// The tail of the expansion at e. It is 0 if there is only one expansion: it matters where some converge more slowly
  /// than others.
  [[nodiscard]] virtual Traction tail_at(double) const { return {0, 0}; }
};

}  // namespace nipref::fast
