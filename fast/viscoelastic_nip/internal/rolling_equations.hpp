#pragma once
#include <memory>
#include <vector>

#include <nipref/fast/nip/internal/nip_equations.hpp>
#include <nipref/fast/number/internal/sized.hpp>
#include <nipref/fast/viscoelastic_nip/internal/rolling_kernels.hpp>

namespace nipref::fast {

/// The contact of a viscoelastic sheet in steady frictionless rolling, solved as the contact of an elastic sheet.
///
/// Let x be the distance behind the leading end and D = d/dx along the path of the material. The surface's displacement
/// is u = N(D) f, f = K p the displacement of an elastic sheet. In the contact u is that of the roller, so that
///     K p = f = u + sum_j m_j (int_0^x e^(-r_j (x - s)) u(s) ds + e^(-r_j x) w_j),
/// with m_j, r_j of the inverse of N. The numbers w_j = int_0^inf e^(-r_j s) u(-s) ds are memories of the displacement
/// ahead of the contact. Since N(-r_j) = 0, they follow from the memories of f at the leading end,
///     w_j = sum_k n_k/(r_j - s_k) f_k,  f_k = int_0^inf e^(-s_k x) f(-x) dx,
/// which are integrals of the pressure; n_k, s_k are the terms of N. The surface follows u = u_m - y^2 - 2 offset y, y
/// the place from the middle of the contact towards the leading end. The unknowns are u_m, the offset and the
/// coefficients of the exponentials, for a conjugate pair the real and the imaginary part. All equations are split into
/// even and odd parts in y, which K does not mix.
/// For a long memory, f is evaluated as above, and H_j = m_j w_j is the unknown. For a short memory, the pressure that
/// e^(-r_j x) causes next to the leading end is a layer, known in closed form (layer.hpp). f is then split into a
/// polynomial and h_j e^(-r_j x), so that nothing large cancels. By parts, with sum_k n_k/(r_j - s_k) = 1,
///     h_j = m_j/r_j sum_k n_k/(r_j - s_k) (s_k f_k - f(0)) + 2 m_j (offset + A + 1/r_j)/r_j^2,
///     s_k f_k - f(0) = int_0^inf e^(-s_k x) d/dx f(-x) dx.
/// With layers, u_m acts on f through the stiffness that the layers leave, which falls with the softness of the sheet
/// and is 0 if the sheet flows. The unknown of these equations is then the product of u_m and this stiffness, and
///     u_m = A^2 + 2 offset A + f(0) + sum_k n_k f_k.
class RollingEquations : public NipEquations {
 public:
  explicit RollingEquations(RollingSheet sheet);
  RollingEquations(const RollingEquations&) = delete;  // the kernels refer to the sheet
  RollingEquations& operator=(const RollingEquations&) = delete;

  static constexpr int offset = 1;  ///< number of the offset among the unknowns
  /// The number of u_m among the unknowns.
  [[nodiscard]] static int middle_displacement(const Solution& solution) {
    return solution.tractions().layer_rates().empty() ? stiff_part : solution.unknowns() - 1;
  }

  [[nodiscard]] Resolution resolution(double nats) const override;
  [[nodiscard]] Solution solve(double half_length, const std::vector<Panel>& panels, double tolerance,
                               CountedKernels& kernels) const override;
  [[nodiscard]] std::vector<AccuracyTarget> accuracy_targets(const Solution& solution) const override;
  [[nodiscard]] double softening_over(double half_length) const override;
  /// BadInput if the pressure next to the leading end is nearly that of a sheet without instantaneous compliance.
  void check(double half_length) const override;

  [[nodiscard]] std::optional<int> offset_unknown() const override { return offset; }
  [[nodiscard]] Functional roller_displacement(const Solution& solution, double y) const override;
  [[nodiscard]] Functional end_displacement(const Solution& solution, bool trailing) const override;
  [[nodiscard]] Functional normal_displacement(const Solution& solution, const ContactPlace& place,
                                               CountedKernels& kernels) const override;
  [[nodiscard]] AlongSurface along_surface(const Solution& solution, const ContactPlace& place,
                                           CountedKernels& kernels) const override;
  [[nodiscard]] Functional creep_ratio(const Solution& solution, CountedKernels& kernels) const override;

 private:
  using Sized = internal::Sized<double>;
  /// The unknown u_m, or with layers its product with the stiffness that they leave. The product comes before the
  /// exponentials, and u_m after them, so that the elimination finds the exponentials by their own equations.
  static constexpr int stiff_part = 0, first_exponential = 2;
  /// A memory of the inverse; it stands for a conjugate pair if Im rate > 0.
  struct Mode {
    Memory memory;
    std::size_t number;  ///< in the inverse
    int members;         ///< 1, or 2 of a pair
    int unknown;         ///< of H or h; of a pair its real part, which its imaginary part follows
    int layer;           ///< number of its layer, -1 without one

    [[nodiscard]] bool is_layer() const { return layer >= 0; }
  };
  [[nodiscard]] std::vector<Mode> modes(const std::vector<Panel>& panels) const;
  /// The inverse applied to a polynomial u at the distance x behind the leading end, but for the exponentials of H and h,
  ///     stiffness u(x) + sum_j m_j int_0^x e^(-r_j t) (u(x - t) - u(x)) dt.
  /// `first` and `second` are these sums with t and t^2 in place of the difference.
  struct Response {
    Sized stiffness, first, second;

    friend Response operator+(const Response& a, const Response& b) {
      return {a.stiffness + b.stiffness, a.first + b.first, a.second + b.second};
    }
    friend Response operator*(double factor, const Response& a) {
      return {factor * a.stiffness, factor * a.first, factor * a.second};
    }
  };
  /// Layers come first, as their rates are the largest.
  [[nodiscard]] static bool has_layers(const std::vector<Mode>& modes) {
    return !modes.empty() && modes.front().is_layer();
  }
  /// 1 + sum m_j/r_j of the layers: the stiffness that is left where their memories have faded.
  [[nodiscard]] double stiffness_of_layers(const std::vector<Mode>& modes) const;
  /// Whether a memory is split into the stiffness m/r that it leaves and the rest, -m/r e^(-r x). If the sheet only
  /// creeps, these do not cancel, since all m_j are negative and 1 + sum m_j/r_j is not.
  [[nodiscard]] static bool has_faded(const Mode& mode, double half_length);
  /// The part of the response that is equal at all places, with the layers' integrals to infinity; and the other part.
  [[nodiscard]] Response lasting_response(const std::vector<Mode>& modes, double half_length) const;
  [[nodiscard]] Response fading_response(const std::vector<Mode>& modes, double half_length, double x) const;
  void add_matching(const std::vector<Mode>& modes, double half_length, double e, Eigen::Index even_row,
                    Equations& equations) const;
  /// `ahead`: the rows of RollingKernels::ahead at the leading end.
  void add_middle_displacement(double half_length, const Eigen::MatrixXd& ahead, Equations& equations) const;
  void add_closure(const std::vector<Mode>& modes, double half_length, const Eigen::MatrixXd& ahead,
                   Equations& equations) const;

  RollingSheet sheet_;
  RollingKernels kernels_;
};

}  // namespace nipref::fast
