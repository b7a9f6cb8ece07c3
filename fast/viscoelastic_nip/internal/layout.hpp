#pragma once
#include <cstddef>
#include <vector>

namespace nipref::fast {

/// The halves of a contact without symmetry: points are told by their distance e from the end of their half, so that
/// they stay apart however near to the end they crowd.
enum class Half { leading, trailing };

/// A point of the surface: e <= A inside the contact, negative outside it.
struct ContactPlace {
  Half half;
  double e;  ///< distance from the leading or the trailing end, half-thicknesses
};

/// left <= e <= left + width. In each panel everything is a polynomial in xi, with x = (e - left)/width: xi =
/// sqrt x in the panel at the end, where pressures are sqrt x times analytic functions and their memory is
/// analytic in sqrt x, and xi = x elsewhere.
struct ViscoelasticPanel {
  Half half;
  double left;
  double width;

  [[nodiscard]] bool at_end() const { return left == 0; }
  [[nodiscard]] double xi(double x) const;
  [[nodiscard]] double x(double xi) const { return at_end() ? xi * xi : xi; }
  [[nodiscard]] double slope(double xi) const { return at_end() ? 2 * xi : 1; }  ///< dx/dxi
};

/// A contact of half length A (half-thicknesses), cut into panels that double away from both ends, and some of them
/// into pieces.
class ViscoelasticLayout {
 public:
  /// `panels` on each half; `terms` pressure coefficients on each panel.
  ViscoelasticLayout(double half_length, int panels, int terms)
      : ViscoelasticLayout(half_length, std::vector<int>(2 * static_cast<std::size_t>(panels), 1), terms) {}
  /// `pieces`: of equal length, of each panel downstream, as many panels on each half; 1 of those at the ends.
  /// Each piece is a panel of its own.
  ViscoelasticLayout(double half_length, const std::vector<int>& pieces, int terms);

  [[nodiscard]] double half_length() const { return half_length_; }
  [[nodiscard]] int terms() const { return terms_; }
  /// Downstream: from the leading to the trailing end.
  [[nodiscard]] const std::vector<ViscoelasticPanel>& panels() const { return panels_; }
  /// Degree in xi that holds the pressure and its memory: one more than the pressure's.
  [[nodiscard]] int degree(const ViscoelasticPanel& panel) const {
    return panel.at_end() ? 2 * terms_ + 1 : terms_ + 1;
  }
  /// Number `k` of the pressure's basis on a panel at xi: T_k(2x - 1), times xi at an end.
  void pressure_basis(const ViscoelasticPanel& panel, double xi, std::vector<double>& values) const;
  /// As many as there are coefficients and two more, the freedoms of the roller's place.
  [[nodiscard]] std::vector<ContactPlace> matching_points() const;
  /// Distance from the leading end, 0 to 2A inside.
  [[nodiscard]] double downstream(ContactPlace place) const {
    return place.half == Half::leading ? place.e : 2 * half_length_ - place.e;
  }
  /// The panel that holds a place inside the contact.
  [[nodiscard]] std::size_t panel_of(ContactPlace place) const;

 private:
  double half_length_;
  int terms_;
  std::vector<ViscoelasticPanel> panels_;
};

}  // namespace nipref::fast
