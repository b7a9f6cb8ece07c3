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

/// A panel of the contact: left <= e <= right, e the distance from the end of one half of the contact. The panel about
/// the middle extends as far into the other half: right = 2A - left, which Tractions sets.
struct Panel {
  double left, right;
  bool at_end;        ///< left == 0
  bool about_middle;  ///< the last one
  int terms;          ///< number of terms of each real component

  [[nodiscard]] double width() const { return right - left; }
};

/// The tractions of a contact of half-length A (half-thicknesses) as a complex function g with g(-y) = conj g(y):
///   without friction     g is the pressure;
///   with full friction   g = pressure + i shear;
///   in rolling           g = even + i odd part of the pressure: pressure(y) = Re g + Im g at y >= 0, Re g - Im g at -y.
/// Panels cover 0 <= e <= A, e = A - y. On each panel g is a factor times a sum of terms (a_k + i b_k) T_k; the factor
/// is (e/right)^exponent on the panel at the end and 1 on the others. About the middle the terms are
/// a_k T_2k(t) + i b_k T_2k+1(t) with t = y/(A - left), and the factor is 1, or (e/A)^exponent (2 - e/A)^conj(exponent)
/// if the panel is the whole contact. A layer is a further function, LayerPressure of its rate, on the panel at the
/// leading end. It has two columns, its real part and minus its imaginary part.
class Tractions {
 public:
  Tractions(double half_length, std::vector<Panel> panels, bool is_complex, std::complex<double> exponent,
            const std::vector<std::complex<double>>& layers = {});

  /// The number of terms of each panel and component that follow the terms solved for. Their columns are computed, so
  /// that the effect of leaving them out can be estimated.
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
  /// `on_p` per unit of Re g and `on_q` per unit of Im g, one row for each functional. alpha = y - y' is the place of
  /// the functional less that of the load.
  struct Kernel {
    /// What is left of the kernel so far away that its parts that decay like e^(-2.1 |alpha|) are negligible: nothing,
    /// a linear function of alpha on each side, or anything else.
    enum class FarAway { negligible, linear, varying };
    int functionals = 1;
    FarAway beyond_reach = FarAway::negligible;
    /// The rates of exponentials beside alpha = 0 that may vary over less than a half-thickness.
    std::vector<std::complex<double>> rates;
    std::function<void(std::span<const double> alpha, Eigen::MatrixXd& on_p, Eigen::MatrixXd& on_q)> at;
    /// A kernel on 0 <= alpha <= width that is the same on p and q, as a factor times ln alpha plus a rest. Both are
    /// analytic for |Im alpha| < 2.
    struct ByLogarithm {
      Eigen::MatrixXd factor, rest;
    };
    std::function<ByLogarithm(const Eigen::ArrayXd& alpha, double width)> by_logarithm = {};
    /// The distance d from the real axis of the kernel's poles alpha = +- i d, if it has such poles.
    std::optional<double> poles = {};
    /// Whether the kernel is analytic on the real axis, with these poles as its nearest singularities.
    bool is_regular = false;
  };
  /// A kernel and its parts: the coefficients of -ln|alpha|/pi and of the sign of alpha, a row for each functional with
  /// the columns on_p and on_q, and the rest, which is analytic for |Im alpha| < 2.
  struct SplitKernel {
    Kernel whole;
    Eigen::MatrixX2d logarithm, jump;
    std::function<void(std::span<const double> alpha, std::span<const double> logarithm,
                       Eigen::MatrixXd& on_p,
                       Eigen::MatrixXd& on_q)>
        regular;  ///< the rest; `logarithm` is ln|alpha|
  };
  /// The functionals at a place: a row for each functional, a column for each of columns(). e <= A, negative outside
  /// the contact. `trailing`: the place is on the trailing half, at -y.
  [[nodiscard]] Eigen::MatrixXd rows(double e, bool trailing, const Kernel& kernel, double tolerance) const;
  /// The columns of the layers alone, at places on the trailing half, 0 <= e <= A.
  [[nodiscard]] Eigen::MatrixXd rows_of_layers_behind(std::span<const double> places, const Kernel& kernel,
                                                      double tolerance) const;
  /// The functionals at the matching points. Panels have as many points as terms, the panel at the end one more.
  struct MatchingRows {
    std::vector<double> points;
    Eigen::MatrixXd rows, sizes;  ///< sizes: of the parts that cancel in each number of rows, or 0
  };
  [[nodiscard]] MatchingRows matching_rows(const SplitKernel& kernel, double tolerance) const;
  /// Re g and Im g at 0 <= e <= A: two rows with a column for each of columns(); and g for given coefficients.
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
  /// The number of degrees n of T_n(2 x - 1) that a panel's terms need, with those left out.
  [[nodiscard]] static int degrees(const Panel& panel);
  /// The degrees n whose T_n(2 x - 1), times a sign, are the terms of a component. About the middle t = 1 - 2 x.
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
  /// Adds the sums over the rows of `integrals`, with the weights p of Re g and q of Im g.
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
