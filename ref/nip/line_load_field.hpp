#pragma once
#include <span>
#include <vector>

#include <nipref/data/material/elastic.hpp>
#include <nipref/ref/nip/inner_stresses.hpp>

namespace nipref::ref {

/// A line load on both faces of the sheet at Y, in force per unit width: `normal` presses, `shear` acts along Y.
struct FaceLoad {
  Estimate y, normal, shear;
};

// The field inside a sheet under line loads is the sum of the proven fields of the single loads (sheet/field.hpp). Its
// errors are proven where those of the loads are, except on the faces: ref/nip/README.md, The field under line loads.
// BadInput for the place of a load on a face, where nothing is bounded, and for places outside the domain of InnerPoint
// or more than 500 sheet thicknesses from a load.

std::vector<InnerStresses> line_load_stresses(std::span<const FaceLoad> loads, double half_thickness,
                                              std::span<const InnerPoint> points, int digits);

/// The loads must be symmetric about Y = 0: the normal loads even, the shear loads odd.
std::vector<InnerDisplacements> line_load_displacements(std::span<const FaceLoad> loads,
                                                        double half_thickness,
                                                        const data::ElasticMaterial& material,
                                                        std::span<const InnerPoint> points, int digits);

}  // namespace nipref::ref
