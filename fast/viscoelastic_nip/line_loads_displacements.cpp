#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/memory/moving_load.hpp>
#include <nipref/fast/memory/plain_moving_load.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads_displacements.hpp>

namespace nipref::fast {
namespace {

using data::BadInput;

/// In half-thicknesses, and times in half-thickness/speed.
class Surface {
 public:
  Surface(const data::ViscoelasticNip& nip, const ViscoelasticLineLoads& loads,
          const ViscoelasticLineLoadMethod& method)
      : nip_(nip), loads_(loads), method_(method), half_thickness_(nip.half_thickness()) {
    nip.check();
    method.check();
    const auto elements = static_cast<std::size_t>(method.leading_elements + method.trailing_elements);
    if (loads.loads.size() != elements) {
      throw BadInput("loads.loads.size()", std::to_string(loads.loads.size()),
                     "must be the method's number of elements, " + std::to_string(elements));
    }
  }

  /// u(t, T) of each load's `displacement`, for the point that is at Y at the time t.
  template <class Displacement>
  [[nodiscard]] double sum(double y, const Displacement& displacement) const {
    const double t = time_at(y);
    double sum = 0;
    for (std::size_t j = 0; j < loads_.loads.size(); ++j) {
      if (y == position(j)) throw BadInput("y", y, "must not be the place of a line load");
      // What the load is ahead of the centres, the pinned point has been passed by.
      const double T = t + (y - position(j)) / half_thickness_;
      const double t0 = t - position(j) / half_thickness_;
      sum += loads_.loads[j] * displacement(t, T, t0);
    }
    return sum;
  }

  [[nodiscard]] double normal(double y) const {
    if (method_.residue_terms > 0) {
      const PlainMovingLoad load(nip_.material, nip_.speed, half_thickness_, method_.residue_terms);
      return sum(y, [&](double t, double T, double) { return load.normal_displacement(t, T); });
    }
    const MovingLoad load(nip_.material, nip_.speed, half_thickness_);
    const double unit = half_thickness_ / nip_.speed;
    return sum(y, [&](double t, double T, double) { return load.normal_displacement(t * unit, T * unit); });
  }

  /// Against a point of the middle plane.
  [[nodiscard]] double tangential(double y) const {
    if (method_.residue_terms > 0) {
      const PlainMovingLoad load(nip_.material, nip_.speed, half_thickness_, method_.residue_terms);
      return sum(y, [&](double t, double T, double t0) { return load.tangential_displacement(t, T, t0); });
    }
    const MovingLoad load(nip_.material, nip_.speed, half_thickness_);
    const double unit = half_thickness_ / nip_.speed;
    return sum(y, [&](double t, double T, double t0) {
      return load.tangential_displacement(t * unit, T * unit, t0 * unit);
    });
  }

 private:
  /// Since the start, when the leading end was `approach` away from the point.
  [[nodiscard]] double time_at(double y) const {
    const double t = method_.approach + (loads_.leading_length - y) / half_thickness_;
    if (!(std::isfinite(y) && t >= 0))
      throw BadInput("y", y, "must be finite, and not ahead of where the leading end started");
    return t;
  }
  [[nodiscard]] double position(std::size_t j) const {
    return loads_.leading_length - (static_cast<double>(j) + 0.5) * loads_.element_width();
  }

  const data::ViscoelasticNip& nip_;
  const ViscoelasticLineLoads& loads_;
  const ViscoelasticLineLoadMethod& method_;
  double half_thickness_;
};

}  // namespace

double element_pressure(const ViscoelasticLineLoads& loads, double y) {
  if (!std::isfinite(y)) throw BadInput("y", y, "must be finite");
  if (loads.loads.empty() || y > loads.leading_length || y < -loads.trailing_length) return 0;
  const auto element = static_cast<std::size_t>((loads.leading_length - y) / loads.element_width());
  return loads.loads[std::min(element, loads.loads.size() - 1)] / loads.element_width();
}

double normal_displacement(const data::ViscoelasticNip& nip, const ViscoelasticLineLoads& loads,
                           const ViscoelasticLineLoadMethod& method, double y) {
  return Surface(nip, loads, method).normal(y);
}

double tangential_displacement(const data::ViscoelasticNip& nip, const ViscoelasticLineLoads& loads,
                               const ViscoelasticLineLoadMethod& method, double y) {
  const Surface surface(nip, loads, method);
  return surface.tangential(y) - surface.tangential(0);
}

}  // namespace nipref::fast
