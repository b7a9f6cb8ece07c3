#pragma once
#include <memory>
#include <optional>
#include <vector>

#include <nipref/fast/nip/converged.hpp>
#include <nipref/fast/nip/internal/counted_kernels.hpp>
#include <nipref/fast/nip/internal/domain.hpp>
#include <nipref/fast/nip/internal/panels.hpp>
#include <nipref/fast/nip/internal/solution.hpp>
#include <nipref/fast/sheet/internal/theta_shares.hpp>

namespace nipref::fast {

/// A number that has to meet the accuracy, relative to the larger of `scale` and its own magnitude.
struct AccuracyTarget {
  Functional number;
  double scale = 0;
};

/// A place of the surface: e is its distance from the nearer end of the contact, negative outside.
struct ContactPlace {
  bool trailing;
  double e;

  /// The place in a solution's contact. If it is beyond the middle of that contact, it is on the other half.
  [[nodiscard]] ContactPlace from_nearer_end_of(const Solution& solution) const;
};

enum class TractionComponent { pressure, shear };

/// v at a place of the surface, up to a constant that is 0 in a symmetric contact, and v'. With full friction v' is
/// empty: it is the creep ratio in the contact, and outside it follows from the stress.
struct AlongSurface {
  Functional displacement, strain;
};

/// The equations of one kind of nip, dimensionless: lengths in half-thicknesses b, tractions times 2 R N/b,
/// displacements times 2 R/b^2, loads times 2 R N/b^2, strains times 2 R/b, N the instantaneous compliance of the
/// normal displacement. The functional of a nonlinear number is linearised about the solution and has its value there.
class NipEquations {
 public:
  virtual ~NipEquations() = default;
  /// The resolution of a contact whose coefficients are to fall to e^-nats of the largest.
  [[nodiscard]] virtual Resolution resolution(double nats) const = 0;
  /// `tolerance`: of the quadratures.
  [[nodiscard]] virtual Solution solve(double half_length, const std::vector<Panel>& panels, double tolerance,
                                       CountedKernels& kernels) const = 0;
  /// The numbers that have to meet the accuracy, besides the load and the tractions.
  [[nodiscard]] virtual std::vector<AccuracyTarget> accuracy_targets(const Solution& solution) const = 0;
  /// About the compliance that acts over a contact of this half-length, relative to the instantaneous compliance.
  [[nodiscard]] virtual double softening_over(double /*half_length*/) const { return 1; }
  /// The half-length of the contact of a load, to some per cent, that of a stiff film to a factor of 1.6; and about
  /// d ln load/d ln length at a half-length.
  [[nodiscard]] double half_length_of(double load) const;
  [[nodiscard]] double load_exponent_at(double half_length) const;
  /// BadInput for a half-length at which the contact cannot be solved.
  virtual void check(double /*half_length*/) const {}

  /// Whether the surface sticks, so that the shear is unknown, too.
  [[nodiscard]] virtual bool sticks() const { return false; }
  /// The number of the unknown that is the place of the contact's middle; a contact without it is symmetric.
  [[nodiscard]] virtual std::optional<int> offset_unknown() const { return {}; }
  /// A traction, 0 outside the contact.
  [[nodiscard]] Functional traction(const Solution& solution, TractionComponent component,
                                    const ContactPlace& place) const;
  /// The displacement u that the roller imposes, at y in the contact and at an end.
  [[nodiscard]] virtual Functional roller_displacement(const Solution& solution, double y) const = 0;
  [[nodiscard]] virtual Functional end_displacement(const Solution& solution, bool trailing) const = 0;
  /// The distance of the pressure's resultant from the line through the centres, of a contact that is not symmetric:
  /// offset + int y p dy/load.
  [[nodiscard]] Functional eccentricity(const Solution& solution) const;
  /// u at a place; v and v' there; and the creep ratio, the mean of v' over the contact.
  [[nodiscard]] virtual Functional normal_displacement(const Solution& solution, const ContactPlace& place,
                                                       CountedKernels& kernels) const = 0;
  [[nodiscard]] virtual AlongSurface along_surface(const Solution& solution, const ContactPlace& place,
                                                   CountedKernels& kernels) const = 0;
  [[nodiscard]] virtual Functional creep_ratio(const Solution& solution, CountedKernels& kernels) const = 0;
  /// The shares of theta1 and theta2 in N of an elastic sheet; nothing in rolling.
  [[nodiscard]] virtual std::optional<internal::Shares> shares() const { return {}; }
};

/// I1/pi: the normal displacement that the pressure causes in an elastic sheet. `kernels` must outlive it.
Tractions::SplitKernel frictionless_kernel(CountedKernels& kernels);

/// The tolerance of quadratures whose error is to be less than that of rounding.
inline constexpr double quadrature_tolerance = 1e-16;

/// Either the contact length or the load.
struct GivenContact {
  std::optional<double> length = {}, load = {};  ///< L, unit of length; W, force per unit width
};

/// The solved contact of a nip with these equations. `compliance`: the instantaneous N. BadInput for an accuracy, a
/// length or a load outside the domain, and for a load whose contact length is outside it.
ConvergedNip converged_nip(const NipShape& shape, double compliance,
                           std::shared_ptr<const NipEquations> equations, const GivenContact& given,
                           double accuracy);

}  // namespace nipref::fast
