#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/material/functions.hpp>
#include <nipref/fast/memory/internal/fading.hpp>
#include <nipref/fast/memory/moving_load.hpp>
#include <nipref/fast/number/internal/checks.hpp>
#include <nipref/fast/number/internal/exponential_integrals.hpp>
#include <nipref/fast/sheet/internal/argument_checks.hpp>

namespace nipref::fast {
namespace {

using namespace internal;

using std::numbers::pi;

/// Distances are limited so that their products with a rate, and with each other, do not overflow.
constexpr double farthest = 1e100;

void check_way(const char* name, double time, Two way) {
  if (!(std::fabs(way.high) <= farthest))
    throw data::BadInput(name, time, "must be within 1e100 half_thickness/speed of both 0 and t");
}

/// One entry for each term of theta; the entries of complex rates stay empty.
std::vector<Fade> fades(const data::MaterialFunction& theta, Two time_unit,
                        std::initializer_list<Kernel> kernels, Accuracy accuracy) {
  std::vector<Fade> all;
  for (const data::RelaxationTerm& term : theta.terms)
    all.push_back(term.rate.imag() == 0 ? fade(Two{term.rate.real(), 0} * time_unit, kernels, accuracy)
                                        : Fade{});
  return all;
}

/// The sum over the terms of amplitude times memory(rate), with times in units of b/F0. For a conjugate pair of terms,
/// one term is evaluated and its real part doubled.
template <typename Memory>
double over_terms(const data::MaterialFunction& theta, const std::vector<Fade>& fades, Two time_unit,
                  Memory memory) {
  double sum = 0;
  for (std::size_t i = 0; i < theta.terms.size(); ++i) {
    const data::RelaxationTerm& term = theta.terms[i];
    if (term.rate.imag() == 0) {
      sum += term.amplitude.real() * time_unit.high * memory(fades[i]);
    } else if (term.rate.imag() > 0) {
      sum += 2 * (term.amplitude * time_unit.high * memory(term.rate * time_unit.high)).real();
    }
  }
  return sum;
}

}  // namespace

/// The load's path relative to one point: from `start`, the point's position relative to the load now, to `end`, its
/// position when the load started. The length is infinite, and `end` not used, if the load has always moved.
struct MovingLoad::LoadPath {
  Two length;
  SurfacePoint start;
  SurfacePoint end;

  /// The distance that the load has moved since it passed the point, or 0 if it has not passed.
  [[nodiscard]] double behind() const { return std::clamp(-start.at.high, 0.0, length.high); }
  [[nodiscard]] int sign() const { return (start.at.high > 0) - (start.at.high < 0); }

