#pragma once
#include <algorithm>

#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/number/float.hpp>

/// The response of an isotropic half-space with mu = 1, written out: (brock2012 18a) and its counterpart for shear.
inline nipref::ref::SurfaceAnswer isotropic_surface(double poisson, double speed) {
  using namespace nipref;
  using ref::Exact;
  using ref::Float;
  return [=](const Exact& degrees, int digits) -> ref::LineAnswer {
    const ref::WorkingDigits working(2 * digits + 20);
    const mpq_class from_90 = 90 - abs(degrees.value());
    const Float cosine = sin(ref::to_float(Exact(from_90)) * ref::pi() / 180);
    const Float nu = poisson,
                X = std::max(Float(speed * cosine * speed * cosine), Float(pow(Float(10), -digits)));
    const Float wS = sqrt(1 - X), wD = sqrt(1 - X * (1 - 2 * nu) / (2 - 2 * nu));
    const Float R = 4 * wS * wD - (2 - X) * (2 - X), minus_N = 2 - X - 2 * wS * wD;
    return {X * wD / R, minus_N / R, Float(0), X * wS / R};
  };
}
