#pragma once
#include <array>
#include <functional>
#include <vector>

#include <nipref/ref/nip/internal/sheet_kernels.hpp>
#include <nipref/ref/number/internal/chebyshev_sum.hpp>
#include <nipref/ref/number/internal/complex.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>

namespace nipref::ref {

struct PressureAndShear {
  Float pressure, shear;
};

/// A part of half a contact, left <= e <= left + width, where e is the distance from the end.
struct TractionPanel {
  Float left, width;
  int terms;  ///< number of terms of the pressure, and as many of the shear
};

/// The kernels of a functional of the tractions, I1, sign, I3, -int I3, I1' and I3' of alpha = y - y', from the line
/// load at y' to the place y.
enum class Influence { normal, sign, coupling, stretch, normal_slope, coupling_slope };
inline constexpr int influences = 6;

/// int (sum_i on_pressure_i K_i(alpha)) p + int (sum_i on_shear_i K_i(alpha)) q over all of the contact, where
/// p(-y) = parity p(y) and q(-y) = -parity q(y).
struct LineFunctional {
  std::array<Float, influences> on_pressure, on_shear;
  int parity = 1;

  LineFunctional& pressure(Influence kind, const Float& factor);
  LineFunctional& shear(Influence kind, const Float& factor);
};

/// The tractions of a contact of half length A (half-thicknesses) on its half y = A - e, 0 <= e <= A, as g = p + i q. On
/// each panel
///
///     g = w sum_k (a_k + i b_k) T_k(2x - 1),   x = (e - left)/width,   w = x^(1/2 - i epsilon) at the end, else 1,
///
/// Without friction epsilon = 0 and b = 0. The tractions on the other half follow by parity.
///
/// Functionals are sums over the nodes of pieces of the panels. Near the place of the functional the singular parts of
/// the kernels are integrated in closed form: ref/nip/README.md, Tractions on panels.
class Tractions {
 public:
  /// Integrals are good to about e^-nats.
  Tractions(const Float& half_length, std::vector<TractionPanel> panels, const Float& epsilon, bool has_shear,
            double nats);
  [[nodiscard]] const Float& half_length() const { return half_length_; }
  [[nodiscard]] const std::vector<TractionPanel>& panels() const { return panels_; }
  /// Coefficients: for each panel its a_k, then its b_k.
  [[nodiscard]] int columns() const { return first_columns_.back(); }
  /// The collocation points e, rising: on each panel as many as it has terms, on the panel at the end one more.
  [[nodiscard]] std::vector<Float> matching_points() const;
  /// The tractions at 0 <= e <= A.
  [[nodiscard]] PressureAndShear at(const Float& e, const Vector& coefficients) const;
  /// a and b of g/w at the end itself.
  [[nodiscard]] PressureAndShear at_root(const Vector& coefficients) const;
  /// For each functional its row, a number for each coefficient, at e <= A; negative e are outside the contact.
  [[nodiscard]] std::vector<Vector> rows(const Float& e, const std::vector<LineFunctional>& functionals,
                                         SheetKernels& kernels) const;
  /// int_0^A p de and int_0^A y p de as rows.
  [[nodiscard]] Vector integral() const;
  [[nodiscard]] Vector moment() const;

 private:
  /// The nodes e, and w T_k times the weight with a column for each node; imaginary parts only if w is not real.
  struct Nodes {
    std::vector<Float> places;
    Matrix real, imaginary;
  };
  /// The panel at the end, or a part of another one.
  struct Piece {
    std::size_t panel;
    Float from, width;
    Nodes nodes;
    Matrix own;   ///< row k: the panel's T_k in terms of the piece's T_j; empty if they are the same
    Vector sums;  ///< where w is 1: the integrals of T_k over the piece, then those of e T_k
  };
  struct Image;

  void add_end_piece();
  void add_piece(std::size_t number, const Float& from, const Float& width);
  [[nodiscard]] Matrix end_weights() const;
  [[nodiscard]] Vector at_nodes(const Piece& piece, const Image& image, Influence kind,
                                SheetKernels& kernels) const;
  void add_nodes(const Piece& piece, const std::vector<Image>& images,
                 const std::vector<LineFunctional>& functionals, SheetKernels& kernels,
                 std::vector<Vector>& rows) const;
  /// int_0^A p factor(e) de as a row: sums over the nodes of a piece are the integrals over it.
  [[nodiscard]] Vector weighted(const std::function<Float(const Float& e)>& factor) const;
  void add_far(const Piece& piece, const Image& image, const std::vector<LineFunctional>& functionals,
               const Float& level, std::vector<Vector>& rows) const;
  /// Whether the place is too near for the nodes of the piece to integrate the singular kernels.
  [[nodiscard]] static bool is_near(const Piece& piece, const Image& image);
  void add_singular(const Piece& piece, const Image& image, const std::vector<LineFunctional>& functionals,
                    std::vector<Vector>& rows) const;
  /// The exponent of w on a panel.
  [[nodiscard]] ComplexFloat exponent(std::size_t panel) const {
    return panel > 0 ? ComplexFloat() : ComplexFloat(Float(1) / 2, -epsilon_);
  }

  Float half_length_, epsilon_;
  std::vector<TractionPanel> panels_;
  bool has_shear_;
  std::vector<int> first_columns_;
  UnitRule rule_;                  ///< Gauss rule of all pieces except the panel at the end
  std::vector<Float> end_points_;  ///< Chebyshev points of 0 .. 1, the nodes of the panel at the end
  std::vector<Piece> pieces_;
};

}  // namespace nipref::ref
