#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include <nipref/fast/number/internal/chebyshev.hpp>
#include <nipref/fast/number/internal/exponential_integrals.hpp>
#include <nipref/fast/number/internal/interpolation.hpp>
#include <nipref/fast/sheet/field.hpp>
#include <nipref/fast/sheet/internal/tables.hpp>
#include <nipref/fast/viscoelastic_nip/internal/rolling_kernels.hpp>

namespace nipref::fast {
namespace {

using Complex = std::complex<double>;
using internal::Two;

constexpr double pi = std::numbers::pi;

/// z and |A| of I1's slowest residue term, Re A e^(i z |alpha|), which alone is left far from the load (thesis AI.5).
Complex slowest_root() {
  return {internal::root_table.frequency_high[0], internal::root_table.decay_high[0]};
}
double amplitude_of_I1() {
  const auto& amplitude = internal::component_tables[static_cast<int>(internal::Component::I1)].amplitude[0];
  return std::hypot(amplitude[0], amplitude[1]);
}

internal::SurfacePoint point(double alpha) { return internal::surface_point({alpha, 0}, Accuracy()); }

/// The kernel whose functionals are `kernels` over pi, each followed by its size. It is the same for both parts of g.
template <class... Kernels>
Tractions::Kernel for_both_parts(std::vector<Complex> rates, const Kernels&... kernels) {
  constexpr int functionals = 2 * sizeof...(Kernels);
  return {functionals, Tractions::Kernel::FarAway::varying, std::move(rates),
          [kernels...](std::span<const double> alpha, Eigen::MatrixXd& on_p, Eigen::MatrixXd& on_q) {
            on_p.resize(functionals, static_cast<Eigen::Index>(alpha.size()));
            for (std::size_t i = 0; i < alpha.size(); ++i) {
              const internal::SurfacePoint at = point(alpha[i]);
              auto values = on_p.col(static_cast<Eigen::Index>(i)).begin();
              for (const internal::Sized<double>& sum : {kernels(alpha[i], at)...}) {
                *values++ = sum.value / pi;
                *values++ = sum.size / pi;
              }
            }
            on_q = on_p;
          }};
}

}  // namespace

RollingKernels::RollingKernels(const RollingSheet& sheet)
    : sheet_(sheet), fades_(fades(internal::Kernel::I1)), slowest_amplitude_(amplitude_of_I1()) {
  // The memory of a wave e^(i z |alpha|) is the wave over rate - i z ahead of the load, over rate + i z behind it. A real
  // wave is half the sum of this one and its conjugate. Since |rate + conj(i z)| = |conj(rate) + i z|, the sum over both
  // rates of a conjugate pair with i z alone bounds their memories.
  const Complex turned = Complex(0, 1) * slowest_root();
  for (const auto& [amplitude, rate] : sheet.normal.terms)
    slowest_amplitude_ += amplitude_of_I1() * std::abs(amplitude) /
                          std::min(rate.real() - turned.real(), std::abs(rate + turned));
}

RollingKernels::Fades RollingKernels::fades(internal::Kernel kernel) const {
  Fades result;
  for (const auto& [amplitude, rate] : sheet_.normal.terms) {
    if (rate.imag() == 0)
      result.emplace_back(internal::fade(Two{rate.real(), 0}, {kernel}, Accuracy()));
    else
      result.emplace_back(internal::fade(rate, {kernel}, Accuracy()));
  }
  return result;
}

template <class Sum, class MemoryOf, class SizeOfTrace>
void RollingKernels::add_terms(Sum& sum, double alpha, const Fades& fades, const MemoryOf& memory,
                               const SizeOfTrace& size_of_trace) const {
  for (std::size_t k = 0; k < fades.size(); ++k) {
    const auto& [amplitude, rate] = sheet_.normal.terms[k];
    if (rate.imag() < 0) continue;
    const double terms = rate.imag() > 0 ? 2 : 1;
    const Complex part =
        terms * amplitude * std::visit([&](const auto& fade) -> Complex { return memory(fade); }, fades[k]);
    sum.value += part.real();
    sum.size += std::fabs(part.real()) + std::fabs(part.imag());
    if (rate.imag() == 0 || alpha >= 0) continue;
    const double trace =
        size_of_trace(part, terms * std::abs(amplitude) * internal::faded_exp(-rate.real() * alpha), rate);
    sum.size += std::abs(rate * alpha) / 16 * trace;
  }
}

std::vector<Complex> RollingKernels::rates() const {
  std::vector<Complex> result;
  for (const Memory& term : sheet_.normal.terms)
    if (term.rate != 0.0 && !(term.rate.imag() < 0)) result.push_back(term.rate);
  return result;
}

RollingKernels::Sized RollingKernels::normal_at(double alpha, const internal::SurfacePoint& at) const {
  Sized sum;
  sum.add(internal::kernel_at(internal::Kernel::I1, at, Accuracy()));
  add_terms(
      sum, alpha, fades_,
      [&](const auto& fade) { return internal::steady_memory(internal::Kernel::I1, at, fade, Accuracy()); },
      [](Complex part, double /*faded*/, Complex /*rate*/) { return std::abs(part); });
  sum.size += std::abs(slowest_root() * alpha) / 8 * slowest_amplitude_ *
              internal::faded_exp(slowest_root().imag() * std::fabs(alpha));
  return sum;
}

/// N multiplies I3 and its memory, theta2 multiplies I2 and its memory. I2 is pi/2 times the sign of alpha.
RollingKernels::Sized RollingKernels::tangential_at(double alpha, const internal::SurfacePoint& at) const {
  Sized sum;
  sum.add(internal::kernel_at(internal::Kernel::I3, at, Accuracy()));
  add_terms(
      sum, alpha, fades_along_,
      [&](const auto& fade) {
        return internal::steady_memory_beside_limit(internal::Kernel::I3, at, fade, Accuracy());
      },
      [](Complex /*part*/, double faded, Complex rate) { return 2 * pi * faded / std::abs(rate); });
  sum.add(-std::copysign(pi / 2, alpha) * sheet_.theta2_at_once);
  for (const auto& [amplitude, rate] : sheet_.theta2) {
    if (alpha >= 0) continue;
    sum.add(-pi * (amplitude * alpha * internal::phi1(-alpha * rate)).real());
    sum.size -= alpha / 16 * pi * std::abs(amplitude) * internal::faded_exp(-rate.real() * alpha);
  }
  return sum;
}

RollingKernels::Sized RollingKernels::strain_at(double alpha, const internal::SurfacePoint& at) const {
  Sized sum;
  sum.add(pi / 2 * sheet_stresses(alpha, 1, data::SheetLoad::normal).along);
  // The rounding error is that of the stress of the opposite half-plane, (2/pi) 2 alpha^2/(4 + alpha^2)^2.
  sum.size += 2 * std::pow(alpha / (4 + alpha * alpha), 2);
  add_terms(
      sum, alpha, fades_along_,
      [&](const auto& fade) {
        return internal::steady_memory_of_slope(internal::Kernel::I3, at, fade, Accuracy());
      },
      [](Complex /*part*/, double faded, Complex /*rate*/) { return 2 * pi * faded; });
  // Slopes for complex rates that are not large are differences of I3 minus its limit, at most pi/2, and rate times its
  // memory. By parts, the latter is at most the former and the change of I3 ahead, which is at most pi/2: 3 pi/2 in all.
  for (const auto& [amplitude, rate] : sheet_.normal.terms)
    if (rate.imag() != 0 && std::abs(rate) < internal::polynomial_from)
      sum.size += std::abs(amplitude) * 3 * pi / 2;
  for (const auto& [amplitude, rate] : sheet_.theta2) {
    if (alpha >= 0) continue;
    const Complex trace = -pi * amplitude * internal::faded_exp(-rate * alpha);
    sum.add(trace.real());
    sum.size += std::abs(rate * alpha) / 16 * std::abs(trace);
  }
  return sum;
}

Tractions::Kernel RollingKernels::normal() const {
  return for_both_parts(rates(), std::bind_front(&RollingKernels::normal_at, this));
}

Tractions::Kernel RollingKernels::along() const {
  if (fades_along_.empty()) fades_along_ = fades(internal::Kernel::I3);
  return for_both_parts(rates(), std::bind_front(&RollingKernels::tangential_at, this),
                        std::bind_front(&RollingKernels::strain_at, this));
}

Eigen::Index RollingKernels::functionals_ahead(bool whole) const {
  const auto of_terms = 2 * static_cast<Eigen::Index>(fades_.size());
  return whole ? 2 * of_terms + 1 : of_terms;
}

Eigen::MatrixXd RollingKernels::ahead_at(std::span<const double> alpha, bool whole) const {
  const Eigen::Index of_terms = functionals_ahead(false);
  Eigen::MatrixXd values =
      Eigen::MatrixXd::Zero(functionals_ahead(whole), static_cast<Eigen::Index>(alpha.size()));
  for (std::size_t i = 0; i < alpha.size(); ++i) {
    const internal::SurfacePoint at = point(alpha[i]);
    auto column = values.col(static_cast<Eigen::Index>(i));
    const auto set_terms = [&](Eigen::Index first, const auto& memory) {
      for (std::size_t k = 0; k < fades_.size(); ++k) {
        if (sheet_.normal.terms[k].rate.imag() < 0) continue;
        const Complex value = std::visit(memory, fades_[k]) / pi;
        column.segment<2>(first + 2 * static_cast<Eigen::Index>(k)) << value.real(), value.imag();
      }
    };
    set_terms(0, [&](const auto& fade) -> Complex {
      return internal::steady_memory(internal::Kernel::I1, at, fade, Accuracy());
    });
    if (!whole) continue;
    set_terms(of_terms, [&](const auto& fade) -> Complex {
      return internal::steady_memory_of_slope(internal::Kernel::I1, at, fade, Accuracy());
    });
    column(2 * of_terms) = internal::kernel_at(internal::Kernel::I1, at, Accuracy()) / pi;
  }
  return values;
}

/// I1 = -ln alpha + .., so that each memory contains ln alpha (e^(rate alpha) - 1)/rate.
Eigen::MatrixXd RollingKernels::factor_of_logarithm(const Eigen::ArrayXd& alpha) const {
  Eigen::MatrixXd factor = Eigen::MatrixXd::Zero(functionals_ahead(false), alpha.size());
  for (std::size_t k = 0; k < fades_.size(); ++k) {
    const auto set_rows = [&](auto rate) {
      for (Eigen::Index i = 0; i < alpha.size(); ++i) {
        const Complex value = alpha(i) * internal::phi1(-rate * alpha(i)) / pi;
        factor.col(i).segment<2>(2 * static_cast<Eigen::Index>(k)) << value.real(), value.imag();
      }
    };
    if (const Complex rate = sheet_.normal.terms[k].rate; rate.imag() == 0)
      set_rows(rate.real());
    else if (rate.imag() > 0)
      set_rows(rate);
  }
  return factor;
}

Eigen::MatrixXd RollingKernels::rest_at(const Eigen::ArrayXd& alpha) const {
  return ahead_at({alpha.data(), static_cast<std::size_t>(alpha.size())}, false) -
         factor_of_logarithm(alpha) * alpha.log().matrix().asDiagonal();
}

Eigen::MatrixXd RollingKernels::interpolated_rest(const Eigen::ArrayXd& alpha, double width) const {
  constexpr double spare = 1.1, nats_of_double = 37;
  constexpr double most_points = 40;  // with more, interpolation costs as much as it saves
  if (!(width <= kept_rest_.length && kept_rest_.length <= spare * spare * width)) {
    double fastest = 0;
    for (const Complex& rate : rates()) fastest = std::max(fastest, std::abs(rate));
    const double length = spare * width,
                 points = internal::points_of_analytic(length, fastest, nats_of_double);
    if (!(points <= most_points)) return rest_at(alpha);
    const auto count = static_cast<Eigen::Index>(std::ceil(points));
    kept_rest_ = {length, rest_at(internal::chebyshev_points(length, count))};
  }
  const auto& [length, values] = kept_rest_;
  return values * internal::interpolation(alpha, length, values.cols()).transpose();
}

Tractions::Kernel RollingKernels::ahead(bool whole) const {
  Tractions::Kernel kernel{static_cast<int>(functionals_ahead(whole)), Tractions::Kernel::FarAway::negligible,
                           rates(),
                           [this, whole](std::span<const double> alpha, Eigen::MatrixXd& on_p,
                                         Eigen::MatrixXd& on_q) { on_q = on_p = ahead_at(alpha, whole); }};
  // With layers, nearly every contact has a rate that is too large for this.
  if (!whole) {
    kernel.by_logarithm = [this](const Eigen::ArrayXd& alpha, double width) {
      return Tractions::Kernel::ByLogarithm{factor_of_logarithm(alpha), interpolated_rest(alpha, width)};
    };
  }
  return kernel;
}

}  // namespace nipref::fast
