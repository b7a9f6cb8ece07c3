#pragma once

namespace nipref::data {

/// Friction between roller and sheet: none (complete slip, the thesis's Case B) or full (no slip anywhere, its
/// Case A). (thesis chapter II, conditions (iii) and (iv))
enum class Friction { none, full };

/// What line loads do with an elastic sheet on the roller: no friction at all (the thesis's Case B), or none of slip
/// (Case A) with a creep ratio, finite, that is given or chosen as the thesis does: of the least size for which no
/// normal load is negative, the shear loads of a side have one sign and their part of the normal load does not fall
/// outwards. (thesis 5.5)
struct Grip {
  enum class Creep { none, given, thesis } kind = Creep::none;
  double creep = 0;  ///< the given one
};

}  // namespace nipref::data
