#pragma once
#include <cmath>
#include <utility>

#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// A direction in the surface of a half-space, known exactly by its angle in degrees.
class SurfaceDirection {
 public:
  static SurfaceDirection of_degrees(const Exact& degrees) { return SurfaceDirection(degrees); }

  struct Cosines {
    Interval cosine, sine;
  };
  [[nodiscard]] Cosines at(mpfr_prec_t precision) const {
    const Interval angle = Interval(mpq_class(degrees_.value() / 180), precision) * Interval::pi(precision);
    return {cos(angle), sin(angle)};
  }

  /// The angle to rounding, from -180 to 180.
  [[nodiscard]] double degrees() const { return std::remainder(degrees_.approximate(), 360); }

 private:
  explicit SurfaceDirection(Exact degrees) : degrees_(std::move(degrees)) {}

  Exact degrees_;
};

/// The cosine of the angle between two directions.
inline Interval cosine_between(const SurfaceDirection& a, const SurfaceDirection& b, mpfr_prec_t precision) {
  const auto x = a.at(precision), y = b.at(precision);
  return x.cosine * y.cosine + x.sine * y.sine;
}

}  // namespace nipref::ref
