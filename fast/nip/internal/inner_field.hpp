#pragma once
#include <vector>

#include <nipref/fast/nip/inner_stresses.hpp>
#include <nipref/fast/nip/internal/nip_equations.hpp>
#include <nipref/fast/nip/internal/solved_nip.hpp>
#include <nipref/fast/sheet/internal/theta_shares.hpp>

namespace nipref::fast {

/// A point inside the sheet, -1 <= depth <= 1.
struct SheetPoint {
  ContactPlace place;
  double depth;
  bool is_middle;  ///< of a symmetric contact
};

/// The field inside the sheet of a solved contact, dimensionless: lengths in half-thicknesses, stresses as tractions.
///
/// Stresses and displacements are functionals of the tractions. Their kernels are the field under line loads, and their
/// errors are those of functionals (solution.hpp) plus the effect of the error of the ends. At the distance d from a
/// face a kernel has poles at alpha = +- i d. On a face, in the contact, the stress along the sheet follows from the
/// strain e of the surface and the pressure p where the sheet sticks,
///     sigma = 2 e - (theta1 - theta2)/(theta1 + theta2) p;
/// where the sheet slides, the stress is -p plus the integral of the regular part of the kernel.
/// Displacements are relative to those of the face at the same Y, see internal::FromFace.
class InnerField {
 public:
  /// `ends`: the error of the places of the ends, 0 if they are given.
  InnerField(const SolvedNip& nip, double ends) : nip_(nip), equations_(nip.equations()), ends_(ends) {}

  [[nodiscard]] InnerStresses at(const SheetPoint& point) const;
  /// The displacements less v and |depth| u of the face, over theta1 + theta2.
  [[nodiscard]] InnerDisplacements from_face(const SheetPoint& point, const internal::Shares& share) const;
  /// The largest shear and its place, y from the contact's middle, by ShearSearch. The error of the place covers all
  /// maxima found that may be the largest, and where they are flat.
  [[nodiscard]] GreatestShear greatest_shear() const;

 private:
  [[nodiscard]] std::vector<Estimate> estimates(const ContactPlace& place,
                                                const SolvedNip::AtPlace& numbers) const;
  /// The stresses across, along and in shear: their kernel, and their functionals in a solution.
  [[nodiscard]] Tractions::Kernel stress_kernel(double depth) const;
  [[nodiscard]] std::vector<Functional> stresses(const Solution& solution, const ContactPlace& place,
                                                 double depth, const Tractions::Kernel& kernel,
                                                 double tolerance) const;

  const SolvedNip& nip_;
  const NipEquations& equations_;
  double ends_;
};

/// BadInput unless y is finite and the depth from -1 to 1.
void check_inside(const InnerPoint& point);

/// The displacements at a depth: v and |depth| u of the face, plus `unit` times `beyond`, from InnerField::from_face.
InnerDisplacements beyond_face(const InnerDisplacements& face, double depth, double unit,
                               const InnerDisplacements& beyond);

}  // namespace nipref::fast
