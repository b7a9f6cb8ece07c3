#pragma once
#include <memory>
#include <vector>

#include <nipref/fast/nip/internal/nip_equations.hpp>
#include <nipref/fast/number/internal/sized.hpp>
#include <nipref/fast/viscoelastic_nip/internal/rolling_kernels.hpp>

namespace nipref::fast {

/// The contact of a viscoelastic sheet in steady frictionless rolling, as that of an elastic one.
///
/// With D = d/dx along the path of the material, x the distance behind the leading end, the surface's displacement is
/// u = N(D) f, f = K p the displacement of an elastic sheet. So in the contact, where u is the roller's,
///     K p = f = u + sum_j m_j (int_0^x e^(-r_j (x - s)) u(s) ds + e^(-r_j x) w_j),
/// with m_j, r_j of the inverse of N and the numbers w_j = int_0^inf e^(-r_j s) u(-s) ds, which is what the sheet brings
/// along. Since N(-r_j) = 0 they follow from the memories of f at the leading end,
///     w_j = sum_k n_k/(r_j - s_k) f_k,  f_k = int_0^inf e^(-s_k x) f(-x) dx,
/// which are integrals of the pressure; n_k, s_k are the terms of N. The surface follows u = u_m - y^2 - 2 offset y, y the
/// place from the middle of the contact towards the leading end. Unknowns are u_m, the offset and the coefficients of the
/// exponentials, real and imaginary part of those of a conjugate pair. Everything is split into its even and its odd part
/// in y, which K does not mix.
/// Where a memory is long, f is evaluated as it stands and H_j = m_j w_j is the unknown. Where it is short, what e^(-r_j x)
/// brings into the pressure next to the leading end is a layer, known in closed form (layer.hpp). Then f is taken apart into
/// a polynomial and h_j e^(-r_j x), so that nothing large cancels: by parts, with sum_k n_k/(r_j - s_k) = 1,
///     h_j = m_j/r_j sum_k n_k/(r_j - s_k) (s_k f_k - f(0)) + 2 m_j (offset + A + 1/r_j)/r_j^2,
///     s_k f_k - f(0) = int_0^inf e^(-s_k x) d/dx f(-x) dx.
/// By the layers' memories u_m acts on f less and less as the sheet is softer, and not at all if it flows. So with layers
/// the product of u_m and the stiffness that the layers have left is the unknown of these equations, and
///     u_m = A^2 + 2 offset A + f(0) + sum_k n_k f_k.
class RollingEquations : public NipEquations {
 public:
  explicit RollingEquations(RollingSheet sheet);
  RollingEquations(const RollingEquations&) = delete;  // the kernels refer to the sheet
  RollingEquations& operator=(const RollingEquations&) = delete;

  static constexpr int offset = 1;  ///< number of the unknown
  /// The number of u_m among the unknowns.
  [[nodiscard]] static int middle_displacement(const Solution& solution) {
    return solution.tractions().layer_rates().empty() ? stiff_part : solution.unknowns() - 1;
  }

  [[nodiscard]] Resolution resolution(double nats) const override;
  [[nodiscard]] Solution solve(double half_length, const std::vector<Panel>& panels, double tolerance,
                               CountedKernels& kernels) const override;
  [[nodiscard]] std::vector<AccuracyTarget> accuracy_targets(const Solution& solution) const override;
  [[nodiscard]] double softening_over(double half_length) const override;
  /// BadInput where the pressure next to the leading end is nearly as large as if nothing gave way at once.
  void check(double half_length) const override;

  [[nodiscard]] std::optional<int> offset_unknown() const override { return offset; }
  [[nodiscard]] Functional roller_displacement(const Solution& solution, double y) const override;
  [[nodiscard]] Functional end_displacement(const Solution& solution, bool trailing) const override;
  [[nodiscard]] Functional normal(const Solution& solution, const ContactPlace& place,
                                  CountedKernels& kernels) const override;
  [[nodiscard]] SurfaceAlong along(const Solution& solution, const ContactPlace& place,
                                   CountedKernels& kernels) const override;
  [[nodiscard]] Functional creep(const Solution& solution, CountedKernels& kernels) const override;

 private:
  using Sized = internal::Sized<double>;
  /// u_m, or with layers its product with the stiffness that they have left. It comes before the exponentials, and u_m after
  /// them, so that the elimination finds the exponentials by their own equations.
  static constexpr int stiff_part = 0;
  /// One rate of the inverse, or a conjugate pair by that with Im > 0.
  struct Mode {
    Memory memory;
    std::size_t number;  ///< in the inverse
    int columns;         ///< 1, or 2 of a pair
    int unknown;         ///< the first of H or h
    int layer;           ///< number of its layer, or -1
  };
  [[nodiscard]] std::vector<Mode> modes(const std::vector<Panel>& panels) const;
  /// What the inverse makes of a polynomial u at the distance x behind the leading end, beside the exponentials of H and h,
  ///     stiffness u(x) + sum_j m_j int_0^x e^(-r_j t) (u(x - t) - u(x)) dt;
  /// first and second are these sums with t and t^2 in place of the difference.
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
    return !modes.empty() && modes.front().layer >= 0;
  }
  /// 1 + sum m_j/r_j of the layers: what their memories have left of the stiffness where they have faded.
  [[nodiscard]] double stiffness_of_layers(const std::vector<Mode>& modes) const;
  /// Whether a memory counts as the stiffness m/r that it leaves and the rest, -m/r e^(-r x), rather than as a whole. Where
  /// the sheet only creeps none of these cancel, since all m_j are negative and 1 + sum m_j/r_j is not.
  [[nodiscard]] static bool has_faded(const Mode& mode, double half_length);
  /// What is the same at all places, layers with integrals to infinity among it, and the rest.
  [[nodiscard]] Response lasting_response(const std::vector<Mode>& modes, double half_length) const;
  [[nodiscard]] Response fading_response(const std::vector<Mode>& modes, double half_length, double x) const;
  void add_matching(const std::vector<Mode>& modes, double half_length, double e, Eigen::Index row,
                    Equations& equations) const;
  /// `ahead`: the rows of RollingKernels::ahead at the leading end.
  void add_middle_displacement(double half_length, const Eigen::MatrixXd& ahead, Equations& equations) const;
  void add_closure(const std::vector<Mode>& modes, double half_length, const Eigen::MatrixXd& ahead,
                   Equations& equations) const;

  RollingSheet sheet_;
  RollingKernels kernels_;
};

}  // namespace nipref::fast
