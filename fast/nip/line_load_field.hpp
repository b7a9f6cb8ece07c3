#pragma once
#include <span>
#include <vector>

#include <nipref/data/material/elastic.hpp>
#include <nipref/fast/nip/inner_stresses.hpp>

namespace nipref::fast {

/// A line load on both faces of the sheet at Y, force per unit width: it presses, and its shear acts along Y.
struct FaceLoad {
  double y, normal, shear;
};

// Inside a sheet under line loads: the sums of the loads' own fields (sheet/field.hpp), with errors of 0. BadInput for a
// place of a load on a face, where nothing is bounded, and for places that are out of the domains of InnerPoint.

std::vector<InnerStresses> line_load_stresses(std::span<const FaceLoad> loads, double half_thickness,
                                              std::span<const InnerPoint> points);

/// Of an elastic sheet, whose loads are symmetric about Y = 0: the normal ones even, the shear odd.
std::vector<InnerDisplacements> line_load_displacements(std::span<const FaceLoad> loads,
                                                        double half_thickness,
                                                        const data::ElasticMaterial& material,
                                                        std::span<const InnerPoint> points);

}  // namespace nipref::fast
