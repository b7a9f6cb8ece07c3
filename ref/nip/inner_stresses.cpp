#include <nipref/ref/nip/inner_stresses.hpp>
#include <nipref/ref/number/enclosure.hpp>

namespace nipref::ref {
namespace {

/// Of the middle and of the radius of Mohr's circle.
Estimate of_circle(const InnerStresses& of, long middles, long radii) {
  const Interval across = interval_of(of.across), along = interval_of(of.along);
  const Interval radius = sqrt(square((across - along) / 2) + square(interval_of(of.shear)));
  Estimate result = enclosure_of(middles * (across + along) / 2 + radii * radius, of.across.digits);
  result.proven = of.across.proven && of.along.proven && of.shear.proven;
  return result;
}

}  // namespace

Estimate InnerStresses::maximum_shear() const { return of_circle(*this, 0, 1); }
Estimate InnerStresses::highest() const { return of_circle(*this, 1, 1); }
Estimate InnerStresses::lowest() const { return of_circle(*this, 1, -1); }

}  // namespace nipref::ref
