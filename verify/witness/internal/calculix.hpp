#pragma once
#include <nipref/verify/support/internal/common.hpp>

/// The finite-element program CalculiX (ccx) as an independent check of contacts, if it is installed.
namespace nipref::verify::calculix {

/// The prescribed displacements of the strip's surface for 0 <= y <= contact_end: u = indentation - y^2/(2 radius)
/// towards the middle plane and, if it sticks, v = creep y. The rest of the surface is free. The strip is symmetric
/// about the middle plane and about y = 0.
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

/// The solution by CalculiX, which runs in a temporary folder. Throws std::runtime_error if the program fails.
Response respond(const IndentedStrip& strip);

}  // namespace nipref::verify::calculix
