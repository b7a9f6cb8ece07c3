#include <cmath>
#include <numbers>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/direction.hpp>

namespace nipref::ref {

SurfaceDirection::SurfaceDirection(const Exact& cosine, const Exact& sine)
    : cosines_([cosine, sine](mpfr_prec_t precision) {
        const Exact squared_norm(mpq_class(cosine.value() * cosine.value() + sine.value() * sine.value()));
        const Interval norm = sqrt(Interval(squared_norm, precision));
        return Cosines{Interval(cosine, precision) / norm, Interval(sine, precision) / norm};
      }) {
  if (cosine.sign() == 0 && sine.sign() == 0) {
    throw data::BadInput("direction", "(0, 0)", "must have a cosine or a sine that is not 0");
  }
}

SurfaceDirection SurfaceDirection::of_degrees(const Exact& degrees) {
  return SurfaceDirection(std::function<Cosines(mpfr_prec_t)>([degrees](mpfr_prec_t precision) {
    const Interval angle = Interval(mpq_class(degrees.value() / 180), precision) * Interval::pi(precision);
    return Cosines{cos(angle), sin(angle)};
  }));
}

double SurfaceDirection::degrees() const {
  const auto [cosine, sine] = at(64);
  return std::atan2(mpfi_get_d(sine.get()), mpfi_get_d(cosine.get())) * 180 / std::numbers::pi;
}

Interval cosine_between(const SurfaceDirection& a, const SurfaceDirection& b, mpfr_prec_t precision) {
  const auto x = a.at(precision);
  const auto y = b.at(precision);
  return x.cosine * y.cosine + x.sine * y.sine;
}

}  // namespace nipref::ref
