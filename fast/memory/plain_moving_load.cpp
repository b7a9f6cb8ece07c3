#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/material/functions.hpp>
#include <nipref/fast/memory/plain_moving_load.hpp>
#include <nipref/fast/number/internal/checks.hpp>
#include <nipref/fast/sheet/plain_series.hpp>
#include <nipref/fast/sheet/roots.hpp>

namespace nipref::fast {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;
constexpr Complex i(0, 1);

std::vector<Complex> roots(int terms) {
  internal::check_range("terms", terms, 1, most_residue_terms);
  std::vector<Complex> result;
  for (int n = 1; n <= terms; ++n) result.push_back(sheet_root(n));
  return result;
}

template <class Coefficient>
std::vector<Complex> each(const std::vector<Complex>& roots, Coefficient coefficient) {
  std::vector<Complex> result;
  std::ranges::transform(roots, std::back_inserter(result), coefficient);
  return result;
}

/// The integral of sign(w) e^(-rate (w - alpha)) from alpha to T > alpha.
double remembered_sign(double rate, double t, double T) {
  const double behind = std::clamp(t - T, 0.0, t), ahead = std::clamp(T, 0.0, t);
  return (std::expm1(-rate * behind) - std::exp(-rate * behind) * std::expm1(-rate * ahead)) / rate;
}

}  // namespace

PlainMovingLoad::PlainMovingLoad(const data::ViscoelasticMaterial& material, double speed,
                                 double half_thickness, int terms, double smallest_term)
    : roots_(roots(terms)), smallest_term_(smallest_term) {
  internal::check_positive("speed", speed);
  internal::check_positive("half_thickness", half_thickness);
  const data::MaterialFunctions functions = material_functions(material);
  const auto check_rate = [&](bool is_allowed, const char* why) {
    if (!is_allowed) throw data::BadInput("residue_terms", terms, why);
  };
  for (const data::MaterialFunction* function : {&functions.theta1, &functions.theta2}) {
    for (const data::RelaxationTerm& term : function->terms) {
      check_rate(term.rate.imag() == 0, "must be 0: the material has complex relaxation rates");
      check_rate(term.rate != 0.0,
                 "must be 0: the material is a fluid, and the thesis's sums divide by its rate, 0");
      const double rate = term.rate.real() * half_thickness / speed;
      if (std::ranges::find(rates_, rate) == rates_.end()) rates_.push_back(rate);
    }
  }
  theta1_ = memory(functions.theta1, speed, half_thickness);
  theta2_ = memory(functions.theta2, speed, half_thickness);
  both_ = theta1_;
  both_.instantaneous += theta2_.instantaneous;
  for (std::size_t r = 0; r < rates_.size(); ++r) both_.amplitude[r] += theta2_.amplitude[r];

  for (const double rate : rates_) {
    ahead_.push_back(each(roots_, [&](Complex z) { return 1.0 / (rate - i * z); }));
    behind_.push_back(each(roots_, [&](Complex z) { return 1.0 / (rate + i * z); }));
  }

  const auto kernel = [&](double parity, double constant, auto residue) {
    return Kernel{parity, constant, each(roots_, residue)};
  };
  normal_ = kernel(1, 0, [](Complex z) { return i * pi * std::pow(std::tanh(z), 2) / z; });
  tangential_ = kernel(-1, pi / 4, [](Complex z) { return pi / std::pow(std::cosh(z), 2); });
  sign_ = {-1, pi / 2, {}};
  pinned_theta2_ = kernel(-1, pi / 4, [](Complex z) { return pi * std::tanh(z) / (z * std::cosh(z)); });
  pinned_theta1_ = kernel(-1, pi / 4, [](Complex z) { return pi / std::cosh(z); });
}

PlainMovingLoad::Memory PlainMovingLoad::memory(const data::MaterialFunction& function, double speed,
                                                double half_thickness) const {
  Memory result{function.instantaneous, std::vector<double>(rates_.size())};
  for (const data::RelaxationTerm& term : function.terms) {
    const auto at = std::ranges::find(rates_, term.rate.real() * half_thickness / speed);
    result.amplitude[static_cast<std::size_t>(at - rates_.begin())] +=
        term.amplitude.real() * half_thickness / speed;
  }
  return result;
}

