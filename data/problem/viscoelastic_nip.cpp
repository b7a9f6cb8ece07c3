#include <nipref/data/bad_input.hpp>
#include <nipref/data/magnitude.hpp>
#include <nipref/data/problem/viscoelastic_nip.hpp>

namespace nipref::data {

namespace {

/// What can be rolled. Where theta gives way to nothing at once, u' = rate u - amplitude I1 * p in the contact, with u
/// the parabola: the pressure answers a parabola's slope as well, and at the leading end, where the gap may open like a
/// power 3/2, it is infinite like an inverse root.
void check_gives_way_at_once(const MaterialFunction& function, const char* argument) {
  if (!(function.instantaneous > 0))
    throw BadInput(argument, function.instantaneous,
                   "must be > 0: under a roller a sheet that gives way to nothing at once has an infinite "
                   "pressure at the leading end of the contact");
}

/// Rolled steadily a fluid has an answer, the limit of slow rates; the solvers divide by rates.
void check_is_solid(const MaterialFunction& function, const char* argument) {
  if (function.is_fluid())
    throw BadInput(
        argument, 0,
        "must be > 0: a fluid under rollers is had as the limit of slow rates, such as 1e-12 speed "
        "over contact length");
}

}  // namespace

void ViscoelasticNip::check() const {
  check_magnitude("roller_radius", roller_radius);
  check_magnitude("sheet_thickness", sheet_thickness);
  check_magnitude("speed", speed);
  check_gives_way_at_once(material.theta1(), "theta1 instantaneous");
  check_gives_way_at_once(material.theta2(), "theta2 instantaneous");
  check_is_solid(material.theta1(), "theta1 rate");
  check_is_solid(material.theta2(), "theta2 rate");
}

}  // namespace nipref::data
