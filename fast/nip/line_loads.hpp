#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <nipref/data/material/elastic.hpp>
#include <nipref/fast/nip/inner_stresses.hpp>
#include <nipref/fast/nip/work.hpp>

namespace nipref::fast {

/// A line load on both faces of the sheet at Y, force per unit width: it presses, and its shear acts along Y.
struct FaceLoad {
  double y, normal, shear;
};

enum class FaceDirection { normal, tangential };
/// The displacement of the surface of a sheet under line loads, unit of length, at a Y without load: towards the middle
/// plane, or along Y relative to a point that is the same for all Y. An elastic sheet adds evaluations to `work`.
using LineLoadSheet =
    std::function<double(FaceDirection direction, std::span<const FaceLoad> loads, double y, Work& work)>;

/// Creep ratios from `lower` to `upper`, dimensionless.
struct CreepRange {
  double lower;
  double upper;
};

/// A nip whose tractions are replaced by line loads, as in the thesis: the contact is cut into equal elements, each
/// element's forces act at its centre, and the sheet is held to the roller at the ends of the contact and midway
/// between the loads. (thesis 2.2) It is made by line_loads_for_length or line_loads_for_load for an elastic nip
/// (elastic_nip/line_loads.hpp) or a viscoelastic one (viscoelastic_nip/line_loads.hpp). Every result is computed when
/// it is asked for. The results have no error estimates: they are those of the discrete contact, to rounding.
///
/// Y is the distance along the sheet from the line through the rollers' centres, positive on the leading (entry) side,
/// unit of length, finite; otherwise BadInput. Displacements are infinite at a line load, so that such a Y is BadInput.
struct LineLoadNip {
  double roller_radius;         ///< R, unit of length
  int leading_elements;         ///< m1
  double leading_length;        ///< L1, unit of length
  double indentation;           ///< d0, approach of roller and middle plane, unit of length
  std::vector<FaceLoad> loads;  ///< from the leading end on
  bool is_symmetric;  ///< the normal loads are even about Y = 0 and the shear odd, as of an elastic sheet
  LineLoadSheet sheet;
  std::shared_ptr<Work> spent;               ///< grows with each result that is computed
  std::optional<double> gripped_creep = {};  ///< with full friction: the creep ratio it was solved for
  /// With full friction: the creep ratios for which, at this contact length, no normal load is negative, the shear
  /// loads of one side have one sign and their part of the normal load does not fall outwards. Disjoint, rising.
  /// (thesis 2.1, 2.3, 2.4)
  std::vector<CreepRange> creep_ranges = {};

  [[nodiscard]] int trailing_elements() const;   ///< m2
  [[nodiscard]] double trailing_length() const;  ///< L2, unit of length
  [[nodiscard]] double contact_length() const { return leading_length + trailing_length(); }  ///< L1 + L2
  [[nodiscard]] double element_width() const {
    return leading_length / leading_elements;
  }                                                    ///< unit of length
  [[nodiscard]] double leading_displacement() const;   ///< d1 = d0 - L1^2/(2R), unit of length
  [[nodiscard]] double trailing_displacement() const;  ///< d2 = d0 - L2^2/(2R), unit of length
  [[nodiscard]] double load() const;  ///< W, force per unit width: the sum of the normal loads
  /// The largest normal load, or shear load in magnitude, over the width of its element, unit of stress; and the centre
  /// of that element, unit of length, in a symmetric nip the one with Y > 0.
  [[nodiscard]] double peak_pressure() const;
  [[nodiscard]] double peak_pressure_position() const;
  [[nodiscard]] double peak_shear() const;
  [[nodiscard]] double peak_shear_position() const;
  /// The sum of the normal loads with Y > 0, or with Y < 0, times Y, a force. (thesis 7.13)
  [[nodiscard]] double leading_moment() const;
  [[nodiscard]] double trailing_moment() const;
  [[nodiscard]] double rolling_resistance() const;  ///< the sum of both over W R, dimensionless (thesis 7.15)
  /// (v(L1) - v(-L2))/L, dimensionless; with full friction the one that was solved for. (thesis 5.5, 5.16, 7.17)
  [[nodiscard]] double creep_ratio() const;
  /// The Y >= 0, rising, between shear loads of opposite signs, unit of length. With friction the first is the middle.
  [[nodiscard]] std::vector<double> shear_zeros() const;
  /// The normal or the shear load of the element that contains Y over its width, unit of stress; 0 outside the contact.
  /// A place on a border belongs to the trailing element, in a symmetric nip to the outer one.
  [[nodiscard]] double pressure(double y) const;
  [[nodiscard]] double shear(double y) const;
  /// u, towards the middle plane, and v, relative to Y = 0, at any Y; unit of length. (thesis 5.6, 7.3, 7.16)
  [[nodiscard]] double normal_displacement(double y) const;
  [[nodiscard]] double tangential_displacement(double y) const;
  [[nodiscard]] bool presses_everywhere() const;  ///< no normal load is negative (thesis 2.1)
  [[nodiscard]] const std::vector<FaceLoad>& face_loads() const { return loads; }
  [[nodiscard]] Work work() const { return *spent; }

 private:
  [[nodiscard]] double tangential(double y) const {
    return sheet(FaceDirection::tangential, loads, y, *spent);
  }
};

// The field inside a sheet under line loads, the sum of the loads' fields (sheet/field.hpp), with errors of 0. BadInput
// for the place of a load on a face, where the field is unbounded, and for places outside the domain of InnerPoint.

std::vector<InnerStresses> line_load_stresses(std::span<const FaceLoad> loads, double half_thickness,
                                              std::span<const InnerPoint> points);

/// For an elastic sheet whose loads are symmetric about Y = 0: the normal loads are even, the shear loads odd.
std::vector<InnerDisplacements> line_load_displacements(std::span<const FaceLoad> loads,
                                                        double half_thickness,
                                                        const data::ElasticMaterial& material,
                                                        std::span<const InnerPoint> points);

}  // namespace nipref::fast
