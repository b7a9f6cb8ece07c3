#include <algorithm>
#include <cmath>
#include <string>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/viscoelastic_nip/internal/sheet.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads_displacements.hpp>

namespace nipref::fast {

using data::BadInput;

struct ViscoelasticLineLoadSurface::Implementation {
  ViscoelasticLineLoads loads;
  double half_thickness;
  double start;  ///< of the loads: where the leading end was, half-thicknesses ahead of it
  ViscoelasticSheet sheet;

  /// The sum of each load's displacement(t, T, t0) for the point that is at Y at the time t, with lengths in
  /// half-thicknesses and times in half-thickness/speed.
  template <class Displacement>
  [[nodiscard]] double sum(double y, const Displacement& displacement) const {
    const double t = time_at(y);
    double sum = 0;
    for (std::size_t j = 0; j < loads.loads.size(); ++j) {
      if (y == position(j)) throw BadInput("y", y, "must not be the place of a line load");
      // What the load is ahead of the centres, the pinned point has been passed by.
      const double T = t + (y - position(j)) / half_thickness;
      const double t0 = t - position(j) / half_thickness;
      sum += loads.loads[j] * displacement(t, T, t0);
    }
    return sum;
  }

  [[nodiscard]] double normal(double y) const {
    return sum(y, [&](double t, double T, double) { return sheet.normal_displacement(t, T); });
  }
  /// Against a point of the middle plane.
  [[nodiscard]] double tangential(double y) const {
    return sum(y, [&](double t, double T, double t0) { return sheet.tangential_displacement(t, T, t0); });
  }

  /// Since the start.
  [[nodiscard]] double time_at(double y) const {
    const double t = start + (loads.leading_length - y) / half_thickness;
    if (!(std::isfinite(y) && t >= 0))
      throw BadInput("y", y, "must be finite, and not ahead of where the leading end started");
    return t;
  }
  [[nodiscard]] double position(std::size_t j) const {
    return loads.leading_length - (static_cast<double>(j) + 0.5) * loads.element_width();
  }
};

namespace {

void check(const data::ViscoelasticNip& nip, const ViscoelasticLineLoads& loads,
           const ViscoelasticLineLoadMethod& method) {
  nip.check();
  method.check();
  const auto elements = static_cast<std::size_t>(method.leading_elements + method.trailing_elements);
  if (loads.loads.size() != elements) {
    throw BadInput("loads.loads.size()", std::to_string(loads.loads.size()),
                   "must be the method's number of elements, " + std::to_string(elements));
  }
}

}  // namespace

ViscoelasticLineLoadSurface::ViscoelasticLineLoadSurface(const data::ViscoelasticNip& nip,
                                                         const ViscoelasticLineLoads& loads,
                                                         const ViscoelasticLineLoadMethod& method) {
  check(nip, loads, method);
  implementation_ = std::make_shared<const Implementation>(
      Implementation{loads, nip.half_thickness(), method.approach,
                     ViscoelasticSheet(nip, method.residue_terms, method.smallest_term)});
}

double ViscoelasticLineLoadSurface::normal_displacement(double y) const { return implementation_->normal(y); }

double ViscoelasticLineLoadSurface::tangential_displacement(double y) const {
  return implementation_->tangential(y) - implementation_->tangential(0);
}

double element_pressure(const ViscoelasticLineLoads& loads, double y) {
  if (!std::isfinite(y)) throw BadInput("y", y, "must be finite");
  // A place on a border counts to the trailing element, as far as rounding knows borders.
  const double border = 0x1p-50 * loads.leading_length;
  const double from_end = loads.leading_length - y + border;
  if (loads.loads.empty() || from_end < 0 || y < -loads.trailing_length - border) return 0;
  const auto element = static_cast<std::size_t>(from_end / loads.element_width());
  return loads.loads[std::min(element, loads.loads.size() - 1)] / loads.element_width();
}

}  // namespace nipref::fast