PlainMovingLoad::Sums PlainMovingLoad::sums(const Kernel& kernel, double distance) const {
  Sums result{0, std::vector<double>(rates_.size()), std::vector<double>(rates_.size())};
  for (std::size_t n = 0; n < kernel.residues.size(); ++n) {
    const double size = std::exp(-roots_[n].imag() * distance);
    if (size == 0) break;  // all further waves are 0, too
    const Complex wave = kernel.residues[n] * std::polar(size, roots_[n].real() * distance);
    result.kernel += wave.real();
    for (std::size_t r = 0; r < rates_.size(); ++r) {
      result.ahead[r] += (wave * ahead_[r][n]).real();
      result.behind[r] += (wave * behind_[r][n]).real();
    }
  }
  return result;
}

/// The last sum of (6.23), for a load that has moved `distance` since it passed the point.
double PlainMovingLoad::after(const Kernel& kernel, const Memory& memory, double distance) const {
  std::vector<double> faded;
  for (std::size_t r = 0; r < rates_.size(); ++r)
    faded.push_back(memory.amplitude[r] * std::exp(-rates_[r] * distance));
  const double smallest = kernel.parity > 0 ? pi * smallest_term_ * memory.instantaneous : 0;
  double sum = 0;
  for (std::size_t n = 0; n < kernel.residues.size(); ++n) {
    double term = 0;
    for (std::size_t r = 0; r < rates_.size(); ++r)
      term += faded[r] * (kernel.residues[n] * (ahead_[r][n] - kernel.parity * behind_[r][n])).real();
    sum += term;
    if (std::fabs(term) < smallest) break;
  }
  return sum;
}

/// theta * kernel: the elastic response and, for each rate, int_alpha^T e^(-rate (w - alpha)) kernel(w) dw.
double PlainMovingLoad::remembered(const Kernel& kernel, const Memory& memory, double t, double T,
                                   const Sums& at_alpha, const Sums& at_T) const {
  const bool behind = t > T;
  const double side = behind ? kernel.parity : 1;
  double sum = memory.instantaneous * side * (kernel.constant + at_alpha.kernel);
  for (std::size_t r = 0; r < rates_.size(); ++r) {
    if (memory.amplitude[r] == 0) continue;
    const double rate = rates_[r];
    const double faded = std::exp(-rate * t);
    double part = behind ? side * at_alpha.behind[r] : at_alpha.ahead[r];
    part -= T > 0 ? faded * at_T.ahead[r] : faded * side * at_T.behind[r];
    if (kernel.constant != 0) part += kernel.constant * remembered_sign(rate, t, T);
    sum += memory.amplitude[r] * part;
  }
  return behind && T > 0 ? sum + after(kernel, memory, t - T) : sum;
}

double PlainMovingLoad::remembered(const Kernel& kernel, const Memory& memory, double t, double T) const {
  return remembered(kernel, memory, t, T, sums(kernel, std::fabs(T - t)), sums(kernel, std::fabs(T)));
}

double PlainMovingLoad::normal_displacement(double t, double T, const Sums& at_alpha,
                                            const Sums& at_T) const {
  return remembered(normal_, both_, t, T, at_alpha, at_T) / pi;
}

double PlainMovingLoad::normal_displacement(double t, double T) const {
  return normal_displacement(t, T, normal_sums(std::fabs(T - t)), normal_sums(std::fabs(T)));
}

double PlainMovingLoad::tangential_displacement(double t, double T, double t0) const {
  return (remembered(tangential_, both_, t, T) - remembered(sign_, theta2_, t, T) +
          remembered(pinned_theta2_, theta2_, t, t0) - remembered(pinned_theta1_, theta1_, t, t0)) /
         pi;
}

}  // namespace nipref::fast