  template <typename Rate>
  auto memory(Kernel kernel, const Rate& rate, Accuracy accuracy) const {
    if (std::isinf(length.high)) return steady_memory(kernel, start, rate, accuracy);
    return internal::memory(kernel, start, end, length, rate, accuracy);
  }
};

namespace {

/// int_0^x e^(-rate w) dw.
template <typename Rate>
Rate integrated_decay(double x, Rate rate) {
  return std::isinf(x) ? 1.0 / rate : x * phi1(rate * x);
}

/// int_0^length e^(-rate w) sign(w - behind) dw. For infinite length and rate 0, where it diverges, 1/rate is left out.
Complex memory_of_sign(double behind, double length, Complex rate) {
  return integrated_decay(length, rate) - 2.0 * integrated_decay(behind, rate);
}
double memory_of_sign(double behind, double length, const Fade& fade) {
  const double rate = fade.rate.high;
  if (rate == 0 && std::isinf(length)) return -2 * behind;
  return integrated_decay(length, rate) - 2 * integrated_decay(behind, rate);
}

}  // namespace

struct MovingLoad::Fades {
  std::vector<Fade> normal, theta1, theta2;
};

MovingLoad::MovingLoad(const data::ViscoelasticMaterial& material, double speed, double half_thickness,
                       Accuracy accuracy)
    : functions_(material_functions(material)), normal_(functions_.normal_compliance()), accuracy_(accuracy) {
  check_positive("speed", speed);
  check_positive("half_thickness", half_thickness);
  way_per_time_ = Two{speed, 0} / half_thickness;
  time_unit_ = Two{half_thickness, 0} / speed;
  fades_ = std::make_shared<const Fades>(
      Fades{fades(normal_, time_unit_, {Kernel::I1}, accuracy),
            fades(functions_.theta1, time_unit_, {Kernel::I3, Kernel::I5}, accuracy),
            fades(functions_.theta2, time_unit_, {Kernel::I3, Kernel::I4}, accuracy)});
}

double MovingLoad::normal_displacement(double t, double T) const {
  check_not_negative("t", t);
  check_argument("T", T, Domain::finite);
  if (t == T) throw data::BadInput("T", T, "must differ from t: Un is infinite under the load");
  return normal_displacement(load_path("T", t, T));
}

double MovingLoad::tangential_displacement(double t, double T, double t0) const {
  check_not_negative("t", t);
  check_argument("T", T, Domain::finite);
  check_argument("t0", t0, Domain::finite);
  return tangential_displacement(load_path("T", t, T), load_path("t0", t, t0));
}

double MovingLoad::normal_displacement_after(double way, double alpha) const {
  check_argument("alpha", alpha, Domain::finite_nonzero);
  return normal_displacement(path_after(way, "alpha", alpha));
}

double MovingLoad::tangential_displacement_after(double way, double alpha, double eta) const {
  return tangential_displacement(path_after(way, "alpha", alpha), path_after(way, "eta", eta));
}

double MovingLoad::steady_normal_displacement(double alpha) const {
  check_argument("alpha", alpha, Domain::finite_nonzero);
  return normal_displacement(steady_path(alpha));
}

double MovingLoad::steady_tangential_displacement(double alpha, double eta) const {
  check_argument("alpha", alpha, Domain::finite);
  check_argument("eta", eta, Domain::finite);
  return tangential_displacement(steady_path(alpha), steady_path(eta));
}

MovingLoad::LoadPath MovingLoad::steady_path(double alpha) const {
  return {{std::numeric_limits<double>::infinity(), 0}, surface_point({alpha, 0}, accuracy_), {}};
}

MovingLoad::LoadPath MovingLoad::path_after(double way, const char* name, double alpha) const {
  check_not_negative("way", way);
  if (!(std::fabs(alpha) <= farthest && way <= farthest))
    throw data::BadInput(name, alpha, "must be, like the way, at most 1e100 half-thicknesses");
  return {{way, 0}, surface_point({alpha, 0}, accuracy_), surface_point(two_sum(way, alpha), accuracy_)};
}

MovingLoad::LoadPath MovingLoad::load_path(const char* name, double t, double T) const {
  const Two length = Two{t, 0} * way_per_time_, end = Two{T, 0} * way_per_time_;
  const Two start = two_sum(T, -t) * way_per_time_;
  check_way(name, T, start);
  check_way(name, T, end);
  return {length, surface_point(start, accuracy_), surface_point(end, accuracy_)};
}

double MovingLoad::normal_displacement(const LoadPath& load_path) const {
  double sum = normal_.instantaneous * kernel_at(Kernel::I1, load_path.start, accuracy_);
  if (load_path.length.high > 0) {
    sum += over_terms(normal_, fades_->normal, time_unit_,
                      [&](const auto& rate) { return load_path.memory(Kernel::I1, rate, accuracy_); });
  }
  return sum / pi;
}

double MovingLoad::tangential_displacement(const LoadPath& to_point, const LoadPath& to_pin) const {
  const double under_point = kernel_at(Kernel::I3, to_point.start, accuracy_);
  double sum =
      functions_.theta1.instantaneous * (under_point - kernel_at(Kernel::I5, to_pin.start, accuracy_)) +
      functions_.theta2.instantaneous *
          (under_point + kernel_at(Kernel::I4, to_pin.start, accuracy_) - pi / 2 * to_point.sign());
  if (to_point.length.high == 0) return sum / pi;
  sum += over_terms(functions_.theta1, fades_->theta1, time_unit_, [&](const auto& rate) {
    return to_point.memory(Kernel::I3, rate, accuracy_) - to_pin.memory(Kernel::I5, rate, accuracy_);
  });
  sum += over_terms(functions_.theta2, fades_->theta2, time_unit_, [&](const auto& rate) {
    return to_point.memory(Kernel::I3, rate, accuracy_) + to_pin.memory(Kernel::I4, rate, accuracy_) -
           pi / 2 * memory_of_sign(to_point.behind(), to_point.length.high, rate);
  });
  return sum / pi;
}

}  // namespace nipref::fast
