#pragma once
#include <memory>
#include <optional>
#include <vector>

#include <nipref/data/problem/viscoelastic_nip.hpp>
#include <nipref/ref/nip/line_load_field.hpp>
#include <nipref/ref/number/enclosure.hpp>

namespace nipref::ref {

/// The thesis's discretisation of the viscoelastic nip, the same equations as fast/viscoelastic_nip/line_loads: line
/// loads at the centres of equal elements that started, all at once, `approach` before the first matching point
/// came into the nip. (thesis 2.2, 7.2)
struct ViscoelasticLineLoadMethod {
  int leading_elements;  ///< m1, 1 to 100
  std::optional<int>
      trailing_elements;  ///< m2, 0 to 100; absent: searched for as the thesis does (section 2.5)
  double approach;        ///< C_L, half-thicknesses, > 0; at most 500 with the contact
  int residue_terms;      ///< of the plain sums, 1 to 500; 0: exact kernels
};

/// That contact in multiprecision, of the exact values of the doubles that describe it; the material must have real
/// rates. Proven: ref/viscoelastic_nip/README.md, Rolling line loads.
class ViscoelasticLineLoads {
 public:
  /// digits: 16 to 30, otherwise BadInput, as for a method, length or load out of its domain, or a load that no
  /// length up to the roller's radius is found to carry.
  static ViscoelasticLineLoads for_length(const data::ViscoelasticNip& nip,
                                          const ViscoelasticLineLoadMethod& method, double contact_length,
                                          int digits);
  static ViscoelasticLineLoads for_load(const data::ViscoelasticNip& nip,
                                        const ViscoelasticLineLoadMethod& method, double load, int digits);

  [[nodiscard]] Enclosure contact_length() const;
  [[nodiscard]] Enclosure leading_length() const;
  [[nodiscard]] Enclosure trailing_length() const;
  [[nodiscard]] Enclosure indentation() const;
  [[nodiscard]] Enclosure leading_displacement() const;
  [[nodiscard]] Enclosure trailing_displacement() const;
  [[nodiscard]] Enclosure load() const;
  [[nodiscard]] Enclosure peak_pressure() const;
  [[nodiscard]] Enclosure peak_pressure_position() const;  ///< Y of the centre of its element
  [[nodiscard]] Enclosure rolling_resistance() const;
  /// Of the loads ahead of the line through the rollers' centres about it, and of those behind. (thesis 7.13)
  [[nodiscard]] Enclosure leading_moment() const;
  [[nodiscard]] Enclosure trailing_moment() const;
  [[nodiscard]] Enclosure creep_ratio() const;  ///< (thesis 7.16, 7.17)

  // At Y, from the line through the rollers' centres, positive ahead; BadInput "y" as in fast's.
  [[nodiscard]] Enclosure pressure(double y) const;  ///< of the element; a border is the trailing one's
  [[nodiscard]] Enclosure normal_displacement(double y) const;
  [[nodiscard]] Enclosure tangential_displacement(double y) const;

  /// What the loads are, from the leading end on: for the stresses inside the sheet, see ref/nip/line_load_field.hpp.
  [[nodiscard]] std::vector<FaceLoad> face_loads() const;

  [[nodiscard]] int systems() const;  ///< that were solved
  [[nodiscard]] int elements() const;

 private:
  struct Implementation;
  explicit ViscoelasticLineLoads(std::shared_ptr<const Implementation> implementation)
      : implementation_(std::move(implementation)) {}

  std::shared_ptr<const Implementation> implementation_;
};

}  // namespace nipref::ref
