#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <nipref/ref/number/internal/largest_value.hpp>
#include <nipref/ref/number/interval.hpp>
#include <nipref/ref/sheet/internal/smooth_kernel.hpp>

namespace nipref::ref {

// Bounds of the contacts' systems in Chebyshev's polynomials, (1) and (2) of ref/elastic_nip/README.md.

/// A lower bound, for the wave number x and all larger ones, of x times the symbol of the displacements under the
/// tractions, with full friction of the least eigenvalue of that matrix. beta = theta2/N.
Interval frictionless_stiffness(const Interval& x);
Interval gripped_stiffness(const Interval& x, const Interval& beta);

/// lambda of (1) from such a lower bound, for all half lengths of the interval, in half-thicknesses.
using Stiffness = std::function<Interval(const Interval& x)>;
Interval coercivity(const Interval& half_length, const Stiffness& stiffness);

/// C and tau of (2), as they are chosen for an expansion of a given size.
struct EntryBounds {
  Interval amplitude, rate;

  /// e^{-k tau}
  [[nodiscard]] Interval power(long k) const { return exp(-(k * rate)); }
};
EntryBounds entry_bounds(const Interval& half_length, int size);

/// A bound of the sum of all entries that a rule with N points folds onto one entry; `first` is the least index folded.
Interval folded_entries(const EntryBounds& decay, long points, long first);

/// Bounds of sum m e^{-m rate} over m = first, first + 2, .., and of sum m^2 e^{-m rate} over all m >= first; rate > 0.
Interval tail(const Interval& rate, long first);
Interval square_tail(const Interval& rate, long first);

/// The rounding of A cos(theta_i) -+ A cos(theta_j) changes a value of J by at most so many units of (A + 1).
inline constexpr long argument_units = 64;

/// The size of an expansion that gives about `digits` digits by the bounds above.
int size_for(double half_length, int digits);

/// A place on the surface, given by its distance from the nearer end over the half length, negative outside the
/// contact. So no accuracy is lost next to an end.
struct SurfacePoint {
  Interval before_end;
  bool is_trailing = false;  ///< which end is nearer
};

/// The pressure of a frictionless contact, p = 2A sum_m c_m sin(m theta) at A cos(theta) from its middle towards the
/// leading side, with bounds of the errors dc_m of all coefficients of the infinite sum, for every A of an interval.
struct ProvenExpansion {
  Interval half_length;                ///< A
  std::vector<Interval> coefficients;  ///< c_0 = 0, c_1 ..
  Interval radius;                     ///< bound of sum_m m |dc_m| over all m
  Interval energy_radius;              ///< bound of sqrt(sum_m m dc_m^2), and so of |dc_1|
  /// Bound of the error of Gauss and Chebyshev's rule, with as many nodes as coefficients, for int k(t, s) p(s)/(2A) ds
  /// where k is J(A (t - s)) or I3(A (t - s)).
  Interval quadrature_error;
};

/// The proven results of a contact: lengths in half-thicknesses b, pressures in b/(2 R N), displacements in b^2/(2R), N
/// at once. The intervals contain the truth; a result is empty if it is not proven.
class ProvenResults {
 public:
  virtual ~ProvenResults() = default;

  [[nodiscard]] virtual const Interval& half_length() const = 0;
  /// Distance of the contact's middle from the line through the rollers' centres, positive towards the leading side.
  [[nodiscard]] virtual const Interval& offset() const = 0;
  [[nodiscard]] virtual Interval edge_displacement() const = 0;  ///< at the leading end
  [[nodiscard]] virtual Interval load() const = 0;
  [[nodiscard]] virtual Interval lever() const = 0;  ///< distance of the resultant from that line
  [[nodiscard]] virtual Interval pressure(const SurfacePoint& place) const = 0;  ///< 0 outside
  [[nodiscard]] virtual Interval shear(const SurfacePoint& place) const = 0;     ///< 0 outside
  /// The displacement towards the middle plane.
  [[nodiscard]] virtual std::optional<Interval> normal(const SurfacePoint& place) const = 0;
  [[nodiscard]] virtual std::optional<Interval> tangential(const SurfacePoint& place) const = 0;  ///< along Y
  /// The derivative of tangential() along the surface, in b/(2R).
  [[nodiscard]] virtual std::optional<Interval> strain(const SurfacePoint& place) const = 0;
  [[nodiscard]] virtual std::optional<Interval> peak_pressure() const = 0;
  [[nodiscard]] virtual std::optional<Interval> peak_pressure_position() const { return {}; }  ///< Y
  [[nodiscard]] virtual std::optional<Interval> peak_shear() const { return {}; }     ///< largest |shear|
  [[nodiscard]] virtual const ProvenExpansion* expansion() const { return nullptr; }  ///< none with friction
  [[nodiscard]] virtual int terms() const = 0;
  [[nodiscard]] virtual KernelValues kernel_values() const = 0;  ///< so far
};

/// The results that follow from a proven expansion without friction, for every half length of its interval.
/// (ref/elastic_nip/README.md, Contacts without friction)
class ProvenContact final : public ProvenResults {
 public:
  /// A contact of a sheet without memory, which is symmetric. beta = theta2/N.
  ProvenContact(ProvenExpansion expansion, const Exact& beta, std::shared_ptr<SmoothKernel> kernel,
                double nats);
  /// A contact of a rolling sheet with a memory, of which less is proven.
  ProvenContact(ProvenExpansion expansion, Interval offset, Interval edge_displacement);

