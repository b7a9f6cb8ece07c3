#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <nipref/fast/nip/internal/layer.hpp>
#include <nipref/fast/nip/internal/panel_basis.hpp>

namespace nipref::fast {

/// left <= e <= right on half a contact, e the distance from the contact's end; the panel about the middle reaches as far
/// into the other half: right = 2A - left, as Tractions sets it.
struct Panel {
  double left, right;
  bool at_end;        ///< left == 0
  bool about_middle;  ///< the last one
  int terms;          ///< of each real component

  [[nodiscard]] double width() const { return right - left; }
};

/// The tractions of a contact of half length A (half-thicknesses) as a complex function g with g(-y) = conj g(y):
///   without friction     g is the pressure;
///   with full friction   g = pressure + i shear;
///   in rolling           g = even + i odd part of the pressure: pressure(y) = Re g + Im g at y >= 0, Re g - Im g at -y.
/// Panels cover 0 <= e <= A, e = A - y. On each g is a factor times a sum of terms (a_k + i b_k) T_k; the factor is
/// (e/right)^exponent at the end and 1 beyond. About the middle the sum is a_k T_2k(t) + i b_k T_2k+1(t) with
/// t = y/(A - left), and the factor is 1, or (e/A)^exponent (2 - e/A)^conj(exponent) if the panel is the whole contact.
/// Layers are functions of their own on the leading half of the panel at the end: LayerPressure of their rates, each
/// with two columns, its real part and minus its imaginary part.
class Tractions {
 public:
  Tractions(double half_length, std::vector<Panel> panels, bool is_complex, std::complex<double> exponent,
            const std::vector<std::complex<double>>& layers = {});

  /// Terms of each panel and component beyond those that are solved for. Their columns are known, so that the effect of
  /// leaving them out is.
  static constexpr int left_out = 2;

  [[nodiscard]] double half_length() const { return half_length_; }
  [[nodiscard]] const std::vector<Panel>& panels() const { return panels_; }
  [[nodiscard]] std::vector<std::complex<double>> layer_rates() const;
  [[nodiscard]] int components() const { return is_complex_ ? 2 : 1; }
  /// Columns: for each panel and component its terms and those left out, then the layers.
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int column(std::size_t panel, int component) const {
    return first_[panel] + component * (panels_[panel].terms + left_out);
  }
  [[nodiscard]] std::size_t panel_of(double e) const;

  /// The kernels of linear functionals of the tractions: what a line load at the distance alpha adds to each of them,
  /// `on_p` per unit of Re g and `on_q` per unit of Im g, one row for each functional. alpha = y - y' is the place of the
  /// functional less that of the load.
  struct Kernel {
    enum class FarAway { negligible, constant, varying };
    int functionals = 1;
    FarAway beyond_reach = FarAway::negligible;  ///< what it is at distances beyond reach()
    /// Of exponentials next to alpha = 0 that may vary over less than a half-thickness.
    std::vector<std::complex<double>> rates;
    std::function<void(std::span<const double> alpha, Eigen::MatrixXd& on_p, Eigen::MatrixXd& on_q)> at;
    /// Of kernels of 0 <= alpha <= width alone that are the same on p and q: a factor times ln alpha and a rest, both analytic
    /// for |Im alpha| < 2.
    struct ByLogarithm {
      Eigen::MatrixXd factor, rest;
    };
    std::function<ByLogarithm(const Eigen::ArrayXd& alpha, double width)> by_logarithm = {};
    /// The distance from the real axis of poles at alpha = 0, of a kernel that has them.
    std::optional<double> poles = {};
    /// These are its singularities that are nearest to the real axis, on which it is analytic.
    bool is_regular = false;
  };
  /// A kernel with its parts: its coefficients of -ln|alpha|/pi and of the sign of alpha, a row a functional, on_p before
  /// on_q, and what is left, which is analytic for |Im alpha| < 2.
  struct SplitKernel {
    Kernel whole;
    Eigen::MatrixX2d logarithm, jump;
    std::function<void(std::span<const double> alpha, std::span<const double> logarithm,
                       Eigen::MatrixXd& on_p,
                       Eigen::MatrixXd& on_q)>
        regular;  ///< with ln|alpha|, which is known
  };
  /// One row for each functional at a place, one column for each of columns(). e <= A, negative outside the contact.
  /// `trailing`: the place is on the other half, -y.
  [[nodiscard]] Eigen::MatrixXd rows(double e, bool trailing, const Kernel& kernel, double tolerance) const;
  /// The columns of the layers alone, at places on the trailing half, 0 <= e <= A.
  [[nodiscard]] Eigen::MatrixXd rows_of_layers_behind(std::span<const double> places, const Kernel& kernel,
                                                      double tolerance) const;
  /// The same at the matching points: those of the panels, as many as terms, and one more at the end.
  struct MatchingRows {
    std::vector<double> points;
    Eigen::MatrixXd rows, sizes;  ///< sizes of the parts that cancel in the rows' numbers, 0 where none do
  };
  [[nodiscard]] MatchingRows matching_rows(const SplitKernel& kernel, double tolerance) const;
  /// Re g and Im g at 0 <= e <= A: two rows of columns; and their values for given coefficients of all columns.
  [[nodiscard]] Eigen::MatrixXd values(double e) const;
  [[nodiscard]] std::complex<double> value(double e, const Eigen::VectorXd& coefficients) const;
  /// The integrals of Re g and of y Im g over the contact: two rows.
  [[nodiscard]] Eigen::MatrixXd integrals() const;

 private:
  class Sums;
  struct Place {
    double e;
    bool trailing;
  };
  using Rows = Eigen::Ref<Eigen::MatrixXd>;
  [[nodiscard]] std::vector<double> matching_points() const;
  [[nodiscard]] PanelBasis basis(const Panel& panel) const;
  [[nodiscard]] Eigen::Index layer_columns() const { return static_cast<Eigen::Index>(2 * layers_.size()); }
  [[nodiscard]] Eigen::MatrixXd layers_at(const Eigen::ArrayXd& e) const;
  /// Up to which the panel's terms and those left out go.
  [[nodiscard]] static int degrees(const Panel& panel);
  /// Which degrees of T_n(2 x - 1), times a sign, are a component's terms: about the middle t = 1 - 2 x.
  struct Degrees {
    int first, step;
    double sign;

    [[nodiscard]] auto columns(const Eigen::MatrixXd& matrix, int count) const {
      using Strided = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
      return Strided(matrix.data() + first * matrix.rows(), matrix.rows(), count,
                     Eigen::OuterStride<>(step * matrix.rows()));
    }
  };
  [[nodiscard]] Degrees degrees_of(std::size_t panel, int component) const;
  [[nodiscard]] static MatchingPoints points_of(const Panel& panel) {
    return {panel.about_middle, panel.terms + (panel.at_end ? 1 : 0)};
  }
  /// Adds sums over the rows of `integrals` with weights p and q.
  void add_sums(std::size_t panel, const PanelBasis::Rows& integrals, const Eigen::RowVectorXd& p,
                const Eigen::RowVectorXd& q,
                Eigen::Ref<Eigen::RowVectorXd, 0, Eigen::InnerStride<>> row) const;
  /// The layers' columns of integrals().
  [[nodiscard]] Eigen::MatrixXd integrals_of_layers() const;

  double half_length_;
  std::vector<Panel> panels_;
  bool is_complex_;
  std::complex<double> exponent_;
  std::vector<LayerPressure> layers_;
  std::vector<int> first_;  ///< column of each panel, and of the layers
  int columns_;
};

}  // namespace nipref::fast
