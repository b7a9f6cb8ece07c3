#pragma once
#include <functional>
#include <span>
#include <vector>

#include <nipref/fast/nip/inner_stresses.hpp>
#include <nipref/fast/nip/internal/solved_nip.hpp>
#include <nipref/fast/nip/internal/traction_field.hpp>

namespace nipref::fast {

/// The field inside the sheet of a solved contact, dimensionless: lengths in half-thicknesses, stresses as tractions.
///
/// Its error has three parts. The error of the tractions is an oscillating function of the order of the last terms; a
/// stress is at most 4 times as large as the tractions that make it, for the kernels of the pressure have integrals of at
/// most 4/pi (their magnitudes), and Hilbert's transform, which gives the stress along a face by the shear, of a
/// polynomial of less than 40 terms is below 4 times its maximum (2/pi times the logarithm of the terms and 1). Ends
/// that are not where they should be change the tractions like the slope of a square root. And the field rounds.
///
/// Displacements are counted from those of the face at the same Y, see internal::FromFace. What a wrong traction adds to them
/// is at most its error times the integral of the kernels' magnitudes over the contact, see reach_of_displacements. A wrong
/// place, of the ends or of the point, adds its error times their slope along the sheet, which is a strain: 4 times the
/// tractions at most, and 4 times at the face.
class ContactField {
 public:
  /// middle: of the contact, from the origin of places. ends: error of the places of the ends. is_symmetric: the pressure
  /// is even about the middle and the shear odd.
  ContactField(const SolvedNip& nip, bool is_symmetric, double middle, double ends);

  /// The stresses at each place.
  [[nodiscard]] std::vector<InnerStresses> at(const std::vector<SheetPoint>& places) const;
  /// The displacements at each place beyond the shares of the face's, 1 of v and |depth| of u: over theta1 + theta2, of which
  /// `share` has the parts.
  [[nodiscard]] std::vector<InnerDisplacements> from_face(const std::vector<SheetPoint>& places,
                                                          const internal::Shares& share) const;
  /// The largest shear and its place, by a grid that scales with the contact and is finer at its ends, then by ever smaller
  /// steps around the best place. In a symmetric contact only y >= 0 is searched.
  [[nodiscard]] GreatestShear greatest() const;

 private:
  [[nodiscard]] double error_at(const SheetPoint& place) const;

  bool is_symmetric_;
  double middle_, half_length_, ends_;
  double peak_, traction_error_;
  TractionField field_;
};

/// Over the unit of length. BadInput unless each y is finite and each depth from -1 to 1.
std::vector<SheetPoint> checked_points(std::span<const InnerPoint> points, double unit);

/// The displacements at a depth from those of the face and what ContactField::from_face has beyond them, in `unit`.
InnerDisplacements beyond_face(const InnerDisplacements& face, double depth, double unit,
                               const InnerDisplacements& beyond);

}  // namespace nipref::fast
