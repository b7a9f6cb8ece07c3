#pragma once
#include <map>
#include <optional>

/// An outside witness for contacts: the finite-element program CalculiX (ccx), where it is installed.
namespace nipref::verify::calculix {

/// What is prescribed of the strip's surface for 0 <= y <= contact_end: u = indentation - y^2/(2 radius)
/// towards the middle plane, and v = creep y where it sticks. The rest of the surface is free, and the strip
/// symmetric about the middle plane and about y = 0.
struct IndentedStrip {
  double young, poisson, half_thickness, contact_end, indentation, radius;
  std::optional<double> creep;
};

struct SurfaceDisplacement {
  double normal;      ///< towards the middle plane
  double tangential;  ///< along y
};

struct Response {
  double reaction;                                ///< of the prescribed nodes, against the indentation
  std::map<double, SurfaceDisplacement> surface;  ///< by y
};

bool is_installed();

/// What CalculiX makes of it, in a folder of its own that is gone afterwards. Throws std::runtime_error where the
/// program fails.
Response respond(const IndentedStrip& strip);

}  // namespace nipref::verify::calculix