  [[nodiscard]] const Interval& half_length() const override { return expansion_.half_length; }
  [[nodiscard]] const Interval& offset() const override { return offset_; }
  [[nodiscard]] Interval edge_displacement() const override;
  [[nodiscard]] Interval load() const override;  ///< pi A^2 c_1
  [[nodiscard]] Interval lever() const override;
  [[nodiscard]] Interval pressure(const SurfacePoint& place) const override;
  [[nodiscard]] Interval shear(const SurfacePoint& /*place*/) const override {
    return Interval(offset_.precision());
  }
  /// With a memory, proven only in the contact.
  [[nodiscard]] std::optional<Interval> normal(const SurfacePoint& place) const override;
  /// Proven only without memory.
  [[nodiscard]] std::optional<Interval> tangential(const SurfacePoint& place) const override;
  /// Integrated by parts, with the same nodes. Proven only without memory.
  [[nodiscard]] std::optional<Interval> strain(const SurfacePoint& place) const override;
  [[nodiscard]] std::optional<Interval> peak_pressure() const override;
  [[nodiscard]] std::optional<Interval> peak_pressure_position() const override;
  /// Whether length, offset, lever, load, displacement at the end and pressure have `digits` digits of their scales.
  [[nodiscard]] bool is_good_to(int digits) const;

  [[nodiscard]] const ProvenExpansion* expansion() const override { return &expansion_; }
  [[nodiscard]] int terms() const override { return static_cast<int>(size()); }
  [[nodiscard]] KernelValues kernel_values() const override {
    return {kernel_ ? kernel_->kernel_values() : 0, coupling_values_, 0};
  }

 private:
  [[nodiscard]] bool remembers() const { return kernel_ == nullptr; }
  /// Whether the integrals of the kernels over the pressure are known at the place.
  [[nodiscard]] bool reaches(const SurfacePoint& place) const;
  /// c_{2m + 1}, m < size(). Without memory all other coefficients are 0.
  [[nodiscard]] const Interval& odd(long m) const;
  [[nodiscard]] Interval first() const;  ///< c_1
  [[nodiscard]] long size() const { return static_cast<long>(expansion_.coefficients.size()) / 2; }
  [[nodiscard]] Interval normal_by_pressure(const SurfacePoint& place) const;
  [[nodiscard]] Interval tangential_by_pressure(const SurfacePoint& place) const;
  [[nodiscard]] Interval pressure_between(const SurfacePoint& place) const;
  [[nodiscard]] std::optional<LargestValue> peak() const;  ///< of p/(2A) as a function of theta
  /// int k(A (t - s)) p/(2A) ds, |k| <= largest.
  template <class Kernel>
  [[nodiscard]] Interval smooth_integral(const SurfacePoint& place, const Kernel& kernel,
                                         const Interval& largest) const;

  ProvenExpansion expansion_;
  Interval offset_, beta_ = offset_;
  std::shared_ptr<SmoothKernel> kernel_;
  double nats_ = 0;
  mutable long coupling_values_ = 0;
  mutable std::optional<Interval> edge_displacement_;
  std::vector<Interval> nodes_;           ///< s_j > 0
  std::vector<Interval> node_pressures_;  ///< sqrt(1 - s_j^2) p(s_j)/(2A)
  std::vector<Interval> node_slopes_;     ///< sum_m mu c_m cos(mu theta_j), mu = 2m + 1
};

/// A proof, with the working precision at which its results are to be computed.
struct Proof {
  std::shared_ptr<const ProvenResults> contact;
  int working_digits;
};

}  // namespace nipref::ref
