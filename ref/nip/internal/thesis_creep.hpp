#pragma once
#include <optional>
#include <vector>

#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// The creep ratio of Grip::Creep::thesis, and the lowest and the highest of those around it that meet the conditions as
/// well, where the intervals tell these.
struct ThesisCreep {
  Interval chosen;
  std::optional<Interval> lower = {}, upper = {};
};

/// The loads are at_zero + creep per_creep, the normal ones before as many shear loads. Nothing if there is none, or if the
/// intervals do not tell which: otherwise it is proven, and goes with the loads continuously. (thesis, section 5.5)
std::optional<ThesisCreep> thesis_creep(const std::vector<Interval>& at_zero,
                                        const std::vector<Interval>& per_creep);

}  // namespace nipref::ref
