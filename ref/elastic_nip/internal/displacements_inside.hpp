#pragma once
#include <span>
#include <vector>

#include <nipref/ref/elastic_nip/internal/nip_units.hpp>
#include <nipref/ref/nip/internal/contact_field.hpp>

namespace nipref::ref {

/// The displacements at each point; `uncertain`, dimensionless, as for ContactField::displacements_at.
inline std::vector<InnerDisplacements> displacements_inside(const ContactField& field, const NipUnits& units,
                                                            std::span<const InnerPoint> points,
                                                            const Float& uncertain) {
  const Float length = to_float(Exact(units.length)), unit = to_float(Exact(units.displacement));
  const FloatShares share{to_float(Exact(1 - units.beta)), to_float(Exact(units.beta))};
  std::vector<InnerDisplacements> displacements;
  for (const InnerPoint& point : points)
    displacements.push_back(field.displacements_at(checked_point(point, length), share, uncertain, unit));
  return displacements;
}

}  // namespace nipref::ref
