#pragma once
#include <functional>

#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// A direction in the surface of a half-space, known exactly: by two numbers proportional to its cosine and
/// sine, or by its angle in degrees.
class SurfaceDirection {
 public:
  /// Cosine and sine may have any common factor; BadInput "direction" if both are 0.
  SurfaceDirection(const Exact& cosine, const Exact& sine);
  static SurfaceDirection of_degrees(const Exact& degrees);

  struct Cosines {
    Interval cosine, sine;
  };
  [[nodiscard]] Cosines at(mpfr_prec_t precision) const { return cosines_(precision); }

  /// The angle in degrees to rounding, from -180 to 180.
  [[nodiscard]] double degrees() const;

 private:
  explicit SurfaceDirection(std::function<Cosines(mpfr_prec_t)> cosines) : cosines_(std::move(cosines)) {}

  std::function<Cosines(mpfr_prec_t)> cosines_;
};

/// The cosine of the angle between two directions.
Interval cosine_between(const SurfaceDirection& a, const SurfaceDirection& b, mpfr_prec_t precision);

}  // namespace nipref::ref
