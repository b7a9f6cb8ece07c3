#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/fast/nip/internal/stretch.hpp>
#include <nipref/fast/number/internal/exponential_integrals.hpp>
#include <nipref/fast/viscoelastic_nip/internal/rolling_kernels.hpp>

namespace nipref::fast {
namespace {

using Complex = std::complex<double>;
using internal::Two;

constexpr double pi = std::numbers::pi;

/// A kernel of one functional that is the same for both parts of the pressure.
template <class AtAlpha>
Tractions::Kernel for_both_parts(std::vector<double> lengths, const AtAlpha& at) {
  return {1, false, std::move(lengths),
          [at](std::span<const double> alpha, Eigen::MatrixXd& on_p, Eigen::MatrixXd& on_q) {
            on_p.resize(1, static_cast<Eigen::Index>(alpha.size()));
            for (std::size_t i = 0; i < alpha.size(); ++i) on_p(static_cast<Eigen::Index>(i)) = at(alpha[i]);
            on_q = on_p;
          }};
}

/// Nearer than any node that counts, the kernels' logarithms would overflow.
internal::SurfacePoint point(double alpha) {
  constexpr double nearest = 1e-299;
  return internal::surface_point({std::copysign(std::max(std::fabs(alpha), nearest), alpha), 0}, Accuracy());
}

}  // namespace

RollingKernels::RollingKernels(const RollingSheet& sheet, CountedKernels& kernels)
    : sheet_(sheet), kernels_(kernels) {
  for (const Memory& term : sheet.normal.terms) {
    fades_.push_back(term.rate.imag() == 0
                         ? internal::fade(Two{term.rate.real(), 0},
                                          {internal::Kernel::I1, internal::Kernel::I3}, Accuracy())
                         : internal::Fade{});
  }
}

template <class MemoryOf>
double RollingKernels::over_terms(const MemoryOf& memory) const {
  double sum = 0;
  for (std::size_t k = 0; k < fades_.size(); ++k) {
    const auto& [amplitude, rate] = sheet_.normal.terms[k];
    if (rate.imag() == 0) sum += amplitude.real() * memory(fades_[k], rate.real());
    if (rate.imag() > 0) sum += 2 * (amplitude * memory(rate, rate)).real();
  }
  return sum;
}

std::vector<double> RollingKernels::relaxation_lengths() const {
  std::vector<double> lengths;
  for (const Memory& term : sheet_.normal.terms)
    if (term.rate != 0.0) lengths.push_back(1 / std::abs(term.rate));
  return lengths;
}

Tractions::Kernel RollingKernels::elastic() const {
  return {1, true, {}, [this](std::span<const double> alpha, Eigen::MatrixXd& on_p, Eigen::MatrixXd& on_q) {
            const std::vector<double> i1 = kernels_.I1(alpha);
            on_p = Eigen::Map<const Eigen::RowVectorXd>(i1.data(), static_cast<Eigen::Index>(i1.size())) / pi;
            on_q = on_p;
          }};
}

Tractions::Kernel RollingKernels::normal() const {
  return for_both_parts(relaxation_lengths(), [this](double alpha) {
    const internal::SurfacePoint at = point(alpha);
    return (internal::kernel_at(internal::Kernel::I1, at, Accuracy()) +
            over_terms([&](const auto& fade, auto) {
              return internal::steady_memory(internal::Kernel::I1, at, fade, Accuracy());
            })) /
           pi;
  });
}

/// I3 and its memory act in N, I2 and its memory in theta2; I2 is pi/2 times the sign of alpha.
Tractions::Kernel RollingKernels::tangential() const {
  return for_both_parts(relaxation_lengths(), [this](double alpha) {
    const internal::SurfacePoint at = point(alpha);
    double sum =
        internal::kernel_at(internal::Kernel::I3, at, Accuracy()) + over_terms([&](const auto& fade, auto) {
          return internal::steady_memory_beside_limit(internal::Kernel::I3, at, fade, Accuracy());
        });
    sum -= std::copysign(pi / 2, alpha) * sheet_.theta2_at_once;
    for (const auto& [amplitude, rate] : sheet_.theta2) {
      if (alpha < 0) sum -= pi * (amplitude * alpha * internal::phi1(-alpha * rate)).real();
    }
    return sum / pi;
  });
}

Tractions::Kernel RollingKernels::strain() const {
  return for_both_parts(relaxation_lengths(), [this](double alpha) {
    const internal::SurfacePoint at = point(alpha);
    const double to_limit = pi / 4 - internal::kernel_at(internal::Kernel::I3, at, Accuracy());
    double sum = pi * stretch_over_pi(alpha) + over_terms([&](const auto& fade, auto rate) {
                   return to_limit + rate * internal::steady_memory_beside_limit(internal::Kernel::I3, at,
                                                                                 fade, Accuracy());
                 });
    for (const auto& [amplitude, rate] : sheet_.theta2) {
      if (alpha < 0) sum -= pi * (amplitude * std::exp(rate * alpha)).real();
    }
    return sum / pi;
  });
}

/// |I3| and |I2|/2 are at most pi/4; a memory is at most twice that over its length or to the place.
double RollingKernels::tangential_size(double farthest) const {
  double sum = 0.25 + std::fabs(sheet_.theta2_at_once) / 2;
  for (const std::vector<Memory>* memories : {&sheet_.normal.terms, &sheet_.theta2}) {
    for (const auto& [amplitude, rate] : *memories)
      sum += std::abs(amplitude) * (std::abs(rate) * farthest < 1 ? farthest : 1 / std::abs(rate));
  }
  return sum;
}

double RollingKernels::strain_size() const {
  double sum = 0.25;
  for (const Memory& memory : sheet_.normal.terms) sum += std::abs(memory.amplitude) / 2;
  for (const Memory& memory : sheet_.theta2) sum += std::abs(memory.amplitude);
  return sum;
}

/// `memory` of a point and a rate, real and imaginary part as two functionals.
template <class MemoryOf>
Tractions::Kernel RollingKernels::of_term(std::size_t term, const MemoryOf& memory) const {
  const Complex rate = sheet_.normal.terms[term].rate;
  return {2, true, relaxation_lengths(),
          [this, term, rate, memory](std::span<const double> alpha, Eigen::MatrixXd& on_p,
                                     Eigen::MatrixXd& on_q) {
            on_p = Eigen::MatrixXd::Zero(2, static_cast<Eigen::Index>(alpha.size()));
            for (std::size_t i = 0; i < alpha.size(); ++i) {
              const internal::SurfacePoint at = point(alpha[i]);
              const Complex value = rate.imag() == 0 ? memory(at, fades_[term]) : memory(at, rate);
              on_p(0, static_cast<Eigen::Index>(i)) = value.real() / pi;
              on_p(1, static_cast<Eigen::Index>(i)) = value.imag() / pi;
            }
            on_q = on_p;
          }};
}

Tractions::Kernel RollingKernels::ahead(std::size_t term) const {
  return of_term(term, [](const internal::SurfacePoint& at, const auto& rate) -> Complex {
    return internal::steady_memory(internal::Kernel::I1, at, rate, Accuracy());
  });
}

Tractions::Kernel RollingKernels::slope_ahead(std::size_t term) const {
  return of_term(term, [](const internal::SurfacePoint& at, const auto& rate) -> Complex {
    return internal::steady_memory_of_slope(at, rate, Accuracy());
  });
}

}  // namespace nipref::fast
