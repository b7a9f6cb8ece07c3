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

/// A bound from below of x times the symbol of the displacements under the tractions, for the wave number x and all larger
/// ones: without friction, and the least eigenvalue with full friction, beta = theta2/N.
Interval frictionless_stiffness(const Interval& x);
Interval gripped_stiffness(const Interval& x, const Interval& beta);

/// lambda of (1) with such a bound, for all half lengths of the interval, in half-thicknesses.
using Stiffness = std::function<Interval(const Interval& x)>;
Interval coercivity(const Interval& half_length, const Stiffness& stiffness);

/// C and tau of (2) that an expansion of this size is proven with.
struct EntryBounds {
  Interval amplitude, rate;

  /// e^{-k tau}
  [[nodiscard]] Interval power(long k) const { return exp(-(k * rate)); }
};
EntryBounds entry_bounds(const Interval& half_length, int size);

/// A bound of all entries that N points fold onto one, where the least index folded is `first`.
Interval folded_entries(const EntryBounds& decay, long points, long first);

/// Bounds of sum m e^{-m rate} over m = first, first + 2, .., and of sum m^2 e^{-m rate} over all m >= first; rate > 0.
Interval tail(const Interval& rate, long first);
Interval square_tail(const Interval& rate, long first);

/// Units of (A + 1) that cover what rounding A cos(theta_i) -+ A cos(theta_j) does to a value of J.
inline constexpr long argument_units = 64;

/// Coefficients that give about so many digits, by the bounds above.
int size_for(double half_length, int digits);

/// A place on the surface, by its distance from the nearer end in half lengths of the contact, negative outside: so that
/// the distance from the end is known as well as the place.
struct SurfacePoint {
  Interval before_end;
  bool is_trailing = false;  ///< which end is nearer
};

/// The pressure of a frictionless contact, p = 2A sum_m c_m sin(m theta), A cos(theta) from its middle to the leading side,
/// and what of the infinite sum these coefficients may miss; A is any in an interval.
struct ProvenExpansion {
  Interval half_length;                ///< A
  std::vector<Interval> coefficients;  ///< c_0 = 0, c_1 ..
  Interval radius;                     ///< sum_m m |dc_m| <= this, all m
  Interval energy_radius;              ///< sqrt(sum_m m dc_m^2) <= this, so |dc_1|
  /// Of Gauss-Chebyshev at as many nodes: int k(t, s) p(s)/(2A) ds by the values of its integrand, k the kernel
  /// J(A (t - s)) or I3(A (t - s)), is off by at most this.
  Interval quadrature_error;
};

/// What is proven of a contact, in half-thicknesses b, pressures in b/(2 R N), displacements in b^2/(2R), N at once.
/// Intervals contain the truth; nothing where none is known.
class ProvenResults {
 public:
  virtual ~ProvenResults() = default;

  [[nodiscard]] virtual const Interval& half_length() const = 0;
  /// Of the middle from the line through the rollers' centres, towards the leading side.
  [[nodiscard]] virtual const Interval& offset() const = 0;
  [[nodiscard]] virtual Interval edge_displacement() const = 0;  ///< at the leading end
  [[nodiscard]] virtual Interval load() const = 0;
  [[nodiscard]] virtual Interval lever() const = 0;  ///< of the resultant from the line through the centres
  [[nodiscard]] virtual Interval pressure(const SurfacePoint& place) const = 0;  ///< 0 outside
  [[nodiscard]] virtual Interval shear(const SurfacePoint& place) const = 0;     ///< the same
  /// Towards the middle plane.
  [[nodiscard]] virtual std::optional<Interval> normal(const SurfacePoint& place) const = 0;
  [[nodiscard]] virtual std::optional<Interval> tangential(const SurfacePoint& place) const = 0;  ///< along Y
  /// Its derivative along the surface, in b/(2R).
  [[nodiscard]] virtual std::optional<Interval> strain(const SurfacePoint& place) const = 0;
  [[nodiscard]] virtual std::optional<Interval> peak_pressure() const = 0;
  [[nodiscard]] virtual std::optional<Interval> peak_pressure_position() const { return {}; }  ///< Y
  [[nodiscard]] virtual std::optional<Interval> peak_shear() const { return {}; }              ///< of |shear|
  [[nodiscard]] virtual const ProvenExpansion* expansion() const { return nullptr; }  ///< none with friction
  [[nodiscard]] virtual int terms() const = 0;
  [[nodiscard]] virtual KernelValues kernel_values() const = 0;  ///< so far
};

/// What follows from a proven expansion without friction, for each half length of the expansion's.
/// (ref/elastic_nip/README.md, Contacts without friction)
class ProvenContact final : public ProvenResults {
 public:
  /// Of a sheet without memory: both halves are alike. beta = theta2/N.
  ProvenContact(ProvenExpansion expansion, const Exact& beta, std::shared_ptr<SmoothKernel> kernel,
                double nats);
  /// Of a rolling sheet with a memory, of which less is proven.
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
  /// With a memory, only in the contact.
  [[nodiscard]] std::optional<Interval> normal(const SurfacePoint& place) const override;
  /// Without memory.
  [[nodiscard]] std::optional<Interval> tangential(const SurfacePoint& place) const override;
  /// By parts and by the same nodes. Without memory.
  [[nodiscard]] std::optional<Interval> strain(const SurfacePoint& place) const override;
  [[nodiscard]] std::optional<Interval> peak_pressure() const override;
  [[nodiscard]] std::optional<Interval> peak_pressure_position() const override;
  /// Whether all of these are known to so many digits of their scale.
  [[nodiscard]] bool is_good_to(int digits) const;

  [[nodiscard]] const ProvenExpansion* expansion() const override { return &expansion_; }
  [[nodiscard]] int terms() const override { return static_cast<int>(size()); }
  [[nodiscard]] KernelValues kernel_values() const override {
    return {kernel_ ? kernel_->kernel_values() : 0, coupling_values_, 0};
  }

 private:
  [[nodiscard]] bool remembers() const { return kernel_ == nullptr; }
  /// Whether the integrals of the kernels over the pressure are known.
  [[nodiscard]] bool reaches(const SurfacePoint& place) const;
  /// c_{2m + 1}, m < size(): there are no others without memory.
  [[nodiscard]] const Interval& odd(long m) const;
  [[nodiscard]] Interval first() const;  ///< c_1
  [[nodiscard]] long size() const { return static_cast<long>(expansion_.coefficients.size()) / 2; }
  [[nodiscard]] Interval normal_by_pressure(const SurfacePoint& place) const;
  [[nodiscard]] Interval tangential_by_pressure(const SurfacePoint& place) const;
  [[nodiscard]] Interval pressure_between(const SurfacePoint& place) const;
  [[nodiscard]] std::optional<LargestValue> peak() const;  ///< of p/(2A) by theta
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

/// A proof, with the working precision at which what it has is to be computed.
struct Proof {
  std::shared_ptr<const ProvenResults> contact;
  int working_digits;
};

}  // namespace nipref::ref
