#pragma once
#include <nipref/data/problem/half_space.hpp>
#include <nipref/verify/audit/internal/drawn_scene.hpp>
#include <nipref/verify/support/random.hpp>

namespace nipref::verify {

enum class Body { die, rolling_sphere, sphere };

DrawnScene draw_on_half_space(Random& random, Body body, data::ContourRule rule);

template <Body body, data::ContourRule rule>
DrawnScene draw_half_space(Random& random) {
  return draw_on_half_space(random, body, rule);
}

}  // namespace nipref::verify
