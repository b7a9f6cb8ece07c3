#pragma once
#include <span>
#include <vector>

#include <nipref/data/material/elastic.hpp>
#include <nipref/ref/nip/inner_stresses.hpp>

namespace nipref::ref {

/// A line load on both faces of the sheet at Y, force per unit width: it presses, and its shear acts along Y.
struct FaceLoad {
  Estimate y, normal, shear;
};

// Inside a sheet under line loads: the sums of the loads' own proven fields (sheet/field.hpp). The errors are proven where the
// loads' are, but on the faces: ref/nip/README.md, The field under line loads. BadInput for a place of a load on a face, where
// nothing is bounded, and for places out of the domain of InnerPoint or more than 500 sheet thicknesses from a load.

std::vector<InnerStresses> line_load_stresses(std::span<const FaceLoad> loads, double half_thickness,
                                              std::span<const InnerPoint> points, int digits);

/// Of an elastic sheet, whose loads are symmetric about Y = 0: the normal ones even, the shear odd.
std::vector<InnerDisplacements> line_load_displacements(std::span<const FaceLoad> loads,
                                                        double half_thickness,
                                                        const data::ElasticMaterial& material,
                                                        std::span<const InnerPoint> points, int digits);

}  // namespace nipref::ref
