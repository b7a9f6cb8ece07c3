#pragma once
#include <nipref/data/problem/friction.hpp>
#include <nipref/verify/audit/internal/drawn_scene.hpp>
#include <nipref/verify/support/random.hpp>

namespace nipref::verify {

enum class RollingMaterial { elastic, standard_linear, prony, operators };

DrawnScene draw_elastic_nip(Random& random, data::Friction friction);
DrawnScene draw_rolling_nip(Random& random, RollingMaterial material);

template <data::Friction friction>
DrawnScene draw_elastic(Random& random) {
  return draw_elastic_nip(random, friction);
}
template <RollingMaterial material>
DrawnScene draw_rolling(Random& random) {
  return draw_rolling_nip(random, material);
}

}  // namespace nipref::verify
