#pragma once
#include <functional>
#include <vector>

#include <nipref/verify/golden/confirm/kernels.hpp>

namespace nipref::verify::confirm {

/// Of a contact's numbers: enough for a memory that cancels twenty of them.
using Solved = Number<60>;

/// A frictionless contact by Kress's rule: pressure g(t)/sqrt(1 - t^2), g by its values at the zeros of T_n, the
/// logarithm of the kernel by what it does to each T_j, the rest by Gauss's rule of Chebyshev's weight. That the
/// pressure is bounded, g(+-1) = 0, are two equations more, for the place and the depth. Lengths in half-thicknesses,
/// x from the middle of the contact to its leading end, pressure in b/(2 R N_0).
class RolledContact {
 public:
  /// Of the half length A > 0 and of what a unit of pressure does to the surface x downstream of it, times pi:
  /// share(x) (-ln|x|) + rest(x), both analytic; `points` > 3.
  RolledContact(const Solved& half_length, const std::function<Solved(const Solved& x)>& share,
                const std::function<Solved(const Solved& x)>& rest, int points);

  [[nodiscard]] Solved load() const;
  [[nodiscard]] Solved offset() const { return offset_; }            ///< of the middle, to the leading side
  [[nodiscard]] Solved indentation() const { return indentation_; }  ///< in b^2/(2 R)
  [[nodiscard]] Solved moment() const;  ///< of the pressure, about the contact's middle
  [[nodiscard]] Solved middle_pressure() const;
  /// The integral of the pressure times f(x).
  [[nodiscard]] Solved integral(const std::function<Solved(const Solved& x)>& f) const;

 private:
  Solved half_length_, offset_, indentation_;
  std::vector<Solved> nodes_, values_;
};

/// A smooth function on [-reach, reach] by its values at `points` (an even number) Chebyshev points.
class Smooth {
 public:
  Smooth(const Solved& reach, int points, const std::function<Solved(const Solved& x)>& f);
  Solved operator()(const Solved& x) const { return sum(coefficients_, x); }
  [[nodiscard]] Solved slope(const Solved& x) const { return sum(slopes_, x); }

 private:
  [[nodiscard]] Solved sum(const std::vector<Solved>& coefficients, const Solved& x) const;

  Solved reach_;
  std::vector<Solved> coefficients_, slopes_;
};

/// Points for so many digits of a function that is analytic but for singularities 2 beside the real axis, on (-reach,
/// reach); an even number.
int smooth_points(double reach, double digits);

}  // namespace nipref::verify::confirm
