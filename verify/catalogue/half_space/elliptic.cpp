// The exact frictionless contact of a rigid body on an isotropic half-space.
#include <cmath>
#include <utility>

#include <nipref/fast/half_space/elliptic.hpp>
#include <nipref/ref/half_space/elliptic.hpp>
#include <nipref/verify/catalogue/half_space/internal/contact_entry.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

using fast::Accuracy;

fast::EllipticContact contact(Doubles x) { return {isotropic_surface(x[0], x[1]), {1, x[2]}}; }

/// Poisson's ratio, speed, curvature ratio.
Quantity elliptic_entry(std::string name, std::string definition, double promise) {
  Quantity entry = contact_entry(std::move(name), std::move(definition), "notes on brock2012 (31)", promise);
  entry.arguments = isotropic_arguments();
  entry.arguments.push_back({"curvature_ratio", ArgumentKind::positive, "1", {}});
  entry.audit_points = 6;
  draw_isotropic(entry, nearest_integrated, [](Random& random) {
    return Point{random.chance(0.3) ? 1 : random.log_uniform(1e-10, 1e10)};
  });
  return entry;
}

Quantity entry_axis_ratio() {
  Quantity entry = elliptic_entry(
      "ellipse.axis_ratio",
      "minor over major axis of the exact frictionless contact of a rigid die, curvature_ratio its curvature "
      "across over that along the motion",
      32);
  entry.by_ref = [](Exacts x, int digits) {
    return ref::elliptic_axis_ratio(exact_isotropic_surface(x[0], x[1]), x[2], digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) { return contact(x).axis_ratio().value; });
  return entry;
}

Quantity entry_stiffness() {
  Quantity entry = elliptic_entry(
      "ellipse.stiffness",
      "F/(mu sqrt(R) delta^(3/2)) of that contact, 1/R the mean of the two curvatures, delta the approach",
      32);
  entry.by_ref = [](Exacts x, int digits) {
    return ref::elliptic_stiffness(exact_isotropic_surface(x[0], x[1]), x[2], digits);
  };
  set_fast(entry, [](Doubles x, Accuracy) {
    return contact(x).for_approach(1).force.value * std::sqrt((1 + x[2]) / 2);
  });
  return entry;
}

}  // namespace

std::vector<Quantity> elliptic_contact_entries() { return {entry_axis_ratio(), entry_stiffness()}; }

}  // namespace nipref::verify
