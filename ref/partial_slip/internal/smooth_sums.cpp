#include <cmath>

#include <nipref/ref/partial_slip/internal/smooth_sums.hpp>

namespace nipref::ref {
namespace {

using ThreeKernels = std::array<Float, 3>;

/// U, V and S without 1/(pi alpha).
ThreeKernels slope_kernels(SheetKernels& kernels, const Float& alpha) {
  const Float normal = kernels.smooth_normal_slope(alpha) / pi();
  return {normal, kernels.coupling_slope(alpha) / pi(), normal - kernels.coupling(alpha) / pi()};
}

}  // namespace

SmoothSums::SmoothSums(const ZonePanels& panels, const ZoneGrid& grid, SheetKernels& kernels)
    : kernels_(kernels) {
  // Chebyshev's extreme points, so many that interpolations of kernels with poles at the height 2 are good to e^-nats.
  const auto length = static_cast<double>(panels.length());
  const int last = 2 * static_cast<int>(std::ceil((grid.nats() / std::asinh(4 / length) + 2) / 2)) - 1;
  for (int i = 0; i <= last; ++i) {
    const Float root = sin(Float(pi() * i / (2 * last)));
    places_.push_back(panels.length() * root * root);
  }
  const GridIndex nodes = grid.nodes();
  integrals_ = Matrix(places_.count(), panels.values());
  for (GridIndex panel = 0; panel < panels.count(); ++panel) {
    const auto& [sign, begin, panel_length, ratio, first] = panels[panel];
    const GridIndex left = first + nodes;
    for (GridIndex i = 0; i < nodes; ++i) {
      const ContactPoint node{panel, {grid.from_left()[i], grid.from_right()[i]}};
      const auto at_node = lagrange(panels.place(node));
      for (GridIndex a = 0; a < at_node.count(); ++a) {
        Float& integral = integrals_(a, first + i);
        integral = panel_length * grid.weight()[i] * at_node[a].re;
        integrals_(a, left) += integral * grid.from_right()[i];
        integrals_(a, left + 1) += integral * grid.from_left()[i];
      }
    }
  }
  for (Matrix& kernel : smooth_) kernel = Matrix(places_.count(), places_.count());
  for (GridIndex i = 0; i < places_.count(); ++i) {
    for (GridIndex j = 0; j <= i; ++j) {
      const auto values = slope_kernels(kernels_, places_[i] - places_[j]);
      for (std::size_t k = 0; k < values.size(); ++k) {
        smooth_[k](i, j) = values[k];
        smooth_[k](j, i) = k == 1 ? values[k] : Float(-values[k]);
      }
    }
  }
}

void SmoothSums::set(const OfBoth<Vector>& values) {
  moments_ = {integrals_ * values[pressure_part], integrals_ * values[shear_part]};
  at_points_ = {smooth_[0] * moments_[pressure_part] - smooth_[1] * moments_[shear_part],
                smooth_[1] * moments_[pressure_part] + smooth_[2] * moments_[shear_part]};
}

Row<ComplexFloat> SmoothSums::lagrange(const ComplexFloat& e) const {
  Row<ComplexFloat> values;
  ComplexFloat sum;
  for (GridIndex i = 0; i < places_.count(); ++i) {
    const bool is_end = i == 0 || i + 1 == places_.count();
    values.push_back(ComplexFloat((i % 2 == 0 ? 1 : -1) * (is_end ? Float(0.5) : Float(1))) /
                     (e - places_[i]));
    sum = sum + values.back();
  }
  sum = ComplexFloat(1) / sum;
  for (ComplexFloat& value : values) value = value * sum;
  return values;
}

PointSums SmoothSums::at(const ComplexFloat& e) const {
  PointSums sums;
  const auto weights = lagrange(e);
  for (GridIndex a = 0; a < weights.count(); ++a) {
    sums.normal = sums.normal + weights[a] * at_points_.normal(a);
    sums.tangential = sums.tangential + weights[a] * at_points_.tangential(a);
  }
  return sums;
}

Float SmoothSums::strain(const Float& e) const { return applied(e, slope_kernels).tangential; }

NormalAndTangential<Float> SmoothSums::displacement(const Float& e) const {
  return applied(e, [](SheetKernels& kernels, const Float& alpha) -> ThreeKernels {
    const Float normal = kernels.smooth_normal(alpha) / pi();
    return {normal, kernels.coupling(alpha) / pi(), normal + kernels.stretch(alpha) / pi()};
  });
}

template <class Kernels>
NormalAndTangential<Float> SmoothSums::applied(const Float& e, const Kernels& kernels_at) const {
  NormalAndTangential<Float> sum{0, 0};
  for (GridIndex i = 0; i < places_.count(); ++i) {
    const auto [normal, coupling, tangential] = kernels_at(kernels_, e - places_[i]);
    const Float &pressed = moments_[pressure_part](i), &sheared = moments_[shear_part](i);
    sum.normal += normal * pressed - coupling * sheared;
    sum.tangential += coupling * pressed + tangential * sheared;
  }
  return sum;
}

std::array<Eigen::MatrixXd, 3> SmoothSums::slopes() const {
  std::array<Eigen::MatrixXd, 3> slopes;
  for (std::size_t k = 0; k < slopes.size(); ++k)
    slopes[k] = smooth_[k].cast<double>() * integrals_.cast<double>();
  return slopes;
}

}  // namespace nipref::ref
