#pragma once
#include <memory>

#include <nipref/fast/viscoelastic_nip/line_loads.hpp>

namespace nipref::fast {

// Y is the distance along the sheet from the line through the rollers' centres, positive on the leading side,
// unit of length.

/// P_j over the width of its element, 0 outside the contact, unit of stress; Y finite, otherwise BadInput.
double element_pressure(const ViscoelasticLineLoads& loads, double y);

/// The surface under solved line loads: the moving load is made once for all places.
class ViscoelasticLineLoadSurface {
 public:
  /// `method`: what `loads` were solved with; BadInput for loads that are not as many as its elements.
  ViscoelasticLineLoadSurface(const data::ViscoelasticNip& nip, const ViscoelasticLineLoads& loads,
                              const ViscoelasticLineLoadMethod& method);

  /// Displacement towards the middle plane of the point that has come to Y since the loads started; BadInput
  /// for the place of a line load, and so far ahead that it is there before the start. (thesis 7.3)
  [[nodiscard]] double normal_displacement(double y) const;

  /// Displacement along Y of that point, relative to the surface at Y = 0; Y as above. (thesis 7.16)
  [[nodiscard]] double tangential_displacement(double y) const;

 private:
  struct Implementation;
  std::shared_ptr<const Implementation> implementation_;
};

}  // namespace nipref::fast
