#pragma once
#include <functional>
#include <numbers>

#include <nipref/verify/solve/internal/solved_contact.hpp>
#include <nipref/verify/solve/solve.hpp>

namespace nipref::verify {

struct NipSize {
  double roller_radius;
  double first, last;  ///< ends of the contact, Y
  double accuracy;     ///< that the scene asks for
};

/// The size that data::Scale describes; the pressure is computed only if the size depends on it.
double nip_result_size(data::ResultId id, double y, const NipSize& nip,
                       const std::function<double()>& pressure_in_the_middle);

/// The factor by which data::Scale enlarges the size of a traction next to an end of the contact, 1 elsewhere.
double growth_next_to_end(double x, double first, double last, double accuracy);

/// The same for a half-space; `place` is an angle from the motion, or a position on the scene's line.
template <class Number>
double half_space_result_size(data::ResultId id, double place, double accuracy,
                              const SolvedContact<Number>& contact,
                              const std::function<double()>& compliance) {
  using data::Scale;
  switch (data::scene_result(id).scale) {
    case Scale::pressure:
    case Scale::shear: {
      const auto [first, last] = contact.profile_extent();
      return growth_next_to_end(place, first, last, accuracy) *
             value_of(contact.number(ResultId::peak_pressure));
    }
    case Scale::radian:
      return 180 / std::numbers::pi;
    case Scale::span_along:
      return value_of(contact.number(ResultId::span_along));
    case Scale::compliance:
      return compliance();
    default:
      return 0;
  }
}

}  // namespace nipref::verify
