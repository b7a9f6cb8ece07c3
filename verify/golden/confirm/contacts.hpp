#pragma once
#include <nipref/verify/golden/confirm/interpolant.hpp>
#include <nipref/verify/golden/confirm/kernels.hpp>

namespace nipref::verify::confirm {

/// A frictionless contact by Kress's rule. The pressure is g(t)/sqrt(1 - t^2), where g is given by its values at the
/// zeros of T_n. The logarithm of the kernel is integrated exactly on each T_j, the rest by the Gauss-Chebyshev rule.
/// Two more equations, g(+-1) = 0 for a bounded pressure, determine the position and the depth of the contact.
/// Lengths are in half-thicknesses, x is from the middle of the contact to its leading end, the pressure is in b/(2 R
/// N_0).
class RolledContact {
 public:
  /// The half length A > 0, and the displacement of the surface times pi at the distance x downstream of a unit load,
  /// share(x) (-ln|x|) + rest(x), in which both functions are analytic; `points` > 3.
  RolledContact(const Float& half_length, const std::function<Float(const Float& x)>& share,
                const std::function<Float(const Float& x)>& rest, int points);

  [[nodiscard]] Float load() const;
  [[nodiscard]] Float offset() const { return offset_; }            ///< of the middle towards the leading end
  [[nodiscard]] Float indentation() const { return indentation_; }  ///< in b^2/(2 R)
  [[nodiscard]] Float moment() const;  ///< of the pressure, about the contact's middle
  [[nodiscard]] Float middle_pressure() const;
  /// The integral of the pressure times f(x).
  [[nodiscard]] Float integral(const std::function<Float(const Float& x)>& f) const;

 private:
  Float half_length_, offset_, indentation_;
  std::vector<Float> nodes_, values_;
};

/// Longer contacts, L/B, without friction, with full friction, and rolling ones need too many points and are not confirmed.
inline constexpr double longest_confirmed = 4, longest_gripped_confirmed = 4, longest_rolling_confirmed = 0.5;

/// The sheet of a contact that rolls without friction, in half-thicknesses.
struct RollingSheet {
  /// A term of the memory: its amplitudes are divided by its rate and by the instantaneous normal compliance N.
  struct Memory {
    Float rate, of_normal, of_theta2;
  };

  Float half_length;
  Float theta2;  ///< instantaneous, over N
  std::vector<Memory> memories;

  /// Joins terms of equal rate.
  void remember(const Memory& term) {
    for (Memory& memory : memories) {
      if (memory.rate != term.rate) continue;
      memory.of_normal += term.of_normal;
      memory.of_theta2 += term.of_theta2;
      return;
    }
    memories.push_back(term);
  }
};

/// rolling_nip.resistance, .leading_share, .load, .indentation, .creep, and the pressure in the middle as nip.peak_pressure.
std::vector<Confirmation> rolling_numbers(const RollingSheet& sheet);

/// An even number of points for so many digits on (-reach, reach), of a function whose singularities are at least 2
/// away from the real axis.
int smooth_points(double reach, double digits);

/// nip.load, .indentation, .creep, .peak_pressure, .peak_shear of an elastic contact with full friction by sinc
/// collocation: x = A tanh w, so that the tractions decay in w. The tractions are values at multiples of a step in w.
/// The slopes of the surface are required half a step away from them, where the trapezoidal rule converges although
/// the integrals are principal values. The rule is fine or coarse.
std::vector<Float> gripped_numbers(double half_length, double poisson, bool fine);

}  // namespace nipref::verify::confirm
